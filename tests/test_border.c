/* test_border.c - border.h: the nodes of the border of a grid, places on it, and the place nearest
 * to a point. */
#include "cmock.h"

#include <math.h>

#include "../lib/grid/border.h"
#include "../lib/synth/rng.h"
#include "../lib/base/vec3.h"

#define assert_near(x, want, error) assert_true(fabs((x) - (want)) <= (error))

enum { NU = 7, NV = 5 };

/* The border of a rectangle of width 3 and height 10 in the plane z = 1. */
static void
rectangle(Border *b)
{
	int i, j, k;

	assert_int_equal(border_init(b, (Chart){ NU, NV, 1, &CHART_RECTANGLE }), 0);
	for (k = 0; k < b->n; k++) {
		border_node(NU, NV, k, &i, &j);
		b->x[3*k] = 3.0*i/(NU - 1);
		b->x[3*k+1] = 10.0*j/(NV - 1);
		b->x[3*k+2] = 1;
	}
	assert_int_equal(border_measure(b), 0);
}

static void
once_round(void **state)
{
	static const int size[][2] = { { 2, 2 }, { 2, 3 }, { 5, 2 }, { NU, NV } };
	static const int corner[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	int s, k, i, j, i0, j0, nu, nv;
	Border b;

	(void)state;
	for (s = 0; s < 4; s++) {
		nu = size[s][0], nv = size[s][1];
		assert_int_equal(border_init(&b, (Chart){ nu, nv, 1, &CHART_RECTANGLE }), 0);
		assert_int_equal(b.n, 2*(nu + nv) - 4);
		for (k = 0; k < b.n; k++) {
			border_node(nu, nv, k, &i, &j);
			assert_true(i == 0 || j == 0 || i == nu - 1 || j == nv - 1);
			assert_int_equal(border_index(nu, nv, i, j), k);
			border_node(nu, nv, (k + 1)%b.n, &i0, &j0);
			assert_int_equal(abs(i - i0) + abs(j - j0), 1);
			assert_true(border_place(&b, k) < border_place(&b, k + 1));
		}
		assert_true(border_place(&b, b.n) == 4);
		for (k = 0; k < 4; k++) {
			i = border_index(nu, nv, corner[k][0]*(nu - 1), corner[k][1]*(nv - 1));
			assert_true(border_place(&b, i) == k);
		}
		border_free(&b);
	}
}

/* The sides of the rectangle are straight and evenly divided: place k + t is the point at the
 * fraction t of side k. */
static void
places(void **state)
{
	static const double at[][4] = {         /* r, x, y, arc */
		{ 0, 0, 0, 0 }, { 0.25, 0.75, 0, 0.75 }, { 1, 3, 0, 3 }, { 1.7, 3, 7, 10 },
		{ 2.5, 1.5, 10, 14.5 }, { 3, 0, 10, 16 }, { 3.9, 0, 1, 25 }, { 3.999999, 0, 0.00001, 25.99999 }
	};
	double x[3], w;
	Border b;
	int k;

	(void)state;
	rectangle(&b);
	assert_near(b.s[b.n], 26, 1e-12);
	for (k = 0; k < 8; k++) {
		border_at(&b, at[k][0], x);
		assert_near(x[0], at[k][1], 1e-12);
		assert_near(x[1], at[k][2], 1e-12);
		assert_near(border_arc(&b, at[k][0]), at[k][3], 1e-12);
	}
	for (k = 0; k < b.n; k++) {
		assert_in_range(border_edge(&b, border_place(&b, k) + 1e-9, &w), k, k);
		border_at(&b, border_place(&b, k), x);
		assert_near(x[0], b.x[3*k], 1e-14);
		assert_near(x[1], b.x[3*k+1], 1e-14);
	}
	border_free(&b);
}

/* The place that border_nearest finds is no farther from the point than the best of 4000 places. */
static void
nearest(void **state)
{
	double x[3], y[3], e[3], d, r, least;
	uint64_t seed = 4;
	int i, k;
	Border b;

	(void)state;
	rectangle(&b);
	for (i = 0; i < 100; i++) {
		x[0] = 5*rng_unit(&seed) - 1, x[1] = 12*rng_unit(&seed) - 1, x[2] = 2*rng_unit(&seed);
		for (least = HUGE_VAL, k = 0; k < 4000; k++) {
			border_at(&b, k/1000.0, y);
			sub3(x, y, e);
			least = fmin(least, norm3(e));
		}
		r = border_nearest(&b, x, &d);
		assert_true(r >= 0 && r < 4);
		border_at(&b, r, y);
		sub3(x, y, e);
		assert_near(norm3(e), d, 1e-12);
		assert_true(d <= least + 1e-12 && d > least - 0.01);
	}
	border_free(&b);
}

static void
no_length(void **state)
{
	Border b;
	int k;

	(void)state;
	assert_int_equal(border_init(&b, (Chart){ 3, 3, 1, &CHART_RECTANGLE }), 0);
	for (k = 0; k < 3*b.n; k++)
		b.x[k] = 2;
	assert_int_equal(border_measure(&b), BORDER_ELENGTH);
	b.x[4] = 1.5e308;
	b.x[7] = -1.5e308;
	assert_int_equal(border_measure(&b), BORDER_ELENGTH);
	border_free(&b);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(once_round), cmocka_unit_test(places), cmocka_unit_test(nearest),
		cmocka_unit_test(no_length)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
