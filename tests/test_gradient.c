/* test_gradient.c - gradient.h, derivatives fitted at the vertices: they are exact on polynomials,
 * converge with the right order, and keep their limits. */
#include "cmock.h"

#ifdef _OPENMP
#include <omp.h>
#endif

#include "charted.h"

/* The five derivatives of a jet, three coordinates each, as one array of 15 numbers. */
static const double *
flat(const Jet *j)
{
	return (const double *)j;
}

/* The largest error over all vertices of the first derivatives, e[0], and of the second, e[1].  The
 * u and v of the chart were divided by su and sv, so its derivatives are converted to the original u
 * and v first. */
static void
errors(const Charted *s, Surface *f, double su, double sv, double e[2])
{
	double unit[5] = { su, sv, su*su, su*sv, sv*sv }, phi[3];
	int i, k;
	Jet j;

	e[0] = e[1] = 0;
	for (i = 0; i < s->m.nv; i++) {
		f(s->u[i]*su, s->v[i]*sv, phi, &j);
		for (k = 0; k < 15; k++) {
			double d = fabs(flat(&s->jet[i])[k]/unit[k/3] - flat(&j)[k]);

			e[k >= 6] = d <= e[k >= 6] ? e[k >= 6] : d;
		}
	}
}

/* The derivatives of cubics are exact on random triangles, for any unit and aspect ratio of u and
 * v. */
static void
cubics_are_exact(void **state)
{
	static const double scale[][2] = { { 1, 1 }, { 1e-9, 1e-9 }, { 1e9, 1e9 }, { 1, 300 }, { 1e-3, 10 } };
	double e[2];
	unsigned k;
	int i;

	(void)state;
	for (k = 0; k < sizeof scale/sizeof *scale; k++) {
		Charted s = charted_random(600, 7 + k);

		charted_place(&s, cubic);
		for (i = 0; i < s.m.nv; i++)
			s.u[i] /= scale[k][0], s.v[i] /= scale[k][1];
		charted_fit(&s);
		assert_int_equal(s.low, 0);
		assert_int_equal(s.limited, 0);
		errors(&s, cubic, scale[k][0], scale[k][1], e);
		assert_true(e[0] < 1e-9);
		assert_true(e[1] < 1e-6);
		charted_free(&s);
	}
}

/* At the worst vertex, boundary vertices included, first derivatives converge with third order and
 * second derivatives with second order. */
static void
orders(void **state)
{
	Charted s = charted_even(500), t = charted_even(32000);
	double e[2], f[2];

	(void)state;
	charted_place(&s, wavy);
	charted_place(&t, wavy);
	charted_fit(&s);
	charted_fit(&t);
	errors(&s, wavy, 1, 1, e);
	errors(&t, wavy, 1, 1, f);
	assert_int_equal(s.low + s.limited + t.low + t.limited, 0);
	assert_true(log(e[0]/f[0])/log(8) > 2.6);
	assert_true(log(e[1]/f[1])/log(8) > 1.6);
	assert_true(f[0] < 1e-3 && f[1] < 0.2);
	charted_free(&s);
	charted_free(&t);
}

/* With too few points for a cubic, a polynomial of lower degree is fitted, here a linear one; a
 * mesh without vertices is no error. */
static void
small_meshes(void **state)
{
	Stars stars;
	double xyz[12] = { 0, 0, 0,  2, 0, 1,  2, 3, 2,  0, 3, 1 }, uv[8] = { 0, 0, 2, 0, 2, 3, 0, 3 };
	int tri[6] = { 0, 1, 2, 0, 2, 3 }, i;
	Mesh two = { 4, 2, xyz, tri }, none = { 0, 0, xyz, tri };
	Charted s = charted_of(two, uv);

	(void)state;
	charted_fit(&s);
	assert_int_equal(s.low, 4);
	assert_int_equal(s.limited, 0);
	for (i = 0; i < 4; i++) {
		const double want[2][3] = { { 1, 0, 0.5 }, { 0, 1, 1/3.0 } };

		assert_true(distance3(s.jet[i].u, want[0]) < 1e-13);
		assert_true(distance3(s.jet[i].v, want[1]) < 1e-13);
		assert_true(norm3(s.jet[i].uu) + norm3(s.jet[i].uv) + norm3(s.jet[i].vv) < 1e-13);
	}
	assert_int_equal(stars_init(&stars, &none, s.u, s.v), 0);
	gradient_fit(&stars, &none, s.u, s.v, NULL, s.jet);
	stars_free(&stars);
	free(s.u), free(s.v), free(s.jet);
}

/* If all points lie on one line of the (u,v) plane, the derivative along it is right and the
 * derivative across it is 0. */
static void
collinear_points(void **state)
{
	Charted s = charted_random(300, 3);
	double along[3], across[3];
	int i, c;

	(void)state;
	for (i = 0; i < s.m.nv; i++) {
		s.v[i] = -2*s.u[i];
		for (c = 0; c < 3; c++)
			s.m.xyz[3*i + c] = (c + 1)*s.u[i];
	}
	charted_fit(&s);
	for (i = 0; i < s.m.nv; i++)
		for (c = 0; c < 3; c++) {
			along[c] = s.jet[i].u[c] - 2*s.jet[i].v[c] - (c + 1);
			across[c] = 2*s.jet[i].u[c] + s.jet[i].v[c];
			assert_true(fabs(along[c]) + fabs(across[c]) < 1e-9);
		}
	charted_free(&s);
}

/* Three rows of points that are not quite straight hardly determine the third derivative across
 * them.  The error of that derivative must not spoil the others. */
static void
thin_strip(void **state)
{
	enum { N = 40 };
	Charted s = charted_random(3*N, 1);
	uint64_t seed = 2;
	double e[2];
	int i, f = 0;

	(void)state;
	for (i = 0; i < 3*N; i++) {
		s.u[i] = 0.02*(i/3);
		s.v[i] = 0.02*(i%3) + 1e-8*rng_unit(&seed);
		if (i%3 == 2 || i/3 == N - 1)
			continue;
		memcpy(&s.m.tri[f], (int[]){ i, i + 3, i + 4, i, i + 4, i + 1 }, 6*sizeof(int));
		f += 6;
	}
	s.m.nf = f/3;
	charted_place(&s, wavy);
	charted_fit(&s);
	assert_int_equal(s.low, 3*N);
	assert_int_equal(s.limited, 0);
	errors(&s, wavy, 1, 1, e);
	assert_true(e[0] < 0.01 && e[1] < 0.5);
	charted_free(&s);
}

/* On degenerate input the derivatives keep the limits stated in gradient.h.  Many fits exceed the
 * limits at first; most of these are scaled down, not set to 0. */
static void
limits_hold(void **state)
{
	uint64_t seed;
	int t, k, c, dropped;

	(void)state;
	for (seed = 1; seed <= 20; seed++) {
		Charted s = charted_rubbish(seed);

		charted_fit(&s);
		assert_true(s.limited > 20);
		for (t = 0; t < 9*s.m.nf; t++) {
			int i = s.m.tri[t/3], j = s.m.tri[t/9*3 + t%3];
			double du = s.u[j] - s.u[i], dv = s.v[j] - s.v[i], bend[3], turn[3];
			double most = GRADIENT_BEND*charted_longest(&s.m, t/9)*(1 + 1e-9) + 1e-15;
			const Jet *q = &s.jet[i];

			for (c = 0; c < 3; c++) {
				bend[c] = q->u[c]*du + q->v[c]*dv - (s.m.xyz[3*j + c] - s.m.xyz[3*i + c]);
				turn[c] = (q->uu[c]*du*du + 2*q->uv[c]*du*dv + q->vv[c]*dv*dv)/8;
			}
			assert_true(norm3(bend) <= most && norm3(turn) <= most);
		}
		for (dropped = 0, t = 0; t < s.m.nv; t++) {
			dropped += norm3(s.jet[t].u) + norm3(s.jet[t].v) == 0;
			for (k = 0; k < 15; k++)
				assert_true(isfinite(flat(&s.jet[t])[k]));
		}
		assert_true(dropped < s.limited/4);
		charted_free(&s);
	}
}

/* The conformal map z -> z^2, whose derivative vanishes at the corner 0. */
static void
square(double u, double v, double phi[3], Jet *j)
{
	phi[0] = u*u - v*v, phi[1] = 2*u*v, phi[2] = 0;
	*j = (Jet){ { 2*u, 2*v, 0 }, { -2*v, 2*u, 0 }, { 2, 0, 0 }, { 0, 2, 0 }, { -2, 0, 0 } };
}

/* On z^2 the derivatives are exact and not limited.  On smooth surfaces they are not limited, even
 * with few triangles. */
static void
smooth_surfaces_are_not_limited(void **state)
{
	static const char *const kind[] = { "cap", "mercator", "cylinder", "catenoid", "torus", "enneper" };
	Charted s = charted_even(300);
	double e[2], *uv;
	unsigned k;
	int n;

	(void)state;
	charted_place(&s, square);
	charted_fit(&s);
	assert_int_equal(s.limited, 0);
	errors(&s, square, 1, 1, e);
	assert_true(e[0] + e[1] < 1e-9);
	charted_free(&s);
	for (k = 0; k < sizeof kind/sizeof *kind; k++)
		for (n = 60; n < 5000; n *= 4) {
			Synth y;
			Mesh m;

			assert_int_equal(synth_init(&y, kind[k]), 0);
			assert_int_equal(synth_mesh(&y, n, 2, &m, &uv), 0);
			s = charted_of(m, uv);
			charted_fit(&s);
			assert_int_equal(s.limited, 0);
			charted_free(&s);
			free(uv);
		}
}

/* Adds a vertex in triangle f at the share `near` of the way from its first corner to its middle. */
static void
add_near_vertex(Charted *s, int f, double near)
{
	int n = s->m.nv++, *tri, c[3], k;

	s->m.tri = realloc(s->m.tri, 3*(s->m.nf + 2)*sizeof *s->m.tri);
	s->m.xyz = realloc(s->m.xyz, 3*(n + 1)*sizeof *s->m.xyz);
	s->u = realloc(s->u, (n + 1)*sizeof *s->u);
	s->v = realloc(s->v, (n + 1)*sizeof *s->v);
	s->jet = realloc(s->jet, (n + 1)*sizeof *s->jet);
	assert_true(s->m.tri && s->m.xyz && s->u && s->v && s->jet);
	tri = s->m.tri;
	memcpy(c, &tri[3*f], sizeof c);
	s->u[n] = (1 - near)*s->u[c[0]] + near/3*(s->u[c[0]] + s->u[c[1]] + s->u[c[2]]);
	s->v[n] = (1 - near)*s->v[c[0]] + near/3*(s->v[c[0]] + s->v[c[1]] + s->v[c[2]]);
	for (k = 0; k < 3; k++)
		memcpy(&tri[3*(k ? s->m.nf + k - 1 : f)], (int[]){ c[k], c[(k+1)%3], n }, 3*sizeof *tri);
	s->m.nf += 2;
}

/* The difference quotient of two points that nearly coincide is mostly error; so such a neighbour
 * changes no derivatives, even if it is a little out of place. */
static void
ignores_near_duplicates(void **state)
{
	Charted s = charted_even(500), t = charted_even(500);
	int f = s.m.nf/2, i = s.m.tri[3*f], k;

	(void)state;
	add_near_vertex(&t, f, 1e-7);
	charted_place(&s, wavy);
	charted_place(&t, wavy);
	t.m.xyz[3*s.m.nv + 2] += 1e-7;
	charted_fit(&s);
	charted_fit(&t);
	for (k = 0; k < 15; k++)
		assert_true(fabs(flat(&s.jet[i])[k] - flat(&t.jet[i])[k]) < (k < 6 ? 1e-2 : 1));
	charted_free(&s);
	charted_free(&t);
}

static void
follows_motion_and_scale(void **state)
{
	Charted s = charted_random(500, 5), t = charted_random(500, 5);
	double want[3];
	int i, k;

	(void)state;
	charted_place(&s, wavy);
	charted_place(&t, wavy);
	for (i = 0; i < t.m.nv; i++)
		charted_move(&t.m.xyz[3*i], 1);
	charted_fit(&s);
	charted_fit(&t);
	for (i = 0; i < s.m.nv; i++)
		for (k = 0; k < 15; k += 3) {
			memcpy(want, flat(&s.jet[i]) + k, sizeof want);
			charted_move(want, 0);
			assert_true(distance3(flat(&t.jet[i]) + k, want) < 1e-8*(CHARTED_SIZE + norm3(want)));
		}
	assert_int_equal(s.limited, t.limited);
	charted_free(&s);
	charted_free(&t);
}

/* The derivatives are right at a vertex of very many triangles, and 0 at a vertex of none. */
static void
vertex_of_many_triangles(void **state)
{
	enum { N = 20000 };
	Charted s = charted_random(N + 2, 1);
	double e[2];
	int i;

	(void)state;
	for (s.m.nf = N - 1, i = 1; i <= N; i++) {
		double t = 3.0*i/N, r = 1 + 0.3*sin(40*t);

		s.u[i] = 0.7 + r*cos(t), s.v[i] = 0.5 + r*sin(t);
		s.m.tri[3*i - 3] = 0, s.m.tri[3*i - 2] = i, s.m.tri[3*i - 1] = i < N ? i + 1 : N;
	}
	s.u[0] = 0.7, s.v[0] = 0.5;
	charted_place(&s, square);
	charted_fit(&s);
	assert_true(norm3(s.jet[N + 1].u) + norm3(s.jet[N + 1].vv) == 0);
	s.m.nv = 1;
	errors(&s, square, 1, 1, e);
	assert_true(e[0] + e[1] < 1e-9);
	charted_free(&s);
}

static void
same_for_any_number_of_threads(void **state)
{
#ifdef _OPENMP
	Charted s = charted_random(3000, 9);
	Jet *one = malloc(s.m.nv*sizeof *one);
	int n, most = omp_get_max_threads();

	(void)state;
	assert_non_null(one);
	charted_place(&s, wavy);
	omp_set_num_threads(1);
	charted_fit(&s);
	memcpy(one, s.jet, s.m.nv*sizeof *one);
	for (n = 2; n < 6; n++) {
		omp_set_num_threads(n);
		charted_fit(&s);
		assert_memory_equal(one, s.jet, s.m.nv*sizeof *one);
	}
	omp_set_num_threads(most);
	free(one);
	charted_free(&s);
#else
	(void)state;
	skip();
#endif
}

/* At a vertex of many triangles only some of them are used.  Which ones depends on the chart, not
 * on the numbering of the triangles. */
static void
hub_does_not_depend_on_numbering(void **state)
{
	enum { N = 40, NF = N - 1 };
	double xyz[3*(N + 1)], u[N + 1], v[N + 1];
	int tri[3*NF], other[3*NF], i, c;
	unsigned char wanted[N + 1];
	Jet jet[2][N + 1];
	Stars stars;
	int k;

	(void)state;
	for (i = 0; i <= N; i++) {
		double r = i == N ? 0 : 1 + 0.3*sin(7.0*i), a = 5.0*i/N;

		xyz[3*i] = r*cos(a), xyz[3*i+1] = r*sin(a), xyz[3*i+2] = 0.2*cos(3.0*i);
		u[i] = 0.5 + 0.3*xyz[3*i], v[i] = 0.5 + 0.3*xyz[3*i+1] + 0.01*i/N;
	}
	for (i = 0; i < NF; i++) {
		memcpy(&tri[3*i], (int[]){ i, i + 1, N }, 3*sizeof *tri);
		memcpy(&other[3*(NF - 1 - i)], (int[]){ i + 1, N, i }, 3*sizeof *tri);
	}
	for (k = 0; k < 2; k++) {
		Mesh m = { N + 1, NF, xyz, k ? other : tri };

		memset(wanted, GRADIENT_WANTED, sizeof wanted);
		assert_int_equal(stars_init(&stars, &m, u, v), 0);
		gradient_fit(&stars, &m, u, v, wanted, jet[k]);
		stars_free(&stars);
	}
	for (i = 0; i <= N; i++)
		for (c = 0; c < 3; c++) {
			assert_true(fabs(jet[0][i].u[c] - jet[1][i].u[c]) < 1e-10);
			assert_true(fabs(jet[0][i].vv[c] - jet[1][i].vv[c]) < 1e-8);
		}
}

/* With the points on three lines no cubic is determined, so rings are added as long as there is room.
 * Which vertices of the last ring have room does not depend on the order of faces and corners, nor on
 * the orientation. */
static void
full_neighbourhood_does_not_depend_on_order(void **state)
{
	Charted s = charted_random(300, 3), t = charted_random(300, 3);
	int i, k, f;

	(void)state;
	for (i = 0; i < s.m.nv; i++) {
		s.u[i] += i < 4 ? 0.01*i : 0;           /* no two at the same distance */
		s.v[i] = t.v[i] = round(2*s.v[i])/2;
		wavy(s.u[i], s.v[i], &s.m.xyz[3*i], &s.jet[i]);
		memcpy(&t.m.xyz[3*i], &s.m.xyz[3*i], 3*sizeof *t.m.xyz);
		t.u[i] = 1 - s.u[i];
		t.v[i] = 1 - s.v[i];
	}
	for (f = 0; f < s.m.nf; f++)
		for (k = 0; k < 3; k++)
			t.m.tri[3*(s.m.nf - 1 - f) + k] = s.m.tri[3*f + (4 - k)%3];
	charted_fit(&s);
	charted_fit(&t);
	for (i = 0; i < s.m.nv; i++)
		for (k = 0; k < 15; k++) {
			double one = flat(&s.jet[i])[k], other = (k < 6 ? -1 : 1)*flat(&t.jet[i])[k];

			assert_true(fabs(one - other) < 1e-6*(1 + fabs(one)));
		}
	assert_int_equal(s.low, s.m.nv);
	charted_free(&s);
	charted_free(&t);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(cubics_are_exact),
		cmocka_unit_test(orders),
		cmocka_unit_test(small_meshes),
		cmocka_unit_test(collinear_points),
		cmocka_unit_test(thin_strip),
		cmocka_unit_test(limits_hold),
		cmocka_unit_test(smooth_surfaces_are_not_limited),
		cmocka_unit_test(ignores_near_duplicates),
		cmocka_unit_test(follows_motion_and_scale),
		cmocka_unit_test(vertex_of_many_triangles),
		cmocka_unit_test(same_for_any_number_of_threads),
		cmocka_unit_test(hub_does_not_depend_on_numbering),
		cmocka_unit_test(full_neighbourhood_does_not_depend_on_order),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
