/* test_resample.c - resample.h: interpolation is exact for cubics, averaging for linear functions. */
#include "cmock.h"

#include "../lib/grid/resample.h"
#include "sockcap.h"

static const double WHOLE[2] = { 1, 1 };

static double
cubic(double u, double v)
{
	return 1 + 2*u - v + u*u*u - 3*u*v*v + 0.5*v*v*v;
}

static double
straight(double u, double v)
{
	return 3 - 2*u + 0.7*v;
}

static void
fill(Chart g, const double end[2], double (*f)(double, double), double *x)
{
	int i, j;

	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++)
			x[j*g.nu+i] = f(i*end[0]/(g.nu - 1), j*end[1]*g.T/(g.nv - 1));
}

/* Interpolation is exact for cubics, both to finer and to coarser grids, also from a lattice that ends
 * before the border. */
static void
cubics_are_exact(void **state)
{
	static const Chart to[] = { { 23, 17, 0.8, &CHART_RECTANGLE }, { 12, 9, 0.8, &CHART_RECTANGLE },
		{ 6, 5, 0.8, &CHART_RECTANGLE }, { 40, 31, 0.8, &CHART_RECTANGLE } };
	const double part[2] = { 0.9, 0.95 }, *ends[2] = { WHOLE, part };
	Chart from = { 12, 9, 0.8, &CHART_RECTANGLE };
	double f[12*9], e[40*31], want[40*31];
	int q, k;

	(void)state;
	for (k = 0; k < 2; k++)
		for (q = 0; q < 4; q++) {
			fill(from, ends[k], cubic, f);
			fill(to[q], WHOLE, cubic, want);
			assert_int_equal(resample_cubic(from, ends[k], f, to[q], e), 0);
			assert_true(largest(to[q].nu*to[q].nv, e, want) < 1e-12);
		}
}

static void
shared_nodes_keep_their_bits(void **state)
{
	Chart from = { 12, 9, 0.8, &CHART_RECTANGLE }, to = { 23, 17, 0.8, &CHART_RECTANGLE };
	unsigned long long seed = 3;
	double f[12*9], e[23*17];
	int i, j;

	(void)state;
	for (i = 0; i < 12*9; i++)
		f[i] = noise(&seed);
	resample_cubic(from, WHOLE, f, to, e);
	for (j = 0; j < 9; j++)
		for (i = 0; i < 12; i++)
			assert_true(e[2*j*23+2*i] == f[j*12+i]);
}

static void
means_keep_what_is_straight(void **state)
{
	static const Chart to[] = { { 12, 9, 0.8, &CHART_RECTANGLE }, { 11, 8, 0.8, &CHART_RECTANGLE },
		{ 9, 9, 0.8, &CHART_RECTANGLE } };
	Chart from = { 23, 17, 0.8, &CHART_RECTANGLE };
	double f[23*17], e[12*9], want[12*9];
	int q;

	(void)state;
	for (q = 0; q < 2; q++) {
		fill(from, WHOLE, straight, f);
		fill(to[q], WHOLE, straight, want);
		assert_int_equal(resample_mean(from, f, to[q], e), 0);
		assert_true(largest(to[q].nu*to[q].nv, e, want) < (q == 0 ? 1e-14 : 0.02));
	}
}

/* Averaging removes a field that alternates in sign from node to node, which the coarse grid cannot
 * represent. */
static void
means_drop_alternating_fields(void **state)
{
	Chart from = { 23, 17, 0.8, &CHART_RECTANGLE }, to = { 12, 9, 0.8, &CHART_RECTANGLE };
	double f[23*17], e[12*9];
	int i, j;

	(void)state;
	for (j = 0; j < 17; j++)
		for (i = 0; i < 23; i++)
			f[j*23+i] = (i + j)%2 ? 1 : -1;
	resample_mean(from, f, to, e);
	for (j = 1; j < 8; j++)
		for (i = 1; i < 11; i++)
			assert_true(fabs(e[j*12+i]) < 1e-14);
}

enum { SIDE = 160*65 };

/* The largest error of the height of a cap, resampled to a sock with nu columns from one with a third
 * fewer (cubic), or from a finer one (mean).  The height is smooth across the fold. */
static double
error_on_the_sock(int nu, int mean)
{
	static double f[3*SIDE], e[SIDE], want[3*SIDE];
	int other = mean ? nu*2 : nu*2/3/2*2;
	Chart from = { other, other/2 + 1, 0.5, &CHART_SOCK }, to = { nu, nu/2 + 1, 0.5, &CHART_SOCK };

	sample_sockcap(from, 1, (double *[3]){ f + SIDE, f + 2*SIDE, f }, NULL, NULL);
	sample_sockcap(to, 1, (double *[3]){ want + SIDE, want + 2*SIDE, want }, NULL, NULL);
	if (mean)
		assert_int_equal(resample_mean(from, f, to, e), 0);
	else
		assert_int_equal(resample_cubic(from, WHOLE, f, to, e), 0);
	return largest((size_t)to.nu*to.nv, e, want);
}

/* The error is of fourth order for interpolation and of second order for means, across joined sides too. */
static void
errors_on_the_sock_have_their_order(void **state)
{
	(void)state;
	assert_true(error_on_the_sock(60, 0) < error_on_the_sock(30, 0)/12);
	assert_true(error_on_the_sock(60, 1) < error_on_the_sock(30, 1)/3.5);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(cubics_are_exact),
		cmocka_unit_test(shared_nodes_keep_their_bits),
		cmocka_unit_test(means_keep_what_is_straight),
		cmocka_unit_test(means_drop_alternating_fields),
		cmocka_unit_test(errors_on_the_sock_have_their_order),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
