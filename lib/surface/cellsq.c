/* cellsq.c - assembly and solution of the normal equations. */
#include <stdlib.h>
#include <string.h>

#include "cellsq.h"
#include "../sparse/dissect.h"

static void
get_cell(const CellSystem *s, int i, int j, CellRows *r)
{
	memset(r, 0, sizeof *r);
	s->cell(s->ctx, i, j, r);
}

/* The node at corner c of cell (i,j). */
static int
corner_node(const CellSystem *s, int i, int j, int c)
{
	return (j + c/2)*s->g.nu + i + c%2;
}

void
cellsq_apply(const CellSystem *s, const double *x, double *y)
{
	CellRows rows;
	int i, j, r, c, f, m = s->fields, k;

	for (j = 0; j < s->g.nv - 1; j++)
		for (i = 0; i < s->g.nu - 1; i++) {
			get_cell(s, i, j, &rows);
			for (r = 0; r < s->rows; r++, y += s->rhs)
				for (k = 0; k < s->rhs; k++)
					for (y[k] = 0, c = 0; c < 4; c++)
						for (f = 0; f < m; f++)
							y[k] += rows.A[r][c*m + f]
							    * x[((size_t)corner_node(s, i, j, c)*m + f)*s->rhs + k];
		}
}

void
cellsq_adjoint(const CellSystem *s, const double *y, double *x)
{
	CellRows rows;
	int i, j, r, c, f, m = s->fields, k;

	memset(x, 0, (size_t)s->g.nu*s->g.nv*m*s->rhs*sizeof *x);
	for (j = 0; j < s->g.nv - 1; j++)
		for (i = 0; i < s->g.nu - 1; i++) {
			get_cell(s, i, j, &rows);
			for (r = 0; r < s->rows; r++, y += s->rhs)
				for (k = 0; k < s->rhs; k++)
					for (c = 0; c < 4; c++)
						for (f = 0; f < m; f++)
							x[((size_t)corner_node(s, i, j, c)*m + f)*s->rhs + k]
							    += rows.A[r][c*m + f]*y[k];
		}
}

/* y = b - y over all cells. */
static void
residual(const CellSystem *s, double *y)
{
	CellRows rows;
	int i, j, r, k;

	for (j = 0; j < s->g.nv - 1; j++)
		for (i = 0; i < s->g.nu - 1; i++) {
			get_cell(s, i, j, &rows);
			for (r = 0; r < s->rows; r++, y += s->rhs)
				for (k = 0; k < s->rhs; k++)
					y[k] = rows.b[r][k] - y[k];
		}
}

/* The index of node p among the free nodes, counted row by row; -1 if p is held. */
static int
free_number(const CellSystem *s, int p)
{
	int i = p%s->g.nu - s->held, j = p/s->g.nu - s->held, nu = s->g.nu - 2*s->held;

	return i < 0 || j < 0 || i >= nu || j >= s->g.nv - 2*s->held ? -1 : j*nu + i;
}

/* Adds to a those entries of the lower triangle of one cell's A'A whose unknowns are both free. */
static void
add_cell(const CellSystem *s, int i, int j, Spd *a)
{
	int n = 4*s->fields, m = s->fields, p, q, r, number[4];
	CellRows rows;
	double sum;

	get_cell(s, i, j, &rows);
	for (p = 0; p < 4; p++)
		number[p] = free_number(s, corner_node(s, i, j, p));
	for (p = 0; p < n; p++)
		for (q = 0; q <= p && number[p/m] >= 0; q++) {
			if (number[q/m] < 0)
				continue;
			for (sum = 0, r = 0; r < s->rows; r++)
				sum += rows.A[r][p]*rows.A[r][q];
			spd_add(a, number[p/m]*m + p%m, number[q/m]*m + q%m, sum);
		}
}

static int
normal_matrix(const CellSystem *s, int n, Spd *a)
{
	size_t pairs = (size_t)4*s->fields*(4*s->fields + 1)/2;
	int i, j, e = spd_init(a, n*s->fields, pairs*(s->g.nu - 1)*(s->g.nv - 1));

	for (j = 0; !e && j < s->g.nv - 1; j++)
		for (i = 0; i < s->g.nu - 1; i++)
			add_cell(s, i, j, a);
	return e;
}

/* Copies x [node][field][rhs] at free nodes to B [rhs][free number][field]. */
static void
gather(const CellSystem *s, const double *x, int n, double *B)
{
	int p, f, k, q;

	for (p = 0; p < s->g.nu*s->g.nv; p++)
		if ((q = free_number(s, p)) >= 0)
			for (f = 0; f < s->fields; f++)
				for (k = 0; k < s->rhs; k++)
					B[((size_t)k*n + q)*s->fields + f] = x[((size_t)p*s->fields + f)*s->rhs + k];
}

static void
scatter(const CellSystem *s, const double *B, int n, double *x)
{
	int p, f, k, q;

	for (p = 0; p < s->g.nu*s->g.nv; p++)
		if ((q = free_number(s, p)) >= 0)
			for (f = 0; f < s->fields; f++)
				for (k = 0; k < s->rhs; k++)
					x[((size_t)p*s->fields + f)*s->rhs + k] = B[((size_t)k*n + q)*s->fields + f];
}

/* B = A_free' (b - A_held x_held), with x = 0 at free nodes. */
static int
right_hand_sides(const CellSystem *s, double *x, int n, double *B)
{
	size_t cells = (size_t)(s->g.nu - 1)*(s->g.nv - 1), nodes = (size_t)s->g.nu*s->g.nv;
	double *y = malloc(cells*s->rows*s->rhs*sizeof *y);
	double *z = malloc(nodes*s->fields*s->rhs*sizeof *z);
	int e = y && z ? 0 : SPD_ENOMEM;

	if (!e) {
		memset(B, 0, (size_t)n*s->fields*s->rhs*sizeof *B);
		scatter(s, B, n, x);
		cellsq_apply(s, x, y);
		residual(s, y);
		cellsq_adjoint(s, y, z);
		gather(s, z, n, B);
	}
	free(y);
	free(z);
	return e;
}

int
cellsq_solve(const CellSystem *s, double *x, SpdReport *report)
{
	int nu = s->g.nu - 2*s->held, nv = s->g.nv - 2*s->held, n = nu*nv, e = SPD_ENOMEM;
	double *B;
	int *order;
	Spd a;

	if (nu <= 0 || nv <= 0)
		return 0;
	B = malloc((size_t)n*s->fields*s->rhs*sizeof *B);
	order = malloc((size_t)n*s->fields*sizeof *order);
	if (B && order)
		e = right_hand_sides(s, x, n, B);
	if (!e)
		e = normal_matrix(s, n, &a);
	if (!e) {
		dissect(nu, nv, s->fields, order);
		e = spd_solve(&a, order, s->rhs, B, report);
	}
	if (!e)
		scatter(s, B, n, x);
	free(B);
	free(order);
	return e;
}
