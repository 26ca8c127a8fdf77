/* test_borderlength.c - borderlength.h: lambda of a blend and the length of its border. */
#include "cmock.h"

#include <complex.h>
#include <math.h>

#include "../lib/grid/stencil.h"
#include "../lib/morph/borderlength.h"

enum { MOST = 130*130 };

static double e[MOST];

/* The border of the plane surface f(u + i v). */
static void
plane_border(Chart g, double complex (*f)(double complex), Border *b)
{
	int i, j, q;

	assert_int_equal(border_init(b, g), 0);
	for (j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++) {
			double complex z = f(chart_u(g, i) + I*chart_v(g, j));

			q = border_number(g, i, j);
			if (q < 0)
				continue;
			b->x[3*q] = creal(z);
			b->x[3*q+1] = cimag(z);
			b->x[3*q+2] = 1;
		}
	assert_int_equal(border_measure(b), 0);
}

static double complex same(double complex z) { return z; }
static double complex turned(double complex z) { return cexp(I*M_PI/3)*z; }
static double complex exponential(double complex z) { return cexp(z); }
static double complex half_turned(double complex z) { return (z + turned(z))/2; }
static double complex half_exponential(double complex z) { return (z + cexp(z))/2; }

/* The largest difference of e from log |f'|, blended map, less the blend of both logarithms, at inner nodes. */
static double
distance(Chart g, double complex (*f)(double complex), double complex (*half)(double complex))
{
	static const double w[2] = { 0.5, 0.5 };
	Border a, b, to;
	const Border *const of[2] = { &a, &b };
	double most = 0, step = 1e-5;
	int p;

	plane_border(g, same, &a);
	plane_border(g, f, &b);
	plane_border(g, half, &to);
	assert_int_equal(borderlength(2, w, of, &to, e), 0);
	for (p = 0; p < g.nu*g.nv; p++) {
		double complex z = chart_u(g, p%g.nu) + I*chart_v(g, p/g.nu);
		double l = cabs(half(z + step) - half(z - step)), l2 = cabs(f(z + step) - f(z - step));

		if (stencil_is_inner(g, p%g.nu, p/g.nu))
			most = fmax(most, fabs(e[p] - log(l/sqrt(2*step*l2))));
	}
	border_free(&a);
	border_free(&b);
	border_free(&to);
	return most;
}

/* Half way of a turn by 60 degrees, lengths are those of cos 30 degrees. */
static void
shortened_by_turning(void **state)
{
	(void)state;
	assert_true(distance((Chart){ 17, 12, 0.7, &CHART_RECTANGLE }, turned, half_turned) < 1e-10);
	assert_true(fabs(e[0] - log(cos(M_PI/6))) < 1e-13);
}

/* Blends of conformal maps of the plane are conformal: then lambda e^e is their conformal factor. */
static void
conformal_factor_of_plane_blends(void **state)
{
	double coarse = distance((Chart){ 33, 33, 0.8, &CHART_RECTANGLE }, exponential, half_exponential);
	double fine = distance((Chart){ 65, 65, 0.8, &CHART_RECTANGLE }, exponential, half_exponential);

	(void)state;
	assert_true(fine < 1e-4);
	assert_true(coarse > 3.5*fine);
}

static void
scaled_sock(void **state)
{
	static const double w[2] = { 0.5, 0.5 };
	Chart g = { 16, 9, 0.6, &CHART_SOCK };
	Border a, b, to;
	const Border *const of[2] = { &a, &b };
	int p;

	(void)state;
	plane_border(g, exponential, &a);
	plane_border(g, exponential, &b);
	plane_border(g, exponential, &to);
	for (p = 0; p < 3*b.n; p++) {
		b.x[p] *= 4;
		to.x[p] *= 2.5;
	}
	assert_int_equal(border_measure(&b), 0);
	assert_int_equal(border_measure(&to), 0);
	assert_int_equal(borderlength(2, w, of, &to, e), 0);
	for (p = 0; p < g.nu*g.nv; p++)
		assert_true(fabs(e[p] - log(1.25)) < 1e-13);
	border_free(&a);
	border_free(&b);
	border_free(&to);
}

/* An edge of no length, and one that is far longer in the blend. */
static void
bounded(void **state)
{
	static const double one[1] = { 1 };
	Chart g = { 9, 9, 1, &CHART_RECTANGLE };
	Border a, to;
	const Border *const of[1] = { &a };
	int p, c;

	(void)state;
	plane_border(g, same, &a);
	plane_border(g, same, &to);
	for (c = 0; c < 3; c++) {
		to.x[9+c] = to.x[6+c] = to.x[12+c];
		to.x[60+c] *= 1000;
	}
	assert_int_equal(border_measure(&to), 0);
	assert_int_equal(borderlength(1, one, of, &to, e), 0);
	for (p = 0; p < g.nu*g.nv; p++)
		assert_true(fabs(e[p]) <= 2);
	assert_true(e[3] == -2 && fabs(e[5]) < 1e-12);
	border_free(&a);
	border_free(&to);
}

static void
tiny_grids(void **state)
{
	static const double one[1] = { 1 };
	Chart g = { 2, 5, 1, &CHART_RECTANGLE };
	Border a;
	const Border *const of[1] = { &a };

	(void)state;
	plane_border(g, same, &a);
	e[0] = e[9] = 5;
	assert_int_equal(borderlength(1, one, of, &a, e), 0);
	assert_true(e[0] == 0 && e[9] == 0);
	border_free(&a);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(shortened_by_turning),
		cmocka_unit_test(conformal_factor_of_plane_blends),
		cmocka_unit_test(scaled_sock),
		cmocka_unit_test(bounded),
		cmocka_unit_test(tiny_grids),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
