/* test_patch.c - patch.h: the equations of the unresolved nodes are solved, and directions are
 * corrected so that the residual on these nodes stays 0. */
#include "cmock.h"

#include <omp.h>

#include "../lib/base/field.h"
#include "../lib/grid/stencil.h"
#include "../lib/surface/patch.h"
#include "charts.h"
#include "surfaces.h"

enum { NU = 46, NV = 58, N = NU*NV };

static double phi[3*N], lambda2[N], l2H[N], z[3*N], q[3*N], d[3*N], start[3*N];

/* A torus patch with noise.  At a few nodes, some of them next to the border, H is so large that
 * the grid does not resolve it. */
static Misfit
misfit_with_peaks(const ChartKind *kind, double T)
{
	static const int peak[][2] = { { 1, 1 }, { 20, 30 }, { 22, 30 }, { 44, 9 }, { 30, 56 } };
	Chart g = { NU, NV, T, kind };
	double *x[3] = { phi, phi + N, phi + 2*N };
	unsigned long long seed = 3;
	Misfit m;
	int k, p;

	sample_immersion(torus, g, 1, x, NULL, NULL);
	for (p = 0; p < 3*N; p++)
		phi[p] += 1e-3*noise(&seed);
	for (p = 0; p < N; p++)
		lambda2[p] = l2H[p] = 1;
	if (kind->round)                /* on a chart with cones lambda goes to 0 there */
		kind->round(g, lambda2);
	for (p = 0; p < N; p++)
		lambda2[p] *= lambda2[p];
	for (k = 0; k < 5; k++)
		l2H[peak[k][1]*NU + peak[k][0]] = 1e3;
	assert_int_equal(misfit_init(&m, g, lambda2, l2H, NULL), 0);
	m.w = 40;
	m.alpha = 0.6;
	return m;
}

/* The largest |x| on the unresolved nodes S, or, if `inside` is 0, on the other nodes. */
static double
largest_on(const Patch *p, int inside, const double *x)
{
	double most = 0;
	int k;

	for (k = 0; k < 3*N; k++)
		if ((p->number[k%N] >= 0) == inside)
			most = fmax(most, fabs(x[k]));
	return most;
}

/* Random displacements of the unknowns. */
static void
random_field(const Misfit *m, double *x)
{
	unsigned long long seed = 7;
	int k;

	for (k = 0; k < 3*N; k++)
		x[k] = m->free || stencil_is_inner(m->g, k%N%NU, k%N/NU) ? noise(&seed) : 0;
}

/* After patch_correct (A z)_S is 0, and z has not changed outside S. */
static void
check_correction(const Misfit *m, int least, int most)
{
	Patch p;
	int i;

	assert_int_equal(patch_init(&p, m), 0);
	assert_in_range(p.nodes, least, most);
	assert_int_equal(patch_set(&p, phi), 0);
	random_field(m, z);
	memcpy(start, z, sizeof start);
	misfit_normal(m, phi, z, q);
	assert_true(largest_on(&p, 1, q) > 1);
	assert_int_equal(patch_correct(&p, z), 0);
	misfit_normal(m, phi, z, d);
	assert_true(largest_on(&p, 1, d) < 1e-7*largest_on(&p, 1, q));
	for (i = 0; i < 3*N; i++)
		assert_true(p.number[i%N] >= 0 || z[i] == start[i]);
	patch_free(&p);
}

/* On every kind of chart, also with a place. */
static void
corrected_directions_leave_no_residual(void **state)
{
	Misfit m;
	int k;

	(void)state;
	for (k = 0; k < 8; k++) {
		m = misfit_with_peaks(KINDS[k/2], 0.8);
		if (k%2)
			assert_int_equal(misfit_hold(&m, &(MisfitPlace){ phi, 0.05 }), 0);
		check_correction(&m, 20, 60);
		misfit_free(&m);
	}
}

/* The patch has the nodes beside cones, but none whose position enters the equations of a free border,
 * which on a very low sock are close to the cones. */
static void
patch_holds_the_cones(void **state)
{
	static const double height[] = { 0.8, 0.02 };
	Misfit m;
	int k;

	(void)state;
	for (k = 0; k < 4; k++) {
		m = misfit_with_peaks(&CHART_SOCK, height[k/2]);
		m.w = 1e5;              /* or bending would drown the border's equations, which are of the metric */
		if (k%2)
			misfit_set_free(&m);
		assert_int_equal(misfit_set_firm(&m, 0.05), 0);
		check_correction(&m, k%2 ? 10 : 40, k/2 ? 600 : 90);
		misfit_free(&m);
	}
}

/* patch_start solves the equations on S alone and returns the decrease of E that d predicts;
 * patch_clear sets a vector to 0 on S alone. */
static void
start_solves_the_patch(void **state)
{
	Misfit m = misfit_with_peaks(&CHART_RECTANGLE, 0.8);
	double decrease;
	Patch p;

	(void)state;
	assert_int_equal(patch_init(&p, &m), 0);
	assert_int_equal(patch_set(&p, phi), 0);
	random_field(&m, z);
	memset(d, 0, sizeof d);
	decrease = patch_start(&p, z, d);
	assert_true(largest_on(&p, 0, d) == 0);
	misfit_normal(&m, phi, d, q);
	assert_true(fabs(field_dot(3*N, d, q)/decrease - 1) < 1e-6);
	field_add(3*N, -1, z, q);
	assert_true(largest_on(&p, 1, q) < 1e-6);
	patch_clear(&p, z);
	assert_true(largest_on(&p, 1, z) == 0 && largest_on(&p, 0, z) > 0.5);
	patch_free(&p);
	misfit_free(&m);
}

static void
resolved_grids_have_no_patch(void **state)
{
	Misfit m = misfit_with_peaks(&CHART_RECTANGLE, 0.8);
	Patch p;
	int k;

	(void)state;
	for (k = 0; k < N; k++)
		m.o[k] = 0.5;
	assert_int_equal(patch_init(&p, &m), 0);
	assert_int_equal(p.nodes, 0);
	patch_free(&p);
	misfit_free(&m);
}

static void
threads_change_no_bit(void **state)
{
	Misfit m = misfit_with_peaks(&CHART_PILLOW, 0.8);
	Patch p;
	int threads;

	(void)state;
	for (threads = 1; threads <= 4; threads += 3) {
		omp_set_num_threads(threads);
		assert_int_equal(patch_init(&p, &m), 0);
		assert_int_equal(patch_set(&p, phi), 0);
		random_field(&m, z);
		assert_int_equal(patch_correct(&p, z), 0);
		if (threads == 1)
			memcpy(d, z, sizeof d);
		patch_free(&p);
	}
	assert_memory_equal(d, z, sizeof d);
	misfit_free(&m);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(corrected_directions_leave_no_residual),
		cmocka_unit_test(patch_holds_the_cones),
		cmocka_unit_test(start_solves_the_patch),
		cmocka_unit_test(resolved_grids_have_no_patch),
		cmocka_unit_test(threads_change_no_bit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
