/* test_gridpoint.c - gridpoint.h, interpolation between the nodes of a grid: polynomials, smooth
 * surfaces, rough data; and (u,v) that are refused. */
#include "cmock.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/grid/bicubic.h"
#include "../lib/grid/gridpoint.h"
#include "sockcap.h"

typedef double Function(double u, double v, int c);

/* Allocates phi and sets it to f(u,v,c) at the nodes. */
static void
fill(Chart g, Function *f, double *phi[3])
{
	int c, i, j;

	for (c = 0; c < 3; c++) {
		phi[c] = malloc((size_t)g.nu*g.nv*sizeof *phi[c]);
		for (j = 0; j < g.nv; j++)
			for (i = 0; i < g.nu; i++)
				phi[c][j*g.nu + i] = f(chart_u(g, i), chart_v(g, j), c);
	}
}

static void
drop(double *phi[3])
{
	int c;

	for (c = 0; c < 3; c++)
		free(phi[c]);
}

/* The largest error of interpolation at (n+1) x (m+1) points, which include the border. */
static double
worst(Chart g, Function *f, int n, int m)
{
	double *phi[3], x[3], e = 0, u, v;
	int c, i, j;

	fill(g, f, phi);
	for (j = 0; j <= m; j++)
		for (i = 0; i <= n; i++) {
			u = (double)i/n, v = g.T*j/m;
			gridpoint(g, 3, (const double *const *)phi, u, v, x);
			for (c = 0; c < 3; c++)
				e = fmax(e, fabs(x[c] - f(u, v, c)));
		}
	drop(phi);
	return e;
}

static double
cubic(double u, double v, int c)
{
	return c == 0 ? u*u*u*v*v*v - 2*u*u*v + v : c == 1 ? u*v*v*v + u*u*u - 1 : v*v*v - 3*u*u*u*v*v + 5;
}

static double
quadratic(double u, double v, int c)
{
	return c == 0 ? u*u*v*v - u : c == 1 ? v*v + u*v : 3 - u*u*v;
}

static double
bilinear(double u, double v, int c)
{
	return c == 0 ? u*v : c == 1 ? 1 - 2*u : v - 3*u*v;
}

static double
smooth(double u, double v, int c)
{
	return c == 0 ? sin(4*u + v) : c == 1 ? exp(u)*cos(3*v) : 1/(1 + u + 2*v*v);
}

/* Pseudo-random numbers in [0,1) that depend only on u, v and c. */
static double
rough(double u, double v, int c)
{
	double s = sin(12.9898*u + 78.233*v + c)*43758.5453;

	return s - floor(s);
}

static void
polynomials_are_exact(void **state)
{
	static const Chart grid[] = { { 4, 4, 1, &CHART_RECTANGLE }, { 5, 6, 0.3, &CHART_RECTANGLE },
		{ 6, 5, 2.5, &CHART_RECTANGLE }, { 9, 17, 0.7, &CHART_RECTANGLE }, { 40, 7, 1.3, &CHART_RECTANGLE } };
	size_t i;

	(void)state;
	for (i = 0; i < sizeof grid/sizeof *grid; i++)
		assert_true(worst(grid[i], cubic, 23, 29) < 1e-13*(1 + pow(grid[i].T, 3)*10));
	assert_true(worst((Chart){ 3, 3, 0.8, &CHART_RECTANGLE }, quadratic, 13, 11) < 1e-14);
	assert_true(worst((Chart){ 3, 8, 0.8, &CHART_RECTANGLE }, quadratic, 13, 11) < 1e-14);
	assert_true(worst((Chart){ 2, 2, 1.7, &CHART_RECTANGLE }, bilinear, 13, 11) < 1e-14);
	assert_true(worst((Chart){ 2, 7, 1.7, &CHART_RECTANGLE }, bilinear, 13, 11) < 1e-14);
}

/* A cap on a sock: the chart is smooth across the seam and the fold, but for the cones. */
static double
cap(double u, double v, int c)
{
	SockPlane plane = sockplane(0.6);

	return sockcap(&plane, 0.8, u, v).x[c];
}

/* Across the seam, the fold and at the boundary the order is the fourth, as inside. */
static void
fourth_order_on_the_sock(void **state)
{
	double e[3];
	int k, n;

	(void)state;
	for (k = 0, n = 32; k < 3; k++, n *= 2)
		e[k] = worst((Chart){ n, (int)(n*0.6 + 0.5), 0.6, &CHART_SOCK }, cap, 97, 61);
	assert_true(e[0] < 2e-3 && e[0]/e[1] > 13 && e[1]/e[2] > 14);
}

/* A field that changes its sign under the turn about the cone (0,0) is continued so by bicubic_odd. */
static void
odd_fields_are_odd(void **state)
{
	const Chart g = { 16, 9, 0.5, &CHART_SOCK };
	double f[16*9], most = 0;
	int p, i;

	(void)state;
	for (p = 0; p < g.nu*g.nv; p++)
		f[p] = sin(2*M_PI*chart_u(g, p%g.nu))*cosh(chart_v(g, p/g.nu));
	for (i = 0; i <= 3*g.nu; i++) {
		Bicubic at = bicubic_at(g, i/3. - 0.5, -0.5);   /* on the fold */

		most = fmax(most, fabs(bicubic_odd(&at, f) - sin(2*M_PI*i/(3.*g.nu))));
	}
	assert_true(most < 2e-3);
}

static void
nodes_are_kept(void **state)
{
	const Chart g = { 13, 7, 0.6, &CHART_RECTANGLE };

	(void)state;
	assert_true(worst(g, smooth, g.nu - 1, g.nv - 1) < 1e-14);
}

/* The largest error is of fourth order, so the border is as accurate as the inside. */
static void
fourth_order(void **state)
{
	double e[3];
	int k, n;

	(void)state;
	for (k = 0, n = 16; k < 3; k++, n *= 2)
		e[k] = worst((Chart){ n + 1, 3*n/2 + 1, 1.2, &CHART_RECTANGLE }, smooth, 7*n, 7*n);
	assert_true(e[0] < 1e-3 && e[0]/e[1] > 13 && e[1]/e[2] > 14);
}

/* First derivatives are continuous across the grid lines, even for rough data. */
static void
slopes_agree(void **state)
{
	const Chart g = { 11, 9, 0.7, &CHART_RECTANGLE };
	const double d = 1e-6, v = 0.123, u = 0.777;
	double *phi[3], x[3][3];
	int c, i, k;

	(void)state;
	fill(g, rough, phi);
	for (i = 1; i < g.nu - 1; i++)
		for (k = 0; k < 2; k++) {
			for (c = -1; c <= 1; c++)
				gridpoint(g, 3, (const double *const *)phi, k ? u : i*chart_h(g) + c*d,
				    k ? i%(g.nv - 2)*chart_k(g) + chart_k(g) + c*d : v, x[c+1]);
			for (c = 0; c < 3; c++)
				assert_true(fabs(x[2][c] - 2*x[1][c] + x[0][c])/d < 0.01);
		}
	drop(phi);
}

/* Moves four vertices with the given (u,v) to their points on the grid.  T is the height of the
 * chart of these (u,v), or 0 if it is unknown. */
static int
moved(Chart g, const double *const phi[3], double T, const double uv[8], double x[12], double to[8],
	int *at)
{
	static const double xyz[12] = { 9, 9, 9, 8, 8, 8, 7, 7, 7, 6, 6, 6 };
	int e = gridpoint_uv(g, T, 4, uv, to, at);

	memcpy(x, xyz, sizeof xyz);
	if (!e)
		gridpoint_vertices(g, 3, phi, 4, to, x);
	return e;
}

static void
meshes_are_moved(void **state)
{
	const Chart g = { 9, 9, 0.5, &CHART_RECTANGLE };
	double uv[8] = { 0.3, 0.4, -1, -1, 1 + 5e-7, -1e-7, 0.5, 0.25 }, to[8], x[12], want[3], *mine[3];
	const double *const *phi = (const double *const *)mine;
	int at, c;

	(void)state;
	fill(g, cubic, mine);
	assert_int_equal(moved(g, phi, 0, uv, x, to, &at), 0);
	assert_true(x[3] == 8 && x[4] == 8 && x[5] == 8 && to[2] == -1 && to[3] == -1);
	assert_true(to[0] == 0.3 && to[1] == 0.4 && to[4] == 1 && to[5] == 0);
	for (c = 0; c < 3; c++) {
		assert_true(fabs(x[c] - cubic(0.3, 0.4, c)) < 1e-14);
		assert_true(fabs(x[6+c] - cubic(1, 0, c)) < 1e-14);
	}
	assert_int_equal(moved(g, phi, 2, uv, x, to, &at), 0);          /* v = 0.4 of 2 is 0.1 of 0.5 */
	for (c = 0; c < 3; c++)
		assert_true(fabs(x[c] - cubic(0.3, 0.1, c)) < 1e-14);
	uv[7] = 2;                      /* the top of one chart is the top of the other */
	assert_int_equal(moved(g, phi, 2, uv, x, to, &at), 0);
	gridpoint(g, 3, phi, 0.5, 0.5, want);
	assert_true(to[7] == 0.5 && x[9] == want[0]);
	assert_int_equal(moved(g, phi, 0, uv, x, to, &at), GRIDPOINT_EOUT);     /* v > g.T */
	assert_int_equal(at, 3);
	uv[7] = 0.5, uv[4] = 1.00001;
	assert_int_equal(moved(g, phi, 0, uv, x, to, &at), GRIDPOINT_EOUT);
	assert_int_equal(at, 2);
	uv[4] = -1;                     /* v without u */
	assert_int_equal(moved(g, phi, 0, uv, x, to, &at), GRIDPOINT_EOUT);
	uv[4] = NAN;
	assert_int_equal(moved(g, phi, 0, uv, x, to, &at), GRIDPOINT_EOUT);
	drop(mine);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(polynomials_are_exact),
		cmocka_unit_test(nodes_are_kept),
		cmocka_unit_test(fourth_order_on_the_sock),
		cmocka_unit_test(odd_fields_are_odd),
		cmocka_unit_test(fourth_order),
		cmocka_unit_test(slopes_agree),
		cmocka_unit_test(meshes_are_moved),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
