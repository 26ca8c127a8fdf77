/* test_outline.c - outline.h: the outline of smooth and ragged closed curves. */
#include "cmock.h"

#include <math.h>

#include "../lib/morph/outline.h"

#define assert_near(x, want, error) assert_true(fabs((x) - (want)) <= (error))

enum { N = 512, M = 3000 };

/* A circle of radius r about (5r,-3r,2r).  Its second half is ragged and therefore much longer. */
static void
circle(double r, double ragged, double *x)
{
	double a, q;
	int i;

	for (i = 0; i < M; i++) {
		a = 2*M_PI*i/M;
		q = i < M/2 ? 1 : 1 + ragged*sin(200*a);
		x[3*i] = r*(5 + q*cos(a));
		x[3*i+1] = r*(-3 + q*sin(a));
		x[3*i+2] = r*2;
	}
}

static void
circles(void **state)
{
	static const double size[] = { 1, 1e-200, 1e200 };
	double x[3*M], a;
	Outline o;
	int u, k;

	(void)state;
	for (u = 0; u < 3; u++) {
		circle(size[u], 0, x);
		assert_int_equal(outline_init(&o, N, M, x), 0);
		for (k = 0; k < N; k++) {
			a = 2*M_PI*k/N;
			assert_near(o.x[3*k], cos(a), 1e-5);
			assert_near(o.x[3*k+1], sin(a), 1e-5);
			assert_near(o.x[3*k+2], 0, 1e-12);
			assert_near(outline_place(&o, (double)k/N), (double)k/N, 1e-7);
		}
		outline_free(&o);
	}
}

/* Along the outline, the ragged half of the circle takes half the length, though the curve itself
 * is much longer there. */
static void
ragged(void **state)
{
	double x[3*M], length = 0, half = 0, p;
	Outline o;
	int i;

	(void)state;
	circle(1, 0.01, x);
	for (i = 0; i < M; i++) {
		double d = hypot(x[3*((i+1)%M)] - x[3*i], x[3*((i+1)%M)+1] - x[3*i+1]);

		length += d;
		half += i < M/2 ? d : 0;
	}
	assert_true(half < 0.4*length);
	assert_int_equal(outline_init(&o, N, M, x), 0);
	assert_near(outline_place(&o, half/length), 0.5, 0.02);
	for (p = 0; p <= 1; p += 1.0/64)
		assert_near(outline_back(&o, outline_place(&o, p)), p, 1e-9);
	for (i = 0; i < N; i++)
		assert_near(o.x[3*i+2], 0, 1e-12);
	outline_free(&o);
}

static void
no_curves(void **state)
{
	double x[9] = { 1, 2, 3, 1, 2, 3, 1, 2, 3 };
	Outline o;

	(void)state;
	assert_int_equal(outline_init(&o, N, 3, x), OUTLINE_EVALUE);
	assert_int_equal(outline_init(&o, N, 1, x), OUTLINE_EVALUE);
	x[4] = NAN;
	assert_int_equal(outline_init(&o, N, 3, x), OUTLINE_EVALUE);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(circles), cmocka_unit_test(ragged), cmocka_unit_test(no_curves)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
