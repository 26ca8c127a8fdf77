/* gridlaplace.c - harmonic coordinates of a grid with mixed boundary conditions. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cg.h"
#include "../base/field.h"
#include "../grid/stencil.h"
#include "gridlaplace.h"
#include "../poisson/planelaplace.h"

enum { FEW_STEPS = 20, MOST_STEPS = 400 };
static const double REDUCTION = 1e-3;   /* of the norm of the preconditioned residual: enough where
                                         * FEW_STEPS reach it.. */
static const double EXACT = 1e-6;       /* ..and from there on where they do not, because errors of
                                         * rounding then grow */
static const double RING = 2.5;         /* steps */

/* ---- the matrix ------------------------------------------------------ */

static GridNode *
differentiate(Chart g, const double *const phi[3])
{
	int n = g.nu*g.nv, p, c;
	GridNode *node = malloc(n*sizeof *node);

	if (!node)
		return NULL;
	#pragma omp parallel for schedule(static) private(c)
	for (p = 0; p < n; p++) {
		for (c = 0; c < 3; c++)
			node[p].phi[c] = phi[c][p];
		stencil_tangents(g, phi, p%g.nu, p/g.nu, node[p].phi_u, node[p].phi_v);
	}
	return node;
}

/* The row of nodes below row `row` of cells.  The last rows of cells of a folded chart are the folds at v = 0 and v =
 * T. */
static int
row_below(const GridLaplace *l, int row)
{
	return row < l->g.nv - 1 ? row : row == l->g.nv - 1 ? -1 : l->g.nv - 1;
}

static int
is_fold(const GridLaplace *l, int row)
{
	return row >= l->g.nv - 1;
}

/* The nodes of cell i of a row of cells above row j of nodes, and their signs. */
static void
corners_of(Chart g, int i, int j, size_t node[4], int sign[4])
{
	int a;

	for (a = 0; a < 4; a++) {
		sign[a] = 1;
		node[a] = stencil_node(g, i + a%2, j + a/2, &sign[a]);
	}
}

/* Whether the middle of that cell is within RING steps of a cone. */
static int
near_cone(Chart g, int i, int j)
{
	double h = chart_h(g), k = chart_k(g), du, dv;
	int c;

	for (c = 0; c < g.kind->cones; c++) {
		du = fabs(chart_u(g, i) + h/2 - g.kind->cone[c][0]);
		dv = chart_v(g, j) + k/2 - g.T*g.kind->cone[c][1];
		if (hypot(fmin(du, fabs(1 - du))/h, dv/k) < RING)
			return 1;
	}
	return 0;
}

/* How far the metric of a cell is taken for that of the surface.  On a chart with cones, cells within which the
 * surface turns much are taken as conformal: they lie at the tips of limbs, where the map is more conformal than so few
 * cells can tell, and rounds by their metric would take nodes away. */
static double
trust(Chart g, const GridCell *cell, int i, int j)
{
	return g.kind->cones == 0 ? 1 : near_cone(g, i, j) ? 0 : gridcell_trust(cell);
}

static void
fill_row(GridLaplace *l, const GridNode *node, int row, int metric)
{
	double *m = l->cell + 10*(size_t)row*l->across;
	int i, q, a, j = row_below(l, row);
	GridCell cell = { .h = chart_h(l->g), .k = chart_k(l->g) };
	size_t at[4];

	for (i = 0; i < l->across; i++, m += 10) {
		corners_of(l->g, i, j, at, cell.sign);
		for (a = 0; a < 4; a++)
			cell.corner[a] = node + at[a];
		gridcell_matrix(&cell, metric, trust(l->g, &cell, i, j), m);
		for (q = 0; q < 10 && is_fold(l, row); q++)
			m[q] /= 2;              /* the cells of a fold come twice */
	}
}

int
gridlaplace_init(GridLaplace *l, Chart g, double *const phi[3], int metric)
{
	GridNode *node = differentiate(g, (const double *[3]){ phi[0], phi[1], phi[2] });
	int j;

	l->g = g;
	l->across = g.kind->joined[0][1] ? g.nu : g.nu - 1;
	l->down = g.nv - 1 + g.kind->folded;
	l->cell = malloc(10*(size_t)l->across*l->down*sizeof *l->cell);
	if (!node || !l->cell) {
		free(node);
		gridlaplace_free(l);
		return GRIDLAPLACE_ENOMEM;
	}
	#pragma omp parallel for schedule(static)
	for (j = 0; j < l->down; j++)
		fill_row(l, node, j, metric);
	free(node);
	return 0;
}

void
gridlaplace_free(GridLaplace *l)
{
	free(l->cell);
	l->cell = NULL;
}

/* Adds the product of one cell.  base: values at its corners that are added to those of x. */
static void
apply_cell(const double m[10], const size_t p[4], const int sign[4], const double base[4], const double *x,
	double *y)
{
	double a = base[0] + sign[0]*x[p[0]], b = base[1] + sign[1]*x[p[1]];
	double c = base[2] + sign[2]*x[p[2]], d = base[3] + sign[3]*x[p[3]];

	y[p[0]] += sign[0]*(m[0]*a + m[1]*b + m[3]*c + m[6]*d);
	y[p[1]] += sign[1]*(m[1]*a + m[2]*b + m[4]*c + m[7]*d);
	y[p[2]] += sign[2]*(m[3]*a + m[4]*b + m[5]*c + m[8]*d);
	y[p[3]] += sign[3]*(m[6]*a + m[7]*b + m[8]*c + m[9]*d);
}

/* Adds the products of one row of cells to its two rows of nodes. */
static void
apply_row(const GridLaplace *l, int row, const double *x, double *y)
{
	static const double none[4] = { 0, 0, 0, 0 };
	const double *m = l->cell + 10*(size_t)row*l->across;
	int i, j = row_below(l, row), plain = is_fold(l, row) ? 0 : l->g.nu - 1, sign[4];
	size_t p = (size_t)row*l->g.nu, q = p + l->g.nu, node[4];

	for (i = 0; i < plain; i++, m += 10, p++, q++) {
		double a = x[p], b = x[p+1], c = x[q], d = x[q+1];

		y[p]   += m[0]*a + m[1]*b + m[3]*c + m[6]*d;
		y[p+1] += m[1]*a + m[2]*b + m[4]*c + m[7]*d;
		y[q]   += m[3]*a + m[4]*b + m[5]*c + m[8]*d;
		y[q+1] += m[6]*a + m[7]*b + m[8]*c + m[9]*d;
	}
	for (; i < l->across; i++, m += 10) {
		corners_of(l->g, i, j, node, sign);
		apply_cell(m, node, sign, none, x, y);
	}
}

/* Applies even rows of cells, then odd ones, and last the folds.  So rows that run at the same time share no
 * node, and the order of each sum does not depend on the number of threads. */
void
gridlaplace_apply(const GridLaplace *l, const double *x, double *y)
{
	int parity, j, rows = l->down - l->g.kind->folded;

	memset(y, 0, (size_t)l->g.nu*l->g.nv*sizeof *y);
	for (parity = 0; parity < 2; parity++) {
		#pragma omp parallel for schedule(static)
		for (j = parity; j < rows; j += 2)
			apply_row(l, j, x, y);
	}
	for (j = rows; j < l->down; j++)
		apply_row(l, j, x, y);
}

/* y = the derivative of E/2 at the coordinate along the axis plus x, in steps. */
static void
apply_coordinate(const GridLaplace *l, int axis, const double *x, double *y)
{
	int i, j, a, row, sign[4];
	size_t node[4];

	memset(y, 0, (size_t)l->g.nu*l->g.nv*sizeof *y);
	for (row = 0; row < l->down; row++)
		for (i = 0, j = row_below(l, row); i < l->across; i++) {
			double base[4];

			for (a = 0; a < 4; a++)
				base[a] = axis ? j + a/2 + 0.5 : i + a%2 + 0.5;
			corners_of(l->g, i, j, node, sign);
			apply_cell(l->cell + 10*((size_t)row*l->across + i), node, sign, base, x, y);
		}
}

/* E(f,g) in steps, for f the coordinate along axis[0] plus x[0], and g that along axis[1] plus x[1]. */
static double
coordinate_product(const GridLaplace *l, const int axis[2], const double *const x[2])
{
	int i, j, a, b, c, row, sign[4];
	double E = 0, f[2][4];
	const double *m = l->cell;
	size_t node[4];

	for (row = 0; row < l->down; row++)
		for (i = 0, j = row_below(l, row); i < l->across; i++) {
			corners_of(l->g, i, j, node, sign);
			for (c = 0; c < 2; c++)
				for (a = 0; a < 4; a++)
					f[c][a] = (axis[c] ? j + a/2 + 0.5 : i + a%2 + 0.5) + sign[a]*x[c][node[a]];
			for (a = 0; a < 4; a++)
				for (b = 0; b <= a; b++, m++)
					E += a == b ? *m*f[0][a]*f[1][a] : *m*(f[0][a]*f[1][b] + f[0][b]*f[1][a]);
		}
	return E;
}

/* ---- conjugate gradients --------------------------------------------- */

typedef struct Harmonic {
	const GridLaplace  *l;
	const PlaneLaplace *plane;
} Harmonic;

static void
apply(void *ctx, const double *x, double *y)
{
	gridlaplace_apply(((const Harmonic *)ctx)->l, x, y);
}

/* z is 0 at nodes with given values, so that CG does not change them. */
static void
precondition(void *ctx, const double *r, double *z)
{
	planelaplace_solve(((const Harmonic *)ctx)->plane, r, z);
}

/* Solves for the correction of f.  On entry work, [4][nv][nu], begins with the negative derivative of
 * E/2 at f. */
static void
solve(const GridLaplace *l, const PlaneLaplace *plane, double *f, double *work)
{
	size_t n = (size_t)l->g.nu*l->g.nv;
	Harmonic harmonic = { l, plane };
	CgSystem s = { n, apply, precondition, &harmonic };
	CgLimits few = { REDUCTION, FEW_STEPS, HUGE_VAL, 0, 0 }, most = { EXACT, MOST_STEPS, HUGE_VAL, 0, 0 };

	if (cg(&s, &few, f, work, work + n, work + 2*n, work + 3*n).steps == FEW_STEPS)
		cg(&s, &most, f, work, work + n, work + 2*n, work + 3*n);
}

static void
negate(size_t n, double *x)
{
	size_t p;

	for (p = 0; p < n; p++)
		x[p] = -x[p];
}

/* On the rectangle the field is the coordinate itself, from 0 to 1. */
static void
shift_rectangle(const GridLaplace *l, const PlaneLaplace *plane, int axis, double *f, double *energy,
	double *work)
{
	int n = l->g.nu*l->g.nv, p, steps = axis ? l->g.nv - 1 : l->g.nu - 1;

	for (p = 0; p < n; p++)
		f[p] = (axis ? p/l->g.nu : p%l->g.nu)/(double)steps;
	gridlaplace_apply(l, f, work);
	negate(n, work);
	solve(l, plane, f, work);
	gridlaplace_apply(l, f, work);
	*energy = field_dot(n, f, work);
	for (p = 0; p < n; p++)
		f[p] = f[p]*steps - (axis ? p/l->g.nu : p%l->g.nu);
}

/* Elsewhere the coordinate is not one field; its difference from that of the grid is. */
static void
shift_odd(const GridLaplace *l, const PlaneLaplace *plane, int axis, double *f, double *energy,
	double *work)
{
	size_t n = (size_t)l->g.nu*l->g.nv;
	double steps = chart_steps(l->g, axis);

	memset(f, 0, n*sizeof *f);
	apply_coordinate(l, axis, f, work);
	negate(n, work);
	solve(l, plane, f, work);
	*energy = coordinate_product(l, (int[]){ axis, axis }, (const double *[]){ f, f })/(steps*steps);
}

int
gridlaplace_shift(const GridLaplace *l, int axis, double *shift, double *energy)
{
	double *work = malloc(4*(size_t)l->g.nu*l->g.nv*sizeof *work);
	PlaneLaplace plane;
	int e = work ? planelaplace_init(&plane, l->g, axis) : GRIDLAPLACE_ENOMEM;

	if (!e) {
		(l->g.kind->folded ? shift_odd : shift_rectangle)(l, &plane, axis, shift, energy, work);
		planelaplace_free(&plane);
	}
	free(work);
	return e;
}

double
gridlaplace_product(const GridLaplace *l, const double *shift_u, const double *shift_v)
{
	return coordinate_product(l, (int[]){ 0, 1 }, (const double *[]){ shift_u, shift_v })/
	    (chart_steps(l->g, 0)*chart_steps(l->g, 1));
}
