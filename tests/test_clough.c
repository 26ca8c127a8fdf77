/* test_clough.c - clough.h, the Clough-Tocher interpolant: it is exact on cubics, its first
 * derivatives are continuous, it converges with the right order, and it is bounded. */
#include "cmock.h"

#include "charted.h"

/* The number of sides of triangle t across which the derivative was limited. */
static int
limited_sides(const Clough *c, int t)
{
	const double centre[3] = { 1/3.0, 1/3.0, 1/3.0 };
	double phi[3];

	return clough_eval(c, t, centre, phi);
}

/* The cubic on side i j that interpolates the positions and derivatives at both ends, evaluated at
 * the point (1-s) i + s j. */
static void
cubic_of_side(const Clough *cl, int i, int j, double s, double phi[3])
{
	const double *f = &cl->m->xyz[3*i], *g = &cl->m->xyz[3*j];
	const Jet *a = &cl->jet[i], *b = &cl->jet[j];
	double du = cl->u[j] - cl->u[i], dv = cl->v[j] - cl->v[i], r = 1 - s;
	int c;

	for (c = 0; c < 3; c++) {
		double p = f[c] + (a->u[c]*du + a->v[c]*dv)/3, q = g[c] - (b->u[c]*du + b->v[c]*dv)/3;

		phi[c] = r*r*r*f[c] + 3*r*s*(r*p + s*q) + s*s*s*g[c];
	}
}

static void
random_bary(uint64_t *seed, double b[3])
{
	double x = rng_unit(seed), y = rng_unit(seed);

	b[0] = fmin(x, y);
	b[1] = fmax(x, y) - b[0];
	b[2] = 1 - fmax(x, y);
}

static void
place_of(const Charted *s, int t, const double b[3], double *u, double *v)
{
	const int *q = &s->m.tri[3*t];

	*u = b[0]*s->u[q[0]] + b[1]*s->u[q[1]] + b[2]*s->u[q[2]];
	*v = b[0]*s->v[q[0]] + b[1]*s->v[q[1]] + b[2]*s->v[q[2]];
}

static void
flat_at(const Charted *s, int t, const double b[3], double phi[3])
{
	const int *q = &s->m.tri[3*t];
	int c;

	for (c = 0; c < 3; c++)
		phi[c] = b[0]*s->m.xyz[3*q[0] + c] + b[1]*s->m.xyz[3*q[1] + c] + b[2]*s->m.xyz[3*q[2] + c];
}

/* First and second derivative of phi at the point b of triangle t in the direction d, from the
 * values at b, b + d, b + 2d and b + 3d.  It is exact if all four lie in one of the three parts of
 * the triangle, where phi is one cubic. */
static void
along(const Charted *s, int t, const double b[3], const double d[3], double first[3], double second[3])
{
	double p[4][3], x[3];
	int k, c;

	for (k = 0; k < 4; k++) {
		for (c = 0; c < 3; c++)
			x[c] = b[c] + k*d[c];
		clough_eval(&s->c, t, x, p[k]);
	}
	for (c = 0; c < 3; c++) {
		first[c] = (-11*p[0][c] + 18*p[1][c] - 9*p[2][c] + 2*p[3][c])/6;
		second[c] = 2*p[0][c] - 5*p[1][c] + 4*p[2][c] - p[3][c];
	}
}

/* The corner of triangle t opposite the side shared with triangle r, or -1. */
static int
corner_opposite(const Mesh *m, int t, int r)
{
	int k, l, shared[3] = { 0, 0, 0 };

	for (k = 0; k < 3; k++)
		for (l = 0; l < 3; l++)
			shared[k] |= m->tri[3*t + k] == m->tri[3*r + l];
	for (k = 0; k < 3; k++)
		if (!shared[k])
			return shared[(k+1)%3] && shared[(k+2)%3] ? k : -1;
	return -1;
}

/* Two triangles t and r with a common side; k is the corner of t opposite to it. */
typedef struct Pair {
	int t, r, k;
} Pair;

static Pair *
pairs(const Mesh *m, int *n)
{
	Pair *p = malloc(3*m->nf*sizeof *p);
	int t, r, k;

	assert_non_null(p);
	for (*n = 0, t = 0; t < m->nf; t++)
		for (r = 0; r < m->nf; r++)
			if (t != r && (k = corner_opposite(m, t, r)) >= 0)
				p[(*n)++] = (Pair){ t, r, k };
	return p;
}

/* Barycentric coordinates in triangle t of the point (1-x) i + x j on its side i j. */
static void
on_side(const Mesh *m, int t, int i, int j, double x, double b[3])
{
	int k;

	for (k = 0; k < 3; k++)
		b[k] = m->tri[3*t + k] == i ? 1 - x : m->tri[3*t + k] == j ? x : 0;
}

/* Adds random numbers of up to `size` to the jets, so that they belong to no surface.  If size is
 * small, clough_eval does not limit the derivatives. */
static void
random_jets(Charted *s, uint64_t seed, double size)
{
	int i, k;

	for (i = 0; i < s->m.nv; i++)
		for (k = 0; k < 15; k++)
			((double *)&s->jet[i])[k] += size*rng_between(&seed, -1, 1);
	s->c = (Clough){ &s->m, s->u, s->v, s->jet };
}

static void
cubics_are_exact(void **state)
{
	Charted s = charted_random(600, 11);
	double b[3], u, v, phi[3], want[3];
	uint64_t seed = 2;
	int t, k;
	Jet ignored;

	(void)state;
	charted_place(&s, cubic);
	charted_fit(&s);
	for (t = 0; t < s.m.nf; t++) {
		assert_int_equal(limited_sides(&s.c, t), 0);
		for (k = 0; k < 20; k++) {
			random_bary(&seed, b);
			place_of(&s, t, b, &u, &v);
			clough_eval(&s.c, t, b, phi);
			cubic(u, v, want, &ignored);
			assert_true(distance3(phi, want) < 1e-12);
		}
	}
	charted_free(&s);
}

/* Cubics are also exact where vertices coincide in (u,v), on triangles with a side of length 0 and
 * on the triangles that are flipped because of them. */
static void
coincident_vertices(void **state)
{
	Charted s = charted_even(300);
	const double b[3] = { 0.5, 0.3, 0.2 };
	double u, v, phi[3], want[3];
	Jet ignored;
	int t;

	(void)state;
	for (t = 0; t < s.m.nf; t += 20) {
		s.u[s.m.tri[3*t]] = s.u[s.m.tri[3*t + 1]];
		s.v[s.m.tri[3*t]] = s.v[s.m.tri[3*t + 1]];
	}
	charted_place(&s, cubic);
	charted_fit(&s);
	assert_int_equal(s.low + s.limited, 0);
	for (t = 0; t < s.m.nf; t++) {
		place_of(&s, t, b, &u, &v);
		clough_eval(&s.c, t, b, phi);
		cubic(u, v, want, &ignored);
		assert_true(distance3(phi, want) < 1e-12);
		assert_int_equal(limited_sides(&s.c, t), 0);
	}
	charted_free(&s);
}

/* At the vertices the interpolant has exactly the given positions, even on degenerate input. */
static void
exact_at_vertices(void **state)
{
	Charted s = charted_rubbish(4);
	double phi[3];
	int t, k;

	(void)state;
	charted_fit(&s);
	for (t = 0; t < 3*s.m.nf; t++) {
		const double b[3] = { t%3 == 0, t%3 == 1, t%3 == 2 }, *want = &s.m.xyz[3*s.m.tri[t]];

		clough_eval(&s.c, t/3, b, phi);
		for (k = 0; k < 3; k++)
			assert_true(phi[k] == want[k]);
	}
	charted_free(&s);
}

/* The derivative at the point (1-x) i + x j of side i j, along the unit normal of this side in the
 * (u,v) plane; k is the corner of triangle t opposite to the side.  It is computed from the
 * derivative towards the centroid of t and from that along the side.  The normal depends only on i
 * and j, so both triangles at the side give the same derivative if it is continuous. */
static void
across(const Charted *s, int t, int i, int j, double x, int k, double out[3])
{
	double b[3], d[3] = { 0.05, 0.05, 0.05 }, side[3], first[3], tangent[3], u[3], v[3], e2, share, height;
	int c, a = s->m.tri[3*t + k];

	on_side(&s->m, t, i, j, x, b);
	for (c = 0; c < 3; c++)
		d[c] *= 1 - 3*b[c];
	along(s, t, b, d, first, tangent);
	on_side(&s->m, t, i, j, 0.05, side);
	for (c = 0; c < 3; c++)
		side[c] -= s->m.tri[3*t + c] == i;
	along(s, t, b, side, tangent, b);
	u[0] = s->u[j] - s->u[i], v[0] = s->v[j] - s->v[i];
	u[1] = s->u[a] - s->u[i], v[1] = s->v[a] - s->v[i];
	for (u[2] = v[2] = 0, c = 0; c < 3; c++) {
		u[2] += d[c]*s->u[s->m.tri[3*t + c]];
		v[2] += d[c]*s->v[s->m.tri[3*t + c]];
	}
	e2 = u[0]*u[0] + v[0]*v[0];
	share = (u[2]*u[0] + v[2]*v[0])/e2;
	height = (u[0]*v[2] - v[0]*u[2])/sqrt(e2);
	for (c = 0; c < 3; c++)
		out[c] = (first[c] - share*20*tangent[c])/height;
}

/* First derivatives are continuous across the sides of triangles, also for random jets. */
static void
smooth_over_sides(void **state)
{
	Charted s = charted_even(300);
	uint64_t seed = 3;
	double p[3], q[3];
	int n, k;
	Pair *e;

	(void)state;
	charted_place(&s, wavy);
	charted_fit(&s);
	random_jets(&s, 5, 0.2);
	e = pairs(&s.m, &n);
	assert_true(n > 2*s.m.nf);
	for (k = 0; k < n; k++) {
		int i = s.m.tri[3*e[k].t + (e[k].k+1)%3], j = s.m.tri[3*e[k].t + (e[k].k+2)%3];
		double x = rng_between(&seed, 0, 0.8);

		across(&s, e[k].t, i, j, x, e[k].k, p);
		across(&s, e[k].r, i, j, x, corner_opposite(&s.m, e[k].r, e[k].t), q);
		assert_int_equal(limited_sides(&s.c, e[k].t), 0);
		assert_true(distance3(p, q) < 1e-10*norm3(p));
	}
	free(e);
	charted_free(&s);
}

/* First derivatives are also continuous between the three parts of a triangle: at points of the
 * segment from a corner to the centroid, the derivatives across it agree from both sides. */
static void
smooth_inside(void **state)
{
	Charted s = charted_even(200);
	uint64_t seed = 3;
	double p[3], q[3], ignored[3];
	int t, k;

	(void)state;
	charted_place(&s, wavy);
	charted_fit(&s);
	random_jets(&s, 6, 0.5);
	for (t = 0; t < 3*s.m.nf; t++) {
		double x = rng_between(&seed, 0.05, 0.3), b[3] = { x, x, x }, d[3], minus[3];

		b[t%3] = 1 - 2*x;
		for (k = 0; k < 3; k++) {
			d[k] = (k == (t+1)%3)*0.01 - (k == (t+2)%3)*0.01;
			minus[k] = -d[k];
		}
		along(&s, t/3, b, d, p, ignored);
		along(&s, t/3, b, minus, q, ignored);
		for (k = 0; k < 3; k++)
			q[k] = -q[k];
		assert_true(distance3(p, q) < 1e-13);
		assert_true(norm3(p) > 1e-6);
	}
	charted_free(&s);
}

/* On degenerate input, neighbours have the same cubic on their common side, and no point is farther
 * from its point on the flat triangle than half the longest side.  Some derivatives are limited, so
 * this also tests the limit. */
static void
degenerate_input_is_continuous_and_bounded(void **state)
{
	double b[3], p[3], q[3], r[3];
	uint64_t seed = 8;
	int n, k, l, limited = 0;

	(void)state;
	for (l = 1; l <= 5; l++) {
		Charted s = charted_rubbish(l);
		Pair *e = pairs(&s.m, &n);

		charted_fit(&s);
		for (k = 0; k < n; k++) {
			int i = s.m.tri[3*e[k].t + (e[k].k+1)%3], j = s.m.tri[3*e[k].t + (e[k].k+2)%3];
			double x = rng_unit(&seed);

			on_side(&s.m, e[k].t, i, j, x, b);
			clough_eval(&s.c, e[k].t, b, p);
			on_side(&s.m, e[k].r, i, j, x, b);
			clough_eval(&s.c, e[k].r, b, q);
			cubic_of_side(&s.c, i, j, x, r);
			assert_true(distance3(p, q) < 1e-13 && distance3(p, r) < 1e-13);
		}
		for (k = 0; k < 20*s.m.nf; k++) {
			random_bary(&seed, b);
			clough_eval(&s.c, k/20, b, p);
			flat_at(&s, k/20, b, q);
			assert_true(distance3(p, q) <= charted_longest(&s.m, k/20)/2 + 1e-13);
			limited += limited_sides(&s.c, k/20);
		}
		free(e);
		charted_free(&s);
	}
	assert_true(limited > 0);
}

/* The interpolant is also bounded if the jets contain huge second derivatives, which have an effect
 * only inside triangles. */
static void
bounded_for_any_jets(void **state)
{
	Charted s = charted_even(100);
	double b[3], p[3], q[3], most = 0;
	uint64_t seed = 9;
	int k;

	(void)state;
	charted_place(&s, wavy);
	charted_fit(&s);
	for (k = 0; k < s.m.nv; k++)
		memset(s.jet[k].uu, 0, 9*sizeof(double));
	for (k = 0; k < s.m.nv; k++)
		s.jet[k].uu[0] = 1.7e308*(k%2 ? 1 : -1);
	for (k = 0; k < 20*s.m.nf; k++) {
		random_bary(&seed, b);
		clough_eval(&s.c, k/20, b, p);
		flat_at(&s, k/20, b, q);
		assert_true(distance3(p, q) <= charted_longest(&s.m, k/20)/2 + 1e-13);
		most = fmax(most, distance3(p, q)/charted_longest(&s.m, k/20));
	}
	assert_true(most > 0.1);
	charted_free(&s);
}

/* Root mean squares, over one random point in each triangle, of four errors: of phi, of its first
 * derivatives, of its second derivatives, and of the normal part of its Laplacian. */
static void
errors(const Charted *s, double e[4])
{
	double b[3], phi[3], want[3], f[2][3], g[2][3], n[3], u, v, area, H, sum[4] = { 0 };
	uint64_t seed = 1;
	int t, k, c, i;
	Jet j;

	for (t = 0; t < s->m.nf; t++) {
		const int *q = &s->m.tri[3*t];
		double a = s->u[q[1]] - s->u[q[0]], d = s->v[q[1]] - s->v[q[0]];
		double x = s->u[q[2]] - s->u[q[0]], y = s->v[q[2]] - s->v[q[0]], det = a*y - d*x;
		double r = 0.02*det/(a*a + d*d + x*x + y*y + fabs(a*x + d*y));
		const double du[3] = { (d - y)/det*r, y/det*r, -d/det*r },
			dv[3] = { (x - a)/det*r, -x/det*r, a/det*r };

		do
			random_bary(&seed, b);
		while (fmin(fabs(b[0] - b[1]), fmin(fabs(b[1] - b[2]), fabs(b[2] - b[0]))) < 0.15);
		place_of(s, t, b, &u, &v);
		wavy(u, v, want, &j);
		clough_eval(&s->c, t, b, phi);
		sum[0] += pow(distance3(phi, want), 2);
		for (k = 0; k < 2; k++)
			along(s, t, b, k ? dv : du, f[k], g[k]);
		for (c = 0; c < 3; c++)
			for (k = 0; k < 2; k++) {
				f[k][c] /= r, g[k][c] /= r*r;
				sum[1] += pow(f[k][c] - (k ? j.v : j.u)[c], 2);
				sum[2] += pow(g[k][c] - (k ? j.vv : j.uu)[c], 2);
			}
		for (H = 0, i = 0; i < 2; i++) {
			cross3(i ? j.u : f[0], i ? j.v : f[1], n);
			area = norm3(n);
			for (c = 0; c < 3; c++)
				H += (i ? -1 : 1)*n[c]/area*(i ? j.uu[c] + j.vv[c] : g[0][c] + g[1][c]);
		}
		sum[3] += H*H;
	}
	for (k = 0; k < 4; k++)
		e[k] = sqrt(fmax(sum[k], 0)/s->m.nf);
}

/* phi converges with fourth order in the mesh size, first derivatives with third, second
 * derivatives and the normal part of the Laplacian with second.  The orders measured from the first
 * to the last mesh may be lower by 0.2. */
static void
orders(void **state)
{
	static const int n[] = { 500, 2000, 8000, 32000 };
	static const double order[] = { 3.8, 2.8, 1.8, 1.8 };
	double e[4][4];
	int k, l;

	(void)state;
	for (k = 0; k < 4; k++) {
		Charted s = charted_even(n[k]);

		charted_place(&s, wavy);
		charted_fit(&s);
		errors(&s, e[k]);
		for (l = 0; l < s.m.nf; l++)
			assert_int_equal(limited_sides(&s.c, l), 0);
		charted_free(&s);
	}
	for (k = 0; k < 4; k++)
		assert_true(log2(e[0][k]/e[3][k])/3 > order[k]);
}

static void
follows_motion_and_scale(void **state)
{
	Charted s = charted_random(300, 5), t = charted_random(300, 5);
	double b[3], p[3], q[3];
	uint64_t seed = 7;
	int i;

	(void)state;
	charted_place(&s, wavy);
	charted_place(&t, wavy);
	for (i = 0; i < t.m.nv; i++) {
		charted_move(&t.m.xyz[3*i], 1);
		t.u[i] *= 1e-6, t.v[i] *= 1e-6;
	}
	charted_fit(&s);
	charted_fit(&t);
	for (i = 0; i < 10*s.m.nf; i++) {
		random_bary(&seed, b);
		clough_eval(&s.c, i/10, b, p);
		clough_eval(&t.c, i/10, b, q);
		charted_move(p, 1);
		assert_true(distance3(p, q) < 1e-10*CHARTED_SIZE);
		assert_int_equal(limited_sides(&s.c, i/10), limited_sides(&t.c, i/10));
	}
	charted_free(&s);
	charted_free(&t);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(cubics_are_exact),
		cmocka_unit_test(coincident_vertices),
		cmocka_unit_test(exact_at_vertices),
		cmocka_unit_test(smooth_over_sides),
		cmocka_unit_test(smooth_inside),
		cmocka_unit_test(degenerate_input_is_continuous_and_bounded),
		cmocka_unit_test(bounded_for_any_jets),
		cmocka_unit_test(orders),
		cmocka_unit_test(follows_motion_and_scale),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
