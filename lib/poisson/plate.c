/* plate.c - sine or cosine transform, division by the eigenvalues of P, inverse transform.  Here the
 * rectangle; the sock and the pillow are in platefold.c.
 *
 * A two-dimensional transform consists of one-dimensional ones, first of the rows, then of the
 * columns.  The rows of all three fields are divided among the threads, and no FFTW plan depends
 * on the number of threads.  A few columns at a time are copied to a workspace, transformed,
 * divided by the eigenvalues, transformed back and copied into the field again.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <omp.h>

#include "platepriv.h"

enum { WIDTH = 8 };             /* columns copied at a time: a row of them is one cache line */

/* How many of n nodes along u or v are unknowns. */
static int
unknown(const Plate *p, int n)
{
	return p->free ? n : n - 2;
}

/* The workspace of a thread has WIDTH columns, then the workspace of a transform.  The sizes of
 * both, counted in doubles, are rounded up to whole cache lines. */
static size_t
columns_room(const Plate *p)
{
	return ((size_t)WIDTH*p->g.nv + 7)/8*8;
}

static size_t
room(const Plate *p)
{
	size_t u = transform_room(&p->transform[0]), v = transform_room(&p->transform[1]);

	return columns_room(p) + ((u > v ? u : v) + 7)/8*8;
}

static int
rectangle_init(Plate *p)
{
	int e, first = p->free ? 0 : 1, nodes[2] = { p->g.nu, p->g.nv }, k;
	double step[2] = { chart_h(p->g), chart_k(p->g) };

	for (e = k = 0; !e && k < 2; k++) {
		p->eigenvalue[k] = plate_eigenvalues(unknown(p, nodes[k]), first, 2*(nodes[k] - 1.0), step[k]);
		e = transform_init(&p->transform[k], nodes[k] - 1);
	}
	if (!e)
		p->work = fftw_alloc_real(omp_get_max_threads()*room(p));
	return e;
}

static void
transform(const Plate *p, int along, double *f, double *work)
{
	if (p->free)
		transform_cosine(&p->transform[along], f, work);
	else
		transform_sine(&p->transform[along], f, work);
}

/* The constant c0 of plate.h for a free border, 0 for a held one. */
static double
shift(const Plate *p, double b)
{
	return p->free ? b*fmin(p->eigenvalue[0][1], p->eigenvalue[1][1]) : 0;
}

/* Transforms `width` columns from column i on, divides by the eigenvalues and transforms back.  z
 * points to the first unknown node of the field. */
static void
solve_columns(const Plate *p, double a, double b, double c, int i, int width, double *column, double *z)
{
	int n = unknown(p, p->g.nv), nu = p->g.nu, j, k;
	double norm = (p->g.nu - 1.0)*(p->g.nv - 1.0)/4, e, *work = column + columns_room(p);

	for (j = 0; j < n; j++)
		for (k = 0; k < width; k++)
			column[k*n+j] = z[(size_t)j*nu + i + k];
	for (k = 0; k < width; k++) {
		transform(p, 1, column + k*n, work);
		for (j = 0; j < n; j++) {
			e = p->eigenvalue[0][i+k] + p->eigenvalue[1][j];
			column[k*n+j] /= norm*(e*(a*e + b) + c);
		}
		transform(p, 1, column + k*n, work);
	}
	for (j = 0; j < n; j++)
		for (k = 0; k < width; k++)
			z[(size_t)j*nu + i + k] = column[k*n+j];
}

static void
transform_rows(const Plate *p, double *z, double *work)
{
	int rows = 3*p->g.nv, j;

#pragma omp for schedule(static)
	for (j = 0; j < rows; j++) {
		if (p->free)
			transform(p, 0, z + (size_t)j*p->g.nu, work);
		else if (j%p->g.nv != 0 && j%p->g.nv != p->g.nv - 1)
			transform(p, 0, z + (size_t)j*p->g.nu + 1, work);
	}
}

/* z = W^-1 z */
static void
divide_by_weights(Chart g, double *z)
{
	int rows = 3*g.nv, i, j;

	for (j = 0; j < rows; j++) {
		double *row = z + (size_t)j*g.nu;

		row[0] *= 2;
		row[g.nu-1] *= 2;
		for (i = 0; i < g.nu && (j%g.nv == 0 || j%g.nv == g.nv - 1); i++)
			row[i] *= 2;
	}
}

static void
rectangle_solve(const Plate *p, double a, double b, double c, double *z)
{
	int unknowns = unknown(p, p->g.nu), groups = (unknowns + WIDTH - 1)/WIDTH;
	size_t n = (size_t)p->g.nu*p->g.nv, first = p->free ? 0 : p->g.nu + 1;

	c += shift(p, b);
	if (p->free)
		divide_by_weights(p->g, z);
#pragma omp parallel
	{
		double *column = p->work + omp_get_thread_num()*room(p);
		int q;

		transform_rows(p, z, column + columns_room(p));
#pragma omp for schedule(static)
		for (q = 0; q < 3*groups; q++) {
			int i = q%groups*WIDTH, width = unknowns - i < WIDTH ? unknowns - i : WIDTH;

			solve_columns(p, a, b, c, i, width, column, z + q/groups*n + first);
		}
		transform_rows(p, z, column + columns_room(p));
	}
}

/* ---- any chart ------------------------------------------------------- */

static const struct {
	const ChartKind *kind;
	int  (*init)(Plate *p);
	void (*solve)(const Plate *p, double a, double b, double c, double *z);
} known[] = {
	{ &CHART_RECTANGLE, rectangle_init, rectangle_solve },
	{ &CHART_SOCK, platefold_init, platefold_solve },
	{ &CHART_PILLOW, platefold_init, platefold_solve },
};

static int
index_of(const ChartKind *kind)
{
	int i = 0;

	while (known[i].kind != kind)
		i++;
	return i;
}

void
plate_free(Plate *p)
{
	int k;

	for (k = 0; k < 2; k++) {
		transform_free(&p->transform[k]);
		free(p->eigenvalue[k]);
		if (p->plan[k])
			fftw_destroy_plan(p->plan[k]);
		if (p->column[k])
			fftw_destroy_plan(p->column[k]);
	}
	fftw_free(p->work);
	memset(p, 0, sizeof *p);
}

int
plate_init(Plate *p, Chart g, int free)
{
	*p = (Plate){ .g = g, .free = free };
	if (known[index_of(g.kind)].init(p) == 0 && p->work && p->eigenvalue[0] && p->eigenvalue[1])
		return 0;
	plate_free(p);
	return PLATE_ENOMEM;
}

Chart
plate_fast(Chart g)
{
	if (!g.kind->folded)
		return g;
	if (g.kind->closed)
		return (Chart){ transform_fast_size((g.nu + 1)/2*2, 2), transform_fast_size(2*g.nv, 2)/2, g.T, g.kind };
	return (Chart){ transform_fast_size((g.nu + 1)/2*2, 2), (transform_fast_size(2*g.nv - 1, 2) + 1)/2, g.T, g.kind };
}

void
plate_solve(const Plate *p, double a, double b, double c, double *z)
{
	known[index_of(p->g.kind)].solve(p, a, b, c, z);
}
