/* test_spread.c - numbers for vertices that have none: the mean of the neighbours before them, or the nearest's. */
#include <math.h>
#include <string.h>

#include "../lib/mesh/spread.h"
#include "cmock.h"

/* A strip of triangles over the points (0,0) (0,1) (1,0) (1,1) (2,0) .., and a vertex of no face. */
enum { NV = 9, NF = 6 };

static double xyz[3*NV];
static int idx[3*NF], first[NF+1];
static const Soup strip = { .nv = NV, .nf = NF, .xyz = xyz, .first = first, .idx = idx };

static void
make(void)
{
	int v, f, k;

	for (v = 0; v < NV; v++)
		xyz[3*v] = v/2, xyz[3*v+1] = v%2, xyz[3*v+2] = 0;
	for (f = 0; f < NF; f++)
		for (first[f] = 3*f, k = 0; k < 3; k++)
			idx[3*f+k] = f + k;
	first[NF] = 3*NF;
}

static void
means(void **state)
{
	unsigned char known[NV] = { 1, 1 };
	double f[2*NV] = { 1, 10, 5, 50 };
	Spread a;

	(void)state;
	make();
	assert_int_equal(spread_init(&a, &strip, known), 0);
	assert_int_equal(a.n, 6);               /* the vertex of no face is not reached */
	spread_mean(&a, 2, f);
	/* 2 is next to 0 once and to 1 twice; 3 to 1; 4 and 5 come after them: 4 is next to 2 once and to 3 twice */
	assert_float_equal(f[4], (1 + 5 + 5)/3., 1e-15);
	assert_float_equal(f[5], (10 + 50 + 50)/3., 1e-13);
	assert_float_equal(f[6], 5, 0);
	assert_float_equal(f[8], (f[4] + f[6] + f[6])/3, 1e-15);
	assert_float_equal(f[10], f[6], 1e-15);
	assert_float_equal(f[16], 0, 0);
	spread_free(&a);
	assert_null(a.vertex);
}

static void
without_nan(void **state)
{
	unsigned char known[NV] = { 1, 1 };
	double f[NV] = { NAN, 5 }, g[NV] = { NAN, INFINITY }, h[NV] = { 1e308, 1.7e308 };
	Spread a;

	(void)state;
	make();
	assert_int_equal(spread_init(&a, &strip, known), 0);
	spread_mean(&a, 1, f);
	spread_mean(&a, 1, g);
	spread_mean(&a, 1, h);                  /* their sums are too large for a double */
	assert_true(fabs(h[2]/((1 + 1.7 + 1.7)/3*1e308) - 1) < 1e-15);
	assert_float_equal(f[2], 5, 0);
	assert_float_equal(f[7], 5, 0);
	assert_true(isnan(g[2]) && isnan(g[7]));
	spread_free(&a);
}

static void
nearest(void **state)
{
	unsigned char known[NV] = { [0] = 1, [7] = 1 };
	static const double want[2][NV] = { { 3, 3, 3, 3, 3, 8, 8, 8, 0 }, { 3, 3, 3, 8, 8, 8, 8, 8, 0 } };
	Spread a;
	int i;

	(void)state;
	make();
	for (i = 0; i < 2; i++) {
		double f[NV] = { [0] = 3, [7] = 8 };

		xyz[0] = i ? -.5 : .5;          /* ways from 0 and from 7 to 4: 1.5 and 2; 2.5 and 2 */
		assert_int_equal(spread_init(&a, &strip, known), 0);
		spread_nearest(&a, 1, f);
		assert_memory_equal(f, want[i], sizeof f);
		spread_free(&a);
	}
}

static void
no_vertices(void **state)
{
	unsigned char known[NV] = { 1 };
	double f[NV] = { 2 };
	Spread a;

	(void)state;
	make();
	idx[4] = -7, idx[10] = NV;
	assert_int_equal(spread_init(&a, &strip, known), 0);
	spread_mean(&a, 1, f);
	assert_float_equal(f[2], 2, 0);
	spread_free(&a);
	memset(known, 1, sizeof known);
	assert_int_equal(spread_init(&a, &strip, known), 0);
	assert_int_equal(a.n, 0);
	spread_free(&a);
	memset(known, 0, sizeof known);
	assert_int_equal(spread_init(&a, &strip, known), 0);
	assert_int_equal(a.n, 0);
	spread_free(&a);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(means),
		cmocka_unit_test(without_nan),
		cmocka_unit_test(nearest),
		cmocka_unit_test(no_vertices)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
