/* test_cornerunfold.c - cornerunfold.h: folded cells at ragged corners are turned back, others stay. */
#include "cmock.h"

#include "../lib/base/corner.h"
#include "../lib/grid/cornerfold.h"
#include "../lib/grid/cornerunfold.h"
#include "surfaces.h"

enum { NU = 41, NV = 37, N = NU*NV };
static const Chart chart = { NU, NV, 0.8, &CHART_RECTANGLE };
static double phi[3*N], before[3*N], lambda[N], H[N];
static double *x[3] = { phi, phi + N, phi + 2*N };
static const double *const now[3] = { phi, phi + N, phi + 2*N };

static void
start(void)
{
	sample_immersion(stereo, chart, 1, x, lambda, H);
}

/* Moves node (a,b) from corner k by a share of the way to node (a+da,b+db). */
static void
push(int k, int a, int b, int da, int db, double share)
{
	int p = corner_node(chart, k, a, b), q = corner_node(chart, k, a + da, b + db), c;

	for (c = 0; c < 3; c++)
		x[c][p] += share*(x[c][q] - x[c][p]);
}

static int
folds(int k)
{
	return corner_folds(chart, k, now, corner_radius(chart));
}

static void
unfold(int k)
{
	memcpy(before, phi, sizeof phi);
	corner_unfold(chart, k, x, corner_radius(chart));
}

/* Whether all nodes that moved are inner nodes of the block of corner k. */
static int
only_the_block(int k)
{
	char inside[N] = { 0 };
	int a, b, p;

	for (b = 1; b < corner_radius(chart); b++)
		for (a = 1; a < corner_radius(chart); a++)
			inside[corner_node(chart, k, a, b)] = 1;
	for (p = 0; p < 3*N; p++)
		if (phi[p] != before[p] && !inside[p%N])
			return 0;
	return 1;
}

static void
inner_and_border_folds_are_turned_back(void **state)
{
	int k;

	(void)state;
	for (k = 0; k < 4; k++) {
		start();
		push(k, 1, 1, 1, 1, 1.6);
		assert_true(folds(k) > 0);
		unfold(k);
		assert_int_equal(folds(k), 0);
		assert_true(only_the_block(k));
		start();
		push(k, 3, 0, -1, 0, 2.4);
		push(k, 0, 2, 0, 1, 1.8);
		assert_true(folds(k) > 0);
		unfold(k);
		assert_int_equal(folds(k), 0);
		assert_true(only_the_block(k));
	}
}

static void
what_is_not_folded_or_cannot_be_helped_stays(void **state)
{
	(void)state;
	start();
	unfold(0);
	assert_memory_equal(phi, before, sizeof phi);
	push(0, corner_radius(chart), 4, 1, 0, 4);
	assert_true(folds(0) > 0);
	unfold(0);
	assert_memory_equal(phi, before, sizeof phi);
}

/* The mirror image of a corner, and the one of the transposed chart, are unfolded alike. */
static void
mirrored_and_transposed_corners_are_unfolded_alike(void **state)
{
	static double out[3*N], turned[3*N];
	static double *const t[3] = { turned, turned + N, turned + 2*N };
	const Chart tall = { NV, NU, 1/chart.T, &CHART_RECTANGLE };
	int mirror, i, j, c;

	(void)state;
	start();
	push(0, 3, 0, -1, 0, 2.4);
	push(0, 1, 1, 1, 0, 1.5);
	for (c = 0; c < 3; c++)
		for (j = 0; j < NV; j++)
			for (i = 0; i < NU; i++)
				t[c][i*NV + j] = x[c][j*NU + i];
	memcpy(before, phi, sizeof phi);
	corner_unfold(chart, 0, x, corner_radius(chart));
	memcpy(out, phi, sizeof phi);
	assert_true(largest(3*N, phi, before) > 0);
	corner_unfold(tall, 0, t, corner_radius(tall));
	for (mirror = 0; mirror < 2; mirror++) {
		for (c = 0; c < 3 && mirror; c++)
			for (j = 0; j < NV; j++)
				for (i = 0; i < NU; i++)
					x[c][j*NU + i] = before[c*N + j*NU + NU - 1 - i];
		if (mirror)
			corner_unfold(chart, 1, x, corner_radius(chart));
		for (c = 0; c < 3; c++)
			for (j = 0; j < NV; j++)
				for (i = 0; i < NU; i++)
					assert_true(fabs((mirror ? x[c][j*NU + NU - 1 - i] : t[c][i*NV + j])
					    - out[c*N + j*NU + i]) < 1e-12);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(inner_and_border_folds_are_turned_back),
		cmocka_unit_test(what_is_not_folded_or_cannot_be_helped_stays),
		cmocka_unit_test(mirrored_and_transposed_corners_are_unfolded_alike),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
