/* plate.c - sine transforms of three fields at once.
 *
 * Two-dimensional transforms are made of one-dimensional ones, so that threads share the
 * rows of all three fields and no plan depends on their number.  Columns are taken out
 * a few at a time, transformed, divided by the eigenvalues, transformed back and put back.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <omp.h>

#include "plate.h"

enum { WIDTH = 8 };             /* columns taken at a time: a line of the cache */

static double *
eigenvalues(int n, double step)
{
	double *e = malloc(n*sizeof *e);
	int k;

	for (k = 0; e && k < n; k++)
		e[k] = (2 - 2*cos(M_PI*(k + 1)/(n + 1)))/(step*step);
	return e;
}

void
plate_free(Plate *p)
{
	sine_free(&p->along_u);
	sine_free(&p->along_v);
	free(p->eigenvalue[0]);
	free(p->eigenvalue[1]);
	fftw_free(p->work);
	memset(p, 0, sizeof *p);
}

/* Numbers of work a thread needs, a multiple of a line of the cache: columns, and what a
 * transform needs. */
static size_t
columns(const Plate *p)
{
	return ((size_t)WIDTH*p->g.nv + 7)/8*8;
}

static size_t
room(const Plate *p)
{
	size_t u = sine_room(&p->along_u), v = sine_room(&p->along_v);

	return columns(p) + ((u > v ? u : v) + 7)/8*8;
}

int
plate_init(Plate *p, Chart g)
{
	int e;

	*p = (Plate){ .g = g };
	p->eigenvalue[0] = eigenvalues(g.nu - 2, chart_h(g));
	p->eigenvalue[1] = eigenvalues(g.nv - 2, chart_k(g));
	e = sine_init(&p->along_u, g.nu - 2);
	if (!e)
		e = sine_init(&p->along_v, g.nv - 2);
	if (!e)
		p->work = fftw_alloc_real(omp_get_max_threads()*room(p));
	if (p->work && p->eigenvalue[0] && p->eigenvalue[1])
		return 0;
	plate_free(p);
	return PLATE_ENOMEM;
}

/* `width` columns from column i of the field whose first inner node is z. */
static void
solve_columns(const Plate *p, double a, double b, int i, int width, double *column, double *z)
{
	int n = p->g.nv - 2, nu = p->g.nu, j, k;
	double norm = (p->g.nu - 1.0)*(p->g.nv - 1.0)/4, e, *work = column + columns(p);

	for (j = 0; j < n; j++)
		for (k = 0; k < width; k++)
			column[k*n+j] = z[(size_t)j*nu + i + k];
	for (k = 0; k < width; k++) {
		sine_transform(&p->along_v, column + k*n, work);
		for (j = 0; j < n; j++) {
			e = p->eigenvalue[0][i+k] + p->eigenvalue[1][j];
			column[k*n+j] /= norm*e*(a*e + b);
		}
		sine_transform(&p->along_v, column + k*n, work);
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
		if (j%p->g.nv != 0 && j%p->g.nv != p->g.nv - 1)
			sine_transform(&p->along_u, z + (size_t)j*p->g.nu + 1, work);
	}
}

void
plate_solve(const Plate *p, double a, double b, double *z)
{
	int inner = p->g.nu - 2, groups = (inner + WIDTH - 1)/WIDTH;
	size_t n = (size_t)p->g.nu*p->g.nv;

#pragma omp parallel
	{
		double *column = p->work + omp_get_thread_num()*room(p);
		int q;

		transform_rows(p, z, column + columns(p));
#pragma omp for schedule(static)
		for (q = 0; q < 3*groups; q++) {
			int i = q%groups*WIDTH, width = inner - i < WIDTH ? inner - i : WIDTH;

			solve_columns(p, a, b, i, width, column, z + q/groups*n + p->g.nu + 1);
		}
		transform_rows(p, z, column + columns(p));
	}
}
