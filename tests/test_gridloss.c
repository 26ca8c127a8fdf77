/* test_gridloss.c - gridloss.h: the distance of a mesh from a grid. */
#include "cmock.h"

#include <math.h>
#include <string.h>

#include "../lib/grid/gridloss.h"

enum { NU = 41, NV = 33, POINTS = 60 };

/* The grid is a wavy sheet of this height over [0,1] x [0,.8]. */
static double
height(double u, double v)
{
	return 0.3*sin(9*u)*cos(7*v);
}

/* Makes the mesh, a strip of triangles.  Vertex i is at height 1e-3 i above the point of the sheet at
 * (u[i],v[i]). */
static void
make_strip(double *xyz, int *tri, double *u, double *v)
{
	int i;

	for (i = 0; i < POINTS; i++) {
		u[i] = 0.05 + 0.9*i/POINTS;
		v[i] = i%2 ? 0.6 : 0.1;
		xyz[3*i] = u[i], xyz[3*i+1] = v[i];
		xyz[3*i+2] = height(u[i], v[i]) + 1e-3*i;
	}
	for (i = 0; i < POINTS - 2; i++)
		memcpy(&tri[3*i], i%2 ? (int[]){ i + 1, i, i + 2 } : (int[]){ i, i + 1, i + 2 }, 3*sizeof *tri);
}

/* gridloss needs the (u,v) of the vertices only to save time: wrong ones give the same result. */
static void
wrong_places_do_not_matter(void **state)
{
	double x[NU*NV], y[NU*NV], z[NU*NV], *const phi[3] = { x, y, z };
	double xyz[3*POINTS], u[POINTS], v[POINTS], none[POINTS] = { 0 };
	const Chart g = { NU, NV, 0.8, &CHART_RECTANGLE };
	int tri[3*(POINTS - 2)], p;
	const Mesh m = { POINTS, POINTS - 2, xyz, tri };
	GridLoss right, wrong;

	(void)state;
	for (p = 0; p < NU*NV; p++) {
		x[p] = p%NU/(NU - 1.0);
		y[p] = 0.8*(p/NU)/(NV - 1.0);
		z[p] = height(x[p], y[p]);
	}
	make_strip(xyz, tri, u, v);
	assert_int_equal(gridloss(&m, u, v, g, phi, &right), 0);
	assert_int_equal(gridloss(&m, none, none, g, phi, &wrong), 0);
	assert_true(right.farthest > 0 && right.farthest*sqrt(right.area) <= 1e-3*POINTS);
	assert_true(wrong.farthest == right.farthest);
	assert_int_equal(wrong.vertex, right.vertex);
	assert_true(wrong.kept == right.kept && wrong.area == right.area);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(wrong_places_do_not_matter),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
