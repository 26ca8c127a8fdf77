/* test_inverse.c - inverse.h: the inverse of smooth shifts, and of folded ones. */
#include "cmock.h"

#include <math.h>

#include "../lib/grid/bicubic.h"
#include "../lib/map/inverse.h"

enum { N = 33, NODES = N*N };

static const Chart CHART = { N, N, 1, &CHART_RECTANGLE };

/* A shift of about `size` cells that keeps the sides; if `turned`, the same with u and v exchanged. */
static void
wave(double size, int turned, double *du, double *dv)
{
	int i, j;

	for (j = 0; j < N; j++)
		for (i = 0; i < N; i++) {
			double x = M_PI*i/(N - 1), y = M_PI*j/(N - 1);
			double a = size*sin(3*x)*(1 + cos(2*y)), b = size*sin(2*y)*cos(5*x)/2;
			int p = turned ? i*N + j : j*N + i;

			(turned ? dv : du)[p] = a;
			(turned ? du : dv)[p] = b;
		}
}

static void
inverse_of(double size, int turned, double x[NODES], double y[NODES])
{
	static double du[NODES], dv[NODES];
	Shift s = { du, dv, 1 };

	wave(size, turned, du, dv);
	assert_int_equal(shift_inverse(CHART, &s, x, y), 0);
}

static void
smooth_shifts_are_inverted(void **state)
{
	static double du[NODES], dv[NODES], x[NODES], y[NODES];
	int p;

	(void)state;
	wave(.8, 0, du, dv);
	inverse_of(.8, 0, x, y);
	for (p = 0; p < NODES; p++) {
		Bicubic at = bicubic_at((Chart){ N, N, 1, &CHART_RECTANGLE }, x[p], y[p]);

		assert_true(fabs(x[p] + bicubic_value(&at, du) - p%N) < 1e-8);
		assert_true(fabs(y[p] + bicubic_value(&at, dv) - p/N) < 1e-8);
	}
}

/* Where cells are folded, each node still has a point that goes to about this node, and the points do
 * not depend on which axis is called u. */
static void
folded_shifts_are_inverted_in_one_way(void **state)
{
	static double du[NODES], dv[NODES], x[NODES], y[NODES], a[NODES], b[NODES];
	int p, folded = 0;

	(void)state;
	wave(4, 0, du, dv);
	inverse_of(4, 0, x, y);
	inverse_of(4, 1, a, b);
	for (p = 0; p < NODES; p++) {
		Bicubic at = bicubic_at((Chart){ N, N, 1, &CHART_RECTANGLE }, x[p], y[p]);
		int q = p%N*N + p/N;

		folded += p%N < N - 1 && 1 + du[p+1] - du[p] < 0;
		assert_true(hypot(x[p] + bicubic_value(&at, du) - p%N, y[p] + bicubic_value(&at, dv) - p/N) < .3);
		assert_true(fabs(a[q] - y[p]) < 1e-9 && fabs(b[q] - x[p]) < 1e-9);
	}
	assert_true(folded > 0);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(smooth_shifts_are_inverted),
		cmocka_unit_test(folded_shifts_are_inverted_in_one_way),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
