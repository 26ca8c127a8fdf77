/* test_spheresampler.c - positions and fields of closed meshes at points of the sphere. */
#include "cmock.h"

#include <string.h>

#include "../lib/sample/spheresampler.h"
#include "closedball.h"

enum { POINTS = 3000 };

static double complex at[POINTS][2];
static double out[4][POINTS];
static double *const phi[3] = { out[0], out[1], out[2] };

/* A smooth closed surface over the unit sphere, without symmetry. */
static void
surface(const double x[3], double y[3])
{
	double r = 1 + .2*sin(2*x[0] + 1) + .15*x[1]*x[2];

	y[0] = 1.5*r*x[0] + .3*x[1];
	y[1] = r*x[1];
	y[2] = .8*r*x[2] - .2*x[0]*x[0];
}

static double
height(const double x[3])
{
	return cos(2*x[0] + x[2]) + x[1];
}

/* That surface on a mesh with the places of its vertices, and a subdivision. */
typedef struct Ball {
	Disk        d;
	Subdivision mesh;
	double complex (*Z)[2];
	double     *f;
} Ball;

static void
make(int n, double noise, int split, Ball *b)
{
	int i, k;
	double x[3];

	assert_int_equal(ball_mesh(n, noise, &b->d), 0);
	assert_int_equal(subdivision_init(&b->mesh, &b->d), 0);
	for (k = 0; k < split; k++)
		assert_int_equal(subdivision_refine(&b->mesh, NULL, NULL, NULL), 0);
	b->Z = malloc(b->mesh.d.m.nv*sizeof *b->Z);
	b->f = malloc(b->mesh.d.m.nv*sizeof *b->f);
	for (i = 0; i < b->mesh.d.m.nv; i++) {
		double *y = b->mesh.d.m.xyz + 3*i, r = sqrt(y[0]*y[0] + y[1]*y[1] + y[2]*y[2]);

		for (k = 0; k < 3; k++)
			x[k] = y[k]/r;
		ball_spinor(x, b->Z[i]);
		surface(x, y);
		b->f[i] = height(x);
		if (i < b->d.m.nv)
			memcpy(b->d.m.xyz + 3*i, y, sizeof x);
	}
}

static void
drop(Ball *b)
{
	disk_free(&b->d);
	subdivision_free(&b->mesh);
	free(b->Z);
	free(b->f);
}

static void
random_points(void)
{
	uint64_t seed = 3;
	double x[3], r;
	int i, c;

	for (i = 0; i < POINTS; i++) {
		do
			for (r = 0, c = 0; c < 3; c++) {
				x[c] = 2*rng_unit(&seed) - 1;
				r += x[c]*x[c];
			}
		while (!(r > .01 && r < 1));
		for (c = 0; c < 3; c++)
			x[c] /= sqrt(r);
		ball_spinor(x, at[i]);
	}
}

/* The largest distance of the sampled points from the surface, and of the sampled field. */
static double
error(const Ball *b, int kind, double *field)
{
	SphereSampler s;
	double x[3], y[3], most = 0;
	int i;

	random_points();
	assert_int_equal(spheresampler_init(&s, &b->d, &b->mesh, b->Z, kind), 0);
	assert_int_equal(spheresampler_points(&s, POINTS, at, phi), 0);
	assert_int_equal(spheresampler_field(&s, b->f, POINTS, at, out[3]), 0);
	for (*field = 0, i = 0; i < POINTS; i++) {
		ball_point(at[i], x);
		surface(x, y);
		most = fmax(most, hypot(hypot(out[0][i] - y[0], out[1][i] - y[1]), out[2][i] - y[2]));
		*field = fmax(*field, fabs(out[3][i] - height(x)));
	}
	assert_int_equal(s.overlaid, 0);
	spheresampler_free(&s);
	return most;
}

/* The smooth surface errs by h^4, the facets by h^2. */
static void
orders(void **state)
{
	static const double order[2] = { 2, 4 };
	double e[2], f[2];
	int kind, k;

	(void)state;
	for (kind = SAMPLER_FACETS; kind <= SAMPLER_SMOOTH; kind++) {
		for (k = 0; k < 2; k++) {
			Ball b;

			make(k ? 48 : 24, .2, 0, &b);
			e[k] = error(&b, kind, &f[k]);
			drop(&b);
		}
		assert_true(log2(e[0]/e[1]) > order[kind] - .4);
		assert_true(log2(f[0]/f[1]) > order[kind] - .4);
	}
}

/* Where both halves meet, the sampled surface has no jump, nor have its first derivatives.  (From half to half without a mean the
 * position jumps by the error of the interpolation, 1e-5 here.) */
static void
no_seam(void **state)
{
	static const double rim[] = { 1, .8187307530779818, 1.2214027581601699 };       /* exp(0), exp(-.2), exp(.2) */
	const double step = 1e-5;
	SphereSampler s;
	Ball b;
	int i, k, c, q;

	(void)state;
	make(16, .2, 0, &b);
	assert_int_equal(spheresampler_init(&s, &b.d, &b.mesh, b.Z, SAMPLER_SMOOTH), 0);
	for (q = 0; q < 3; q++) {
		for (i = 0; i < 900; i++) {
			double r = rim[q]*exp((i%9 - 4)*step);

			at[i][0] = r/hypot(1, r)*cexp(I*(.1 + i/9*.0628));
			at[i][1] = 1/hypot(1, r);
		}
		assert_int_equal(spheresampler_points(&s, 900, at, phi), 0);
		for (c = 0; c < 3; c++)
			for (i = 0; i < 900; i += 9)
				for (k = 1; k < 8; k++)
					assert_true(fabs(out[c][i+k-1] - 2*out[c][i+k] + out[c][i+k+1]) < 20*step*step);
	}
	spheresampler_free(&s);
	drop(&b);
}

/* At a vertex it is the vertex, in either half. */
static void
goes_through_the_vertices(void **state)
{
	SphereSampler s;
	Ball b;
	int i, c;

	(void)state;
	make(16, .2, 0, &b);
	assert_true(b.d.m.nv < POINTS);
	memcpy(at, b.Z, b.d.m.nv*sizeof *at);
	assert_int_equal(spheresampler_init(&s, &b.d, &b.mesh, b.Z, SAMPLER_SMOOTH), 0);
	assert_int_equal(spheresampler_points(&s, b.d.m.nv, at, phi), 0);
	for (i = 0; i < b.d.m.nv; i++)
		for (c = 0; c < 3; c++)
			assert_true(fabs(out[c][i] - b.d.m.xyz[3*i+c]) < 1e-9);
	spheresampler_free(&s);
	drop(&b);
}

/* A face may have long sides on the sphere: the finer mesh is sampled there. */
static void
long_faces(void **state)
{
	SphereSampler s;
	double x[3], y[3];
	Ball b;
	int i;

	(void)state;
	make(1, 0, 1, &b);
	assert_int_equal(spheresampler_init(&s, &b.d, &b.mesh, b.Z, SAMPLER_SMOOTH), SPHERESAMPLER_ECOARSE);
	drop(&b);
	make(1, 0, 5, &b);
	random_points();
	assert_int_equal(spheresampler_init(&s, &b.d, &b.mesh, b.Z, SAMPLER_SMOOTH), 0);
	assert_int_equal(s.overlaid, 8);
	assert_int_equal(spheresampler_points(&s, POINTS, at, phi), 0);
	for (i = 0; i < POINTS; i++) {
		ball_point(at[i], x);
		surface(x, y);
		assert_true(hypot(hypot(out[0][i] - y[0], out[1][i] - y[1]), out[2][i] - y[2]) < .01);
	}
	spheresampler_free(&s);
	drop(&b);
}

int
main(void)
{
	const struct CMUnitTest t[] = {
		cmocka_unit_test(orders),
		cmocka_unit_test(no_seam),
		cmocka_unit_test(goes_through_the_vertices),
		cmocka_unit_test(long_faces),
	};

	return cmocka_run_group_tests(t, NULL, NULL);
}
