/* test_socksurface.c - surface.h on the sock: the surface comes back from its lambda and H. */
#include "cmock.h"

#include <omp.h>

#include "../lib/base/procrustes.h"
#include "../lib/grid/lambdah.h"
#include "../lib/surface/surface.h"
#include "sockcap.h"

static const Chart ROUGH = { 40, 12, 0.3, &CHART_SOCK }, MIDDLE = { 80, 25, 0.3, &CHART_SOCK },
	COARSE = { 120, 36, 0.3, &CHART_SOCK }, FINE = { 240, 72, 0.3, &CHART_SOCK },
	LATTICE = { 30, 10, 0.3, &CHART_SOCK };
enum { MOST = 240*72 };

static double truth[3*MOST], found[3*MOST], kept[3*MOST], lambda[MOST], H[MOST], nu[2][MOST], tau[2][MOST];
static double start[3*30*10];
static const FitOptions EXACT = { .tolerance = 1e-10, .most = 60, .sharpen = 1 };

typedef void Shape(Chart g, double *const phi[3]);

/* More than a hemisphere. */
static void
cap(Chart g, double *const phi[3])
{
	sample_sockcap(g, 1.5, phi, NULL, NULL);
}

/* Enneper's surface over the disk, inverted in a sphere: conformal, not symmetric, and H varies. */
static void
bump(Chart g, double *const phi[3])
{
	SockPlane plane = sockplane(g.T);
	int p, c;

	for (p = 0; p < g.nu*g.nv; p++) {
		double complex z = 0.4*sockplane_z(&plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu));
		Node a = enneper(creal(z) + 0.4, cimag(z) + 0.3);
		double x[3] = { a.x[0] - 0.3, a.x[1] + 0.4, a.x[2] - 2 }, r = x[0]*x[0] + x[1]*x[1] + x[2]*x[2];

		for (c = 0; c < 3; c++)
			phi[c][p] = 4*x[c]/r;
	}
}

static void
sample(Shape *f, Chart g, double *phi)
{
	size_t n = (size_t)g.nu*g.nv;

	f(g, (double *[3]){ phi, phi + n, phi + 2*n });
}

/* The input of the method for a known surface, with a start on a coarse grid. */
static Surface
given(Shape *f, Chart g)
{
	size_t n = (size_t)g.nu*g.nv;
	const double *phi[3] = { truth, truth + n, truth + 2*n };
	double *const nus[2] = { nu[0], nu[1] }, *const taus[2] = { tau[0], tau[1] };

	sample(f, g, truth);
	sample(f, LATTICE, start);
	lambdah(g, phi, LAMBDAH_NORMAL, lambda, H);
	lambdah_residue(g, phi, lambda, nus, taus);
	return (Surface){ .g = g, .lambda = lambda, .H = H, .start_chart = LATTICE, .start_end = { 1, 1 },
		.start = start };
}

/* Reconstructs the surface from the given fields and the boundary.  Returns the largest difference from
 * the exact surface. */
static double
reconstruct(const Surface *s, const FitOptions *o)
{
	int n = s->g.nu*s->g.nv, p;
	FitProgress at;

	for (p = 0; p < 3*n; p++)
		found[p] = p%n >= n - s->g.nu && !s->adrift ? truth[p] : NAN;
	assert_int_equal(surface(s, o, found, &at), 1);
	return largest(3*n, found, truth);
}

static void
surfaces_come_back_of_second_order(void **state)
{
	Shape *const of[] = { cap, bump };
	double coarse;
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		s = given(of[k], COARSE);
		coarse = reconstruct(&s, &EXACT);
		assert_true(coarse < 0.01);
		s = given(of[k], FINE);
		assert_true(reconstruct(&s, &EXACT) < coarse/3.5);
	}
}

static void
residue_gives_the_surface_itself(void **state)
{
	const Residue residue = { { nu[0], nu[1] }, { tau[0], tau[1] }, 1 };
	Surface s = given(bump, COARSE);

	(void)state;
	s.residue = &residue;
	assert_true(reconstruct(&s, &EXACT) < 1e-9);
	s.exact = 1;
	assert_true(reconstruct(&s, &EXACT) < 1e-9);
}

/* The start only selects one of several surfaces: one that is disturbed, none at all (start.h), or the
 * surface itself on the full grid give the same result. */
static void
start_does_not_change_the_result(void **state)
{
	Shape *const of[] = { cap, bump };
	unsigned long long seed = 5;
	size_t n = 3*(size_t)COARSE.nu*COARSE.nv;
	Surface s;
	int q, k;

	(void)state;
	for (q = 0; q < 2; q++) {
		s = given(of[q], COARSE);
		reconstruct(&s, &EXACT);
		memcpy(kept, found, n*sizeof *found);
		for (k = 0; k < 3*30*10; k++)
			start[k] += 0.01*noise(&seed);
		reconstruct(&s, &EXACT);
		assert_true(largest(n, kept, found) < 1e-6);
		s.start = NULL;
		reconstruct(&s, &EXACT);
		assert_true(largest(n, kept, found) < 1e-6);
		s.start = truth;
		s.start_chart = COARSE;
		reconstruct(&s, &EXACT);
		assert_true(largest(n, kept, found) < 1e-6);
	}
}

/* Writes f turned by half a period of u, which exchanges the cones, to t. */
static void
turned(Chart g, int fields, const double *f, double *t)
{
	int q, p, half = g.nu/2;

	for (q = 0; q < fields*g.nv; q++)
		for (p = 0; p < g.nu; p++)
			t[q*g.nu + (p + half)%g.nu] = f[q*g.nu + p];
}

static void
turned_chart_gives_the_same_surface(void **state)
{
	static double x[3*MOST];
	size_t n = (size_t)COARSE.nu*COARSE.nv;
	Surface s = given(bump, COARSE);

	(void)state;
	reconstruct(&s, &EXACT);
	memcpy(kept, found, 3*n*sizeof *found);
	turned(COARSE, 3, truth, x);
	memcpy(truth, x, 3*n*sizeof *x);
	turned(COARSE, 1, lambda, x);
	memcpy(lambda, x, n*sizeof *x);
	turned(COARSE, 1, H, x);
	memcpy(H, x, n*sizeof *x);
	turned(s.start_chart, 3, start, x);
	memcpy(start, x, sizeof start);
	reconstruct(&s, &EXACT);
	turned(COARSE, 3, kept, x);
	assert_true(largest(3*n, found, x) < 1e-10);
}

static const FitOptions PATIENT = { .tolerance = 1e-8, .most = 200, .sharpen = 1 };

/* Reconstructs with a free boundary, placed by the start (adrift) or the boundary.  Returns the largest
 * difference from the exact surface after the best rigid motion. */
static double
reconstruct_free(Surface *s, int adrift)
{
	static double a[MOST][3], b[MOST][3];
	int n = s->g.nu*s->g.nv, p, c;
	double rms;
	Rigid r;

	s->free = 1;
	s->adrift = adrift;
	reconstruct(s, &PATIENT);
	for (p = 0; p < n; p++)
		for (c = 0; c < 3; c++) {
			a[p][c] = truth[c*n+p];
			b[p][c] = found[c*n+p];
		}
	assert_int_equal(procrustes(n, NULL, a[0], b[0], &r, &rms), 0);
	rigid_move(&r, n, b[0]);
	return largest(3*n, a[0], b[0]);
}

static void
free_surfaces_come_back_of_second_order(void **state)
{
	Surface s = given(bump, ROUGH);
	double coarse = reconstruct_free(&s, 0), fine;

	(void)state;
	s = given(bump, MIDDLE);
	fine = reconstruct_free(&s, 0);
	assert_true(coarse < 0.05 && fine < coarse/3);
	memcpy(kept, found, sizeof kept);
	s.start = NULL;
	reconstruct_free(&s, 0);
	assert_true(largest(3*(size_t)MIDDLE.nu*MIDDLE.nv, kept, found) < fine/5);
	s = given(bump, MIDDLE);
	assert_true(fabs(reconstruct_free(&s, 1) - fine) < fine/5);
}

/* How far the surface has a spike at the cone (0,0): the mean of the two nearest nodes minus that of the
 * four next ones, over the distance of two of these.  It is of order h^2 for a smooth surface, a smooth
 * function of the square of the complex distance from the cone, whose linear part cancels in both means. */
static double
spike(Chart g, const double *phi)
{
	int n = g.nu*g.nv, next[4] = { 1, g.nu - 2, g.nu, 2*g.nu - 1 }, c, k;
	double a = 0, b = 0;

	for (c = 0; c < 3; c++) {
		const double *x = phi + c*n;
		double d = (x[0] + x[g.nu-1])/2;

		for (k = 0; k < 4; k++)
			d -= x[next[k]]/4;
		a += d*d;
		b += (x[next[0]] - x[next[3]])*(x[next[0]] - x[next[3]]);
	}
	return sqrt(a/b);
}

/* Where lambda and H belong to no surface, one that is fitted as if they did has spikes at the cones. */
static void
filtered_surfaces_have_no_spikes(void **state)
{
	double without;
	Surface s = given(cap, FINE);
	int p;

	(void)state;
	assert_true(spike(FINE, truth) < 1e-2);
	for (p = 0; p < FINE.nu*FINE.nv; p++)
		lambda[p] *= 1 + 0.3*cos(2*M_PI*chart_u(FINE, p%FINE.nu))*exp(-10*chart_v(FINE, p/FINE.nu));
	reconstruct(&s, &PATIENT);
	without = spike(FINE, found);
	s.filtered = 1;
	reconstruct(&s, &PATIENT);
	assert_true(without > 0.1 && spike(FINE, found) < 1e-2);
}

/* Grids of fewer than three nodes in a direction stay as they are. */
static void
small_grids_are_solved(void **state)
{
	static const Chart charts[] = { { 2, 2, 1, &CHART_SOCK }, { 4, 3, 0.4, &CHART_SOCK }, { 6, 9, 1, &CHART_SOCK },
		{ 12, 3, 0.1, &CHART_SOCK } };
	FitProgress at;
	Surface s;
	int k, way;

	(void)state;
	for (way = 0; way < 8; way++) {
		k = way/2;
		sample(cap, charts[k], truth);
		sample_sockcap(charts[k], 1.5, NULL, lambda, H);
		s = (Surface){ .g = charts[k], .lambda = lambda, .H = H, .start_chart = charts[k], .start_end = { 1, 1 },
		    .start = truth, .free = way%2 && k };
		memcpy(found, truth, sizeof truth);
		assert_int_equal(surface(&s, &PATIENT, found, &at), 1);
		assert_true(largest(3*(size_t)charts[k].nu*charts[k].nv, truth, found) < 1);
	}
}

static void
threads_change_no_bit(void **state)
{
	Surface s = given(bump, COARSE);
	size_t n = 3*(size_t)COARSE.nu*COARSE.nv;
	int threads = omp_get_max_threads();

	(void)state;
	s.start = NULL;
	omp_set_num_threads(1);
	reconstruct(&s, &EXACT);
	memcpy(kept, found, n*sizeof *found);
	omp_set_num_threads(3);
	reconstruct(&s, &EXACT);
	omp_set_num_threads(threads);
	assert_memory_equal(kept, found, n*sizeof *found);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(surfaces_come_back_of_second_order),
		cmocka_unit_test(residue_gives_the_surface_itself),
		cmocka_unit_test(start_does_not_change_the_result),
		cmocka_unit_test(turned_chart_gives_the_same_surface),
		cmocka_unit_test(free_surfaces_come_back_of_second_order),
		cmocka_unit_test(filtered_surfaces_have_no_spikes),
		cmocka_unit_test(small_grids_are_solved),
		cmocka_unit_test(threads_change_no_bit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
