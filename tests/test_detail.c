/* test_detail.c - detail.h: points stored as offsets from a gridded surface are restored from the
 * same surface, and move, turn and grow with a changed one. */
#include "cmock.h"

#include <math.h>
#include <stdlib.h>

#include "../lib/grid/detail.h"

enum { NU = 33, NV = 41, NODES = NU*NV, POINTS = 300 };

static const Chart G = { NU, NV, 1.2, &CHART_RECTANGLE };

/* A curved surface; coordinate c of node p is x[c][p]. */
static void
sheet(double x[3][NODES])
{
	int i, j;

	for (j = 0; j < NV; j++)
		for (i = 0; i < NU; i++) {
			const double u = (double)i/(NU - 1), v = G.T*j/(NV - 1);

			x[0][j*NU + i] = u + 0.1*sin(3*v);
			x[1][j*NU + i] = v - 0.2*u*u;
			x[2][j*NU + i] = 0.3*cos(4*u)*sin(2*v + u);
		}
}

static void
rows(double x[3][NODES], const double *phi[3])
{
	phi[0] = x[0], phi[1] = x[1], phi[2] = x[2];
}

/* Point p: its (u,v), for small p at corners and sides of the chart, and its position x, near the
 * surface or far from it. */
static void
point(int p, double *u, double *v, double x[3])
{
	static const double away[5] = { 0, 1e-6, 0.02, 0.3, 5 };

	*u = p < 8 ? p%2 : fmod(0.618*p, 1);
	*v = p < 4 ? p/2*G.T : G.T*fmod(0.755*p, 1);
	x[0] = *u + away[p%5]*sin(p);
	x[1] = *v + away[p%5]*cos(2*p);
	x[2] = away[p%5]*sin(3*p);
}

static double
apart(const double a[3], const double b[3])
{
	return fmax(fabs(a[0] - b[0]), fmax(fabs(a[1] - b[1]), fabs(a[2] - b[2])));
}

static void
the_same_grid_gives_the_points_back(void **state)
{
	static double x[3][NODES];
	double at[3], back[3], o[DETAIL_SIZE], u, v;
	const double *phi[3];
	Detail d;
	int p;

	(void)state;
	sheet(x), rows(x, phi);
	assert_int_equal(detail_init(&d, G, phi), 0);
	for (p = 0; p < POINTS; p++) {
		point(p, &u, &v, at);
		detail_offset(&d, u, v, at, o);
		detail_vertex(&d, G.T, u, v, o, back);
		assert_true(apart(at, back) < 1e-14*(1 + fabs(at[0]) + fabs(at[1]) + fabs(at[2])));
	}
	detail_free(&d);
}

/* The similarity b = 7 R a + t with a rotation R. */
static void
motion(const double a[3], double b[3])
{
	static const double R[3][3] = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } };
	static const double t[3] = { 3, -50, 8 };
	int i;

	for (i = 0; i < 3; i++)
		b[i] = 7*(R[i][0]*a[0] + R[i][1]*a[1] + R[i][2]*a[2]) + t[i];
}

static void
offsets_follow_a_similarity(void **state)
{
	static double x[3][NODES], y[3][NODES];
	double at[3], back[3], want[3], o[DETAIL_SIZE], u, v;
	const double *phi[3], *psi[3];
	Detail d, e;
	int c, p;

	(void)state;
	sheet(x), rows(x, phi), rows(y, psi);
	for (p = 0; p < NODES; p++) {
		double a[3] = { x[0][p], x[1][p], x[2][p] };

		motion(a, want);
		for (c = 0; c < 3; c++)
			y[c][p] = want[c];
	}
	assert_int_equal(detail_init(&d, G, phi), 0);
	assert_int_equal(detail_init(&e, G, psi), 0);
	for (p = 0; p < POINTS; p++) {
		point(p, &u, &v, at);
		detail_offset(&d, u, v, at, o);
		detail_vertex(&e, G.T, u, v, o, back);
		motion(at, want);
		assert_true(apart(want, back) < 1e-11);
	}
	detail_free(&d);
	detail_free(&e);
}

/* An offset can be transferred to a surface on a chart of another height: the caller scales v, and
 * detail_vertex scales the height of the window. */
static void
another_height(void **state)
{
	static double x[3][NODES];
	Chart g = G;
	double o[DETAIL_SIZE] = { 0, 0, 0.1, 0.25 }, a[3], b[3], n;
	const double *phi[3];
	Detail d, e;
	int i;

	(void)state;
	for (i = 0; i < NODES; i++)
		x[0][i] = i%NU/(NU - 1.), x[1][i] = G.T*(i/NU)/(NV - 1), x[2][i] = 0;
	rows(x, phi);
	g.T = 2*G.T;
	assert_int_equal(detail_init(&d, G, phi), 0);
	assert_int_equal(detail_init(&e, g, phi), 0);
	detail_vertex(&d, G.T, 0.5, 0.4, o, a);
	detail_vertex(&e, G.T, 0.5, 0.8, o, b);
	n = sqrt((1 + 0.25)/2);         /* lambda: |phi_u| = 1, |phi_v| = 1/2 */
	assert_true(fabs(a[0] - 0.5) + fabs(a[1] - 0.4) + fabs(a[2] - 0.1) < 1e-14);
	assert_true(fabs(b[0] - 0.5) + fabs(b[1] - 0.4) + fabs(b[2] - 0.1*n) < 1e-14);
	detail_free(&d);
	detail_free(&e);
}

/* A long offset has a wide window: its frame is that of a whole neighbourhood, and a tilted bump
 * inside the window does not turn it.  A short offset with the smallest window, r = 0, turns with the
 * bump. */
static void
limbs_follow_their_root(void **state)
{
	static double x[3][NODES], y[3][NODES];
	const double long_[3] = { 0.5, 0.6, 1 };
	double o[DETAIL_SIZE], a[3];
	const double *phi[3], *psi[3];
	Detail d, e;
	int i;

	(void)state;
	for (i = 0; i < NODES; i++) {
		const double u = i%NU/(NU - 1.), v = G.T*(i/NU)/(NV - 1), r = hypot(u - 0.5, v - 0.6)/0.2;

		x[0][i] = y[0][i] = u, x[1][i] = y[1][i] = v, x[2][i] = 0;
		y[2][i] = r < 1 ? (u - 0.5)*0.8*(1 - r*r) : 0;         /* tilted in the middle */
	}
	rows(x, phi), rows(y, psi);
	assert_int_equal(detail_init(&d, G, phi), 0);
	assert_int_equal(detail_init(&e, G, psi), 0);
	detail_offset(&d, 0.5, 0.6, long_, o);
	assert_true(o[3] >= 0.6);
	detail_vertex(&e, G.T, 0.5, 0.6, o, a);
	assert_true(fabs(a[0] - 0.5) < 1e-12 && fabs(a[1] - 0.6) < 1e-12 && a[2] > 1 && a[2] < 1.02);
	o[2] = 0.01, o[3] = 0;
	detail_vertex(&e, G.T, 0.5, 0.6, o, a);
	assert_true(a[0] - 0.5 < -0.006);
	detail_free(&d);
	detail_free(&e);
}

/* On surfaces that have shrunk to a line or a point all results are finite, and on a line the point
 * is still restored. */
static void
without_area(void **state)
{
	static double x[3][NODES];
	const double at[3] = { 0.4, 0.2, 0.1 };
	double o[DETAIL_SIZE], a[3];
	const double *phi[3];
	Detail d;
	int axis, i;

	(void)state;
	rows(x, phi);
	for (axis = 0; axis < 3; axis++) {
		for (i = 0; i < NODES; i++)
			x[0][i] = axis == 0 ? i%NU : axis == 1 ? i/NU : 0;
		assert_int_equal(detail_init(&d, G, phi), 0);
		detail_offset(&d, 0.3, 0.2, at, o);
		assert_true(isfinite(o[0]) && isfinite(o[1]) && isfinite(o[2]) && o[3] >= 0 && o[3] <= 1.2);
		detail_vertex(&d, G.T, 0.3, 0.2, o, a);
		assert_true(isfinite(a[0]) && isfinite(a[1]) && isfinite(a[2]));
		assert_true(axis == 2 || apart(at, a) < 1e-13);
		detail_free(&d);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(the_same_grid_gives_the_points_back),
		cmocka_unit_test(offsets_follow_a_similarity),
		cmocka_unit_test(another_height),
		cmocka_unit_test(limbs_follow_their_root),
		cmocka_unit_test(without_area),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
