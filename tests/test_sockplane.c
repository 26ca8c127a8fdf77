/* test_sockplane.c - the unit disk on the sock, and the sphere on the pillow: symmetries, round trips, derivatives, known
 * moduli. */
#include <math.h>

#include "cmock.h"

#include "../lib/base/chart.h"
#include "../lib/base/pillowplane.h"
#include "../lib/base/sheet.h"
#include "../lib/base/sockplane.h"

static const double HEIGHT[] = { .01, .05, .125, .2, .5, 1, 3 };
enum { HEIGHTS = sizeof HEIGHT/sizeof *HEIGHT, POINTS = 17 };

/* Point number q of POINTS*POINTS inside the chart. */
static void
point(const SockPlane *p, int q, double *u, double *v)
{
	*u = (q%POINTS + .3)/POINTS;
	*v = (q/POINTS + .4)/POINTS*p->T;
}

static void
test_all_sheets_have_one_image(void **state)
{
	static const Sheet sheet[3] = { { -1, 0 }, { 1, 1 }, { -1, 1 } };
	double u, v;
	int t, q, i;

	(void)state;
	for (t = 0; t < HEIGHTS; t++) {
		SockPlane p = sockplane(HEIGHT[t]);

		for (q = 0; q < POINTS*POINTS; q++)
			for (i = 0; i < 3; i++) {
				point(&p, q, &u, &v);
				assert_true(cabs(sockplane_z(&p, sheet_u(sheet[i], u), sheet_v(sheet[i], v)) -
				    sockplane_z(&p, u, v)) < 1e-12);
			}
	}
}

/* A triangle, its first corner at (u,v), is drawn on the cover; then each corner is known by its image in the
 * chart only.  All three on one sheet, it is the same triangle.  (At a cone angles are halved, so none is
 * above pi/2.) */
static void
triangle_on_one_sheet(double u, double v, double turn, double T)
{
	double x[3], y[3], X[3], Y[3], a[3], b[3];
	Sheet s[3];
	int first, k, l;

	for (k = 0; k < 3; k++) {
		x[k] = u + (k ? .02*cos(turn + 1.2*k) : 0);
		y[k] = v + (k ? .02*sin(turn + 1.2*k) : 0);
		if (y[k] > T)
			return;
		a[k] = y[k] < 0 ? -x[k] : x[k], b[k] = fabs(y[k]);
		a[k] -= floor(a[k]);
	}
	for (first = 0; first < 3; first++) {
		double at[3], bt[3];

		for (k = 0; k < 3; k++)
			at[k] = a[(k + first)%3], bt[k] = b[(k + first)%3];
		sheet_polygon(3, at, bt, s);
		for (k = 0; k < 3; k++)
			X[(k + first)%3] = sheet_u(s[k], at[k]), Y[(k + first)%3] = sheet_v(s[k], bt[k]);
		for (k = 0, l = 1; k < 3; k++, l = (k + 1)%3)
			assert_true(fabs(hypot(X[l] - X[k], Y[l] - Y[k]) - hypot(x[l] - x[k], y[l] - y[k])) < 1e-14);
		assert_true((X[1] - X[0])*(Y[2] - Y[0]) > (X[2] - X[0])*(Y[1] - Y[0]));
	}
}

/* At the cones, at the seam and the fold beside them, and elsewhere. */
static void
test_triangles_lie_on_one_sheet(void **state)
{
	static const double at[][2] = { { 0, 0 }, { .5, 0 }, { 0, .1 }, { .999, .09 }, { .25, 0 }, { .7, .004 }, { .3, .1 } };
	size_t i;
	int k;

	(void)state;
	for (i = 0; i < sizeof at/sizeof *at; i++)
		for (k = 0; k < 40; k++)
			triangle_on_one_sheet(at[i][0], at[i][1], 2*M_PI*(k + .3)/40, .2);
}

static void
test_boundary_is_the_circle_and_cones_are_s(void **state)
{
	int t, i;

	(void)state;
	for (t = 0; t < HEIGHTS; t++) {
		SockPlane p = sockplane(HEIGHT[t]);

		assert_true(cabs(sockplane_z(&p, 0, 0) + p.s) < 1e-14);
		assert_true(cabs(sockplane_z(&p, .5, 0) - p.s) < 1e-14);
		for (i = 0; i < POINTS; i++)
			assert_true(fabs(cabs(sockplane_z(&p, i/(double)POINTS, p.T)) - 1) < 1e-12);
	}
}

static void
test_round_trip(void **state)
{
	double u, v, U, V, du;
	int t, q;

	(void)state;
	for (t = 0; t < HEIGHTS; t++) {
		SockPlane p = sockplane(HEIGHT[t]);

		for (q = 0; q < POINTS*POINTS; q++) {
			point(&p, q, &u, &v);
			sockplane_uv(&p, sockplane_z(&p, u, v), &U, &V);
			du = fabs(U - u);
			/* where z is near the circle the rounding of z is magnified by 1/|dz/du| */
			assert_true(fmin(du, 1 - du) < 1e-13 + 1e-14/sockplane_stretch(&p, u, v));
			assert_true(fabs(V - v) < 1e-13 + 1e-14/sockplane_stretch(&p, u, v));
		}
	}
}

static void
test_height_of_the_distance_of_the_cones(void **state)
{
	int t;

	(void)state;
	for (t = 1; t < HEIGHTS; t++) {
		SockPlane p = sockplane(HEIGHT[t]);

		assert_true(fabs(sockplane_height(2*p.s/(1 + p.s*p.s)) - p.T) < 1e-7*p.T);
	}
	/* rho = 1/sqrt 2 is its own complement */
	assert_true(fabs(sockplane_height(M_SQRT1_2) - .25) < 1e-15);
}

static void
test_stretch_is_the_derivative(void **state)
{
	double u, v, e = 1e-5, du, dv;
	int t, q;

	(void)state;
	for (t = 1; t < HEIGHTS; t++) {
		SockPlane p = sockplane(HEIGHT[t]);

		for (q = 0; q < POINTS*(POINTS - 1); q++) {
			point(&p, q, &u, &v);
			du = cabs(sockplane_z(&p, u + e, v) - sockplane_z(&p, u - e, v))/(2*e);
			dv = cabs(sockplane_z(&p, u, v + e) - sockplane_z(&p, u, v - e))/(2*e);
			assert_true(fabs(du - dv) < 1e-5*(1 + 1/p.T));
			assert_true(fabs(du - sockplane_stretch(&p, u, v)) < 1e-5*(1 + 1/p.T));
		}
	}
}

/* The area of a hemisphere by the sum over the nodes of a sock. */
static void
test_round_factor_has_the_area_of_a_hemisphere(void **state)
{
	int i, j, t;

	(void)state;
	for (t = 2; t < HEIGHTS - 1; t++) {
		Chart g = { 128, (int)(128*HEIGHT[t] + .5) + 1, HEIGHT[t], &CHART_SOCK };
		SockPlane p = sockplane(g.T);
		double area = 0, r;

		for (j = 0; j < g.nv; j++)
			for (i = 0; i < g.nu; i++) {
				r = sockplane_round(&p, chart_u(g, i), chart_v(g, j));
				area += r*r*chart_h(g)*chart_k(g)*(j == g.nv - 1 ? .5 : 1);
			}
		assert_true(fabs(area/(2*M_PI) - 1) < 3e-4);
	}
}

/* ---- the pillow ------------------------------------------------------ */

static double complex
pillow_point(const PillowPlane *p, double u, double v)
{
	double complex Z[2];

	pillowplane_z(p, u, v, Z);
	return Z[0]/Z[1];
}

/* The cones, and the symmetries by turns about those of either fold: z is continued by the formula, through the
 * elliptic function of the sock, beyond v = T/2. */
static void
test_pillow_is_two_socks(void **state)
{
	double e = 1e-4;
	int t, i;

	(void)state;
	for (t = 2; t < HEIGHTS; t++) {
		PillowPlane p = pillowplane(2*HEIGHT[t]);
		double s = p.half.s;

		assert_true(cabs(pillow_point(&p, 0, 0) + s) < 1e-14*s && cabs(pillow_point(&p, .5, 0) - s) < 1e-14*s);
		assert_true(cabs(pillow_point(&p, 0, p.T) + 1/s) < 1e-13/s && cabs(pillow_point(&p, .5, p.T) - 1/s) < 1e-13/s);
		for (i = 0; i < POINTS; i++) {
			double u = (i + .3)/POINTS, v = p.T/2;
			double complex up = pillow_point(&p, u, v + e), down = pillow_point(&p, u, v - e);
			double complex right = pillow_point(&p, u + e, v), left = pillow_point(&p, u - e, v);

			assert_true(cabs((up - down) - I*(right - left)) < 1e-5*cabs(right - left));
			assert_true(cabs(pillow_point(&p, u, p.T) - pillow_point(&p, 1 - u, p.T)) < 1e-12*cabs(pillow_point(&p, u, p.T)));
		}
	}
}

static void
test_pillow_round_trip(void **state)
{
	double u, v, U, V, du, far;
	double complex Z[2];
	int t, q;

	(void)state;
	for (t = 0; t < HEIGHTS; t++) {
		PillowPlane p = pillowplane(2*HEIGHT[t]);

		for (q = 0; q < POINTS*POINTS; q++) {
			u = (q%POINTS + .3)/POINTS, v = (q/POINTS + .4)/POINTS*p.T;
			pillowplane_z(&p, u, v, Z);
			assert_true(fabs(fmax(cabs(Z[0]), cabs(Z[1])) - 1) < 1e-15);
			Z[0] *= 2 - I, Z[1] *= 2 - I;
			pillowplane_uv(&p, Z, &U, &V);
			du = fabs(U - u);
			far = 1e-13 + 1e-14/sockplane_stretch(&p.half, u, fmin(v, p.T - v));
			assert_true(fmin(du, 1 - du) < far && fabs(V - v) < far);
		}
	}
}

/* By the sum over the nodes. */
static void
test_pillow_round_factor_has_the_area_of_a_sphere(void **state)
{
	int p, t;

	(void)state;
	for (t = 2; t < HEIGHTS - 1; t++) {
		Chart g = { 128, (int)(256*HEIGHT[t] + .5), 2*HEIGHT[t], &CHART_PILLOW };
		double *lambda0 = malloc((size_t)g.nu*g.nv*sizeof *lambda0), area = 0;

		assert_non_null(lambda0);
		chart_round(g, lambda0);
		for (p = 0; p < g.nu*g.nv; p++)
			area += lambda0[p]*lambda0[p]*chart_h(g)*chart_k(g);
		assert_true(fabs(area/(4*M_PI) - 1) < 3e-4);
		free(lambda0);
	}
}

/* chart_round makes use of symmetries. */
static void
round_factor_of_the_chart(void **state)
{
	static double lambda0[294*9];
	static const int columns[] = { 2, 4, 6, 8, 10, 294 };
	static const double height[] = { 0.03, 0.2, 0.7, 1.6 };
	int k, p;

	(void)state;
	for (k = 0; k < 24; k++) {
		Chart g = { columns[k/4], 9, height[k%4], &CHART_SOCK };
		SockPlane plane = sockplane(g.T);

		chart_round(g, lambda0);
		for (p = 0; p < g.nu*g.nv; p++)
			assert_true(fabs(lambda0[p]/sockplane_round(&plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu)) - 1) < 1e-12);
	}
	for (k = 0; k < 24; k++) {
		Chart g = { columns[k/4], 9 - k%2, height[k%4], &CHART_PILLOW };
		PillowPlane plane = pillowplane(g.T);

		chart_round(g, lambda0);
		for (p = 0; p < g.nu*g.nv; p++)
			assert_true(fabs(lambda0[p]/pillowplane_round(&plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu)) - 1) < 1e-12);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(test_all_sheets_have_one_image),
		cmocka_unit_test(test_triangles_lie_on_one_sheet),
		cmocka_unit_test(test_boundary_is_the_circle_and_cones_are_s),
		cmocka_unit_test(test_round_trip),
		cmocka_unit_test(test_height_of_the_distance_of_the_cones),
		cmocka_unit_test(test_stretch_is_the_derivative),
		cmocka_unit_test(test_round_factor_has_the_area_of_a_hemisphere),
		cmocka_unit_test(test_pillow_is_two_socks),
		cmocka_unit_test(test_pillow_round_trip),
		cmocka_unit_test(test_pillow_round_factor_has_the_area_of_a_sphere),
		cmocka_unit_test(round_factor_of_the_chart),
	};
	return cmocka_run_group_tests(tests, NULL, NULL);
}
