/* test_cellsq.c - cellsq.h, least squares with equations in each cell of a grid: the adjoint, the
 * minimum, a singular system; and the elimination order of dissect.h. */
#include "cmock.h"

#include "../lib/surface/cellsq.h"
#include "../lib/sparse/dissect.h"
#include "surfaces.h"

static const Chart CHART = { 13, 9, 0.6, &CHART_RECTANGLE };
enum { FIELDS = 2, ROWS = 5, RHS = 2, NODES = 13*9, CELLS = 12*8, HELD = 1 };

/* Random equations for a cell, all coefficients nonzero, the same on every call for that cell. */
static void
random_cell(const void *ctx, int i, int j, CellRows *r)
{
	unsigned long long seed = 1000*j + i + 7;
	int row, c;

	(void)ctx;
	noise(&seed);
	for (row = 0; row < ROWS; row++) {
		for (c = 0; c < 4*FIELDS; c++)
			r->A[row][c] = noise(&seed);
		for (c = 0; c < RHS; c++)
			r->b[row][c] = noise(&seed);
	}
}

static const CellSystem RANDOM = { CHART, FIELDS, ROWS, RHS, HELD, random_cell, NULL };

static double
dot(size_t n, const double *a, const double *b)
{
	double sum = 0;
	size_t i;

	for (i = 0; i < n; i++)
		sum += a[i]*b[i];
	return sum;
}

static void
adjoint(void **state)
{
	static double x[NODES*FIELDS*RHS], Ax[CELLS*ROWS*RHS], y[CELLS*ROWS*RHS], Aty[NODES*FIELDS*RHS];
	unsigned long long seed = 1;
	double left, right;
	size_t i;

	(void)state;
	for (i = 0; i < sizeof x/sizeof *x; i++)
		x[i] = noise(&seed);
	for (i = 0; i < sizeof y/sizeof *y; i++)
		y[i] = noise(&seed);
	cellsq_apply(&RANDOM, x, Ax);
	cellsq_adjoint(&RANDOM, y, Aty);
	left = dot(sizeof y/sizeof *y, Ax, y);
	right = dot(sizeof x/sizeof *x, x, Aty);
	assert_true(fabs(left) > 0.1);
	assert_true(fabs(left - right) < 1e-11*fabs(left) + 1e-11);
}

/* At the minimum the gradient A'(A x - b) is 0 at the free nodes; held nodes keep their values. */
static void
gradient_vanishes(void **state)
{
	static double x[NODES*FIELDS*RHS], x0[NODES*FIELDS*RHS], y[CELLS*ROWS*RHS], grad[NODES*FIELDS*RHS];
	unsigned long long seed = 2;
	CellRows r;
	int i, j, p, q, f;

	(void)state;
	for (p = 0; p < NODES*FIELDS*RHS; p++)
		x[p] = x0[p] = noise(&seed);
	assert_int_equal(cellsq_solve(&RANDOM, x, NULL), 0);
	cellsq_apply(&RANDOM, x, y);
	for (p = 0, j = 0; j < CHART.nv - 1; j++)
		for (i = 0; i < CHART.nu - 1; i++) {
			random_cell(NULL, i, j, &r);
			for (q = 0; q < ROWS*RHS; q++)
				y[p++] -= r.b[q/RHS][q%RHS];
		}
	cellsq_adjoint(&RANDOM, y, grad);
	for (p = 0; p < NODES; p++)
		for (f = 0; f < FIELDS*RHS; f++) {
			int held = p%CHART.nu < HELD || p/CHART.nu < HELD
			    || p%CHART.nu >= CHART.nu - HELD || p/CHART.nu >= CHART.nv - HELD;

			if (held)
				assert_true(x[p*FIELDS*RHS + f] == x0[p*FIELDS*RHS + f]);
			else
				assert_true(fabs(grad[p*FIELDS*RHS + f]) < 1e-10);
		}
}

static void
no_equations(const void *ctx, int i, int j, CellRows *r)
{
	(void)ctx;
	(void)i;
	(void)j;
	(void)r;
}

static void
singular_system_is_reported(void **state)
{
	static double x[NODES*FIELDS*RHS];
	CellSystem s = RANDOM;
	SpdReport report;

	(void)state;
	s.cell = no_equations;
	assert_int_equal(cellsq_solve(&s, x, &report), SPD_EINDEFINITE);
}

static void
dissection_is_a_permutation(void **state)
{
	static const int size[][2] = { { 1, 1 }, { 1, 40 }, { 2, 3 }, { 17, 5 }, { 64, 63 } };
	static int order[3*64*64], seen[3*64*64];
	size_t s;
	int i, n;

	(void)state;
	for (s = 0; s < sizeof size/sizeof *size; s++) {
		n = 3*size[s][0]*size[s][1];
		dissect(size[s][0], size[s][1], 3, order);
		memset(seen, 0, sizeof seen);
		for (i = 0; i < n; i++) {
			assert_true(order[i] >= 0 && order[i] < n);
			assert_int_equal(seen[order[i]]++, 0);
		}
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(adjoint),
		cmocka_unit_test(gradient_vanishes),
		cmocka_unit_test(singular_system_is_reported),
		cmocka_unit_test(dissection_is_a_permutation),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
