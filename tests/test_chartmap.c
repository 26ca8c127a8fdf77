/* test_chartmap.c - chartmap.h: rectangle, disk and sock are carried onto each other; cones.h. */
#include <math.h>
#include <stdlib.h>

#include "cmock.h"

#include "../lib/map/chartmap.h"
#include "../lib/map/harmonic.h"
#include "../lib/map/cones.h"

static const double complex A = 0.3 + 0.2*I, B = -0.4 + 0.5*I;

/* From the rectangle to the sock, to its place and back; the boundary goes to the boundary. */
static void
round_trip(void **state)
{
	static const double height[] = { .4, .7, 1, 1.05, 3 };
	double u, v, x, y, X, Y;
	int t, p, border, n = 40;

	(void)state;
	for (t = 0; t < 5; t++) {
		ChartMap m = chartmap_sock(height[t], A, B);

		for (p = 0; p < (n + 1)*(n + 1); p++) {
			int i = p%(n + 1), j = p/(n + 1);

			border = i == 0 || j == 0 || i == n || j == n;
			chartmap_uv(&m, i/(double)n, height[t]*j/n, &u, &v);
			assert_true(border ? v == m.chart_T : v < m.chart_T);
			chartmap_place(&m, u, v, &x, &y);
			chartmap_clamp(&m, border, &x, &y);
			chartmap_point(&m, x, y, &X, &Y);
			/* the disk is smooth at the corners, so the rectangle has a square root there */
			assert_true(hypot(X - i/(double)n, Y - height[t]*j/n) < (border ? 1e-7 : 1e-12)*(1 + height[t]));
		}
	}
}

/* Points next to each other on the circle are next to each other on the sides of the rectangle: rounding
 * does not put them on the opposite side. */
static void
the_circle_goes_round_the_sides(void **state)
{
	ChartMap m = chartmap_sock(1.05, A, B);
	double x, y, X, Y, before[2] = { 0, 0 };
	int i, n = 100000;

	(void)state;
	for (i = 0; i <= n; i++) {
		x = cos(2*M_PI*i/n), y = sin(2*M_PI*i/n);
		chartmap_clamp(&m, 1, &x, &y);
		chartmap_point(&m, x, y, &X, &Y);
		assert_true(fmin(fmin(X, 1 - X), fmin(Y, m.T - Y)) < 1e-7);
		if (i)
			assert_true(hypot(X - before[0], Y - before[1]) < 0.02);
		before[0] = X, before[1] = Y;
	}
}

/* On a rectangle the nodes of a side are put on it exactly. */
static void
the_sides_of_a_rectangle_are_kept(void **state)
{
	ChartMap m = chartmap_rectangle(3.3);
	double x = 1 - 1e-16, y = 1e-29;

	(void)state;
	chartmap_clamp(&m, SIDE_BOTTOM, &x, &y);
	assert_true(x == 1 - 1e-16 && y == 0);
	chartmap_clamp(&m, SIDE_RIGHT, &x, &y);
	assert_true(x == 1 && y == 0);
	x = 1e-29, y = 3.3 - 1e-15;
	chartmap_clamp(&m, SIDE_LEFT | SIDE_TOP, &x, &y);
	assert_true(x == 0 && y == 3.3);
	x = -.1, y = 4;
	chartmap_clamp(&m, 0, &x, &y);
	assert_true(x == 0 && y == 3.3);
}

/* The map from the rectangle to the sock is conformal, and keeps the orientation. */
static void
the_map_is_conformal(void **state)
{
	ChartMap m = chartmap_sock(0.7, A, B);
	double e = 1e-5, x, y, u[5], v[5], a[4];
	int i, j, k;

	(void)state;
	for (j = 1; j < 10; j++)
		for (i = 1; i < 10; i++) {
			x = i/10., y = .7*j/10;
			chartmap_uv(&m, x, y, &u[0], &v[0]);
			chartmap_uv(&m, x + e, y, &u[1], &v[1]);
			chartmap_uv(&m, x - e, y, &u[2], &v[2]);
			chartmap_uv(&m, x, y + e, &u[3], &v[3]);
			chartmap_uv(&m, x, y - e, &u[4], &v[4]);
			for (k = 0; k < 2; k++) {
				a[2*k] = (u[2*k+1] - u[2*k+2])/(2*e);
				a[2*k+1] = (v[2*k+1] - v[2*k+2])/(2*e);
			}
			if (fabs(a[0]) + fabs(a[2]) > 100)
				continue;               /* across the seam */
			assert_true(fabs(a[0] - a[3]) + fabs(a[1] + a[2]) < 1e-6*(1 + fabs(a[0]) + fabs(a[1])));
			assert_true(a[0]*a[3] - a[1]*a[2] > 0);
		}
}

/* If the surface is itself a flat sock, its cones are found, and chi^2 is 1. */
static void
the_cones_of_a_flat_sock_are_found(void **state)
{
	enum { N = 1000 };
	Parts p = { N, malloc(N*sizeof(double)), malloc(N*sizeof(double)), malloc(N*sizeof(double complex)) };
	const double complex at[2] = { 0.5, -0.3 + 0.4*I };
	double complex cone[2], corner[4] = { 1, I, -1, -I };
	int i, k, l;

	(void)state;
	for (i = 0; i < N; i++) {               /* a spiral of equal parts of the disk */
		p.z[i] = sqrt((i + .5)/N)*cexp(I*i*2.399963);
		p.S[i] = M_PI/N;
		for (p.A[i] = p.S[i], k = 0; k < 2; k++)
			p.A[i] /= sqrt(pow(cabs(p.z[i] - at[k]), 2) + p.S[i]/16)*cabs(1 - conj(at[k])*p.z[i]);
	}
	cones_choose(&p, cone);
	for (k = 0; k < 2; k++)
		for (l = 0; l < 2; l++)
			if (cabs(cone[l] - at[k]) < 0.01)
				cone[l] = at[k];
	assert_true((cone[0] == at[0] && cone[1] == at[1]) || (cone[0] == at[1] && cone[1] == at[0]));
	assert_true(parts_sock(&p, cone[0], cone[1]) < 1.001);
	assert_true(parts_rectangle(&p, corner) > 1.5);
	parts_free(&p);
}

/* Equal cells lose 1; a limb of .5 % of the surface with cells 36 times the mean counts for .13 of that; and one whose
 * cells cover it whole counts for a hundred times its share, however small they are in the chart. */
static void
lost_parts_count_as_lost(void **state)
{
	enum { N = 1000 };
	static double A[N], ratio[N];
	double lost[2];
	int i;

	(void)state;
	for (i = 0; i < N; i++)
		A[i] = 1, ratio[i] = 7;
	assert_true(fabs(parts_lost(N, A, ratio) - 1/1.01) < 1e-12);
	for (i = 0; i < 5; i++)
		ratio[i] = 7*36;
	assert_true(fabs(parts_lost(N, A, ratio) - 1/1.01 - 0.005*(36/1.36 - 1)) < 0.01);
	assert_true(fabs(parts_chi2(N, A, ratio) - 1) < 1e-12);
	for (i = 0; i < 5; i++)
		ratio[i] = 1e30;
	lost[0] = parts_lost(N, A, ratio);
	for (i = 0; i < 5; i++)
		ratio[i] = 1e300;
	lost[1] = parts_lost(N, A, ratio);
	assert_true(fabs(lost[0] - 0.995/1.01 - 0.5) < 0.01 && fabs(lost[1] - lost[0]) < 1e-12);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(round_trip),
		cmocka_unit_test(the_circle_goes_round_the_sides),
		cmocka_unit_test(the_sides_of_a_rectangle_are_kept),
		cmocka_unit_test(the_map_is_conformal),
		cmocka_unit_test(the_cones_of_a_flat_sock_are_found),
		cmocka_unit_test(lost_parts_count_as_lost),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
