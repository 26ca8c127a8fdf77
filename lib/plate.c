/* plate.c - FFTW behind plate.h.
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
	if (p->along_u)
		fftw_destroy_plan(p->along_u);
	if (p->along_v)
		fftw_destroy_plan(p->along_v);
	free(p->eigenvalue[0]);
	free(p->eigenvalue[1]);
	free(p->columns);
	memset(p, 0, sizeof *p);
}

static fftw_plan
sines(int n, double *f)
{
	return fftw_plan_r2r_1d(n, f, f, FFTW_RODFT00, FFTW_ESTIMATE | FFTW_UNALIGNED);
}

int
plate_init(Plate *p, Chart g)
{
	size_t most = g.nu > g.nv ? g.nu : g.nv;

	*p = (Plate){ .g = g };
	p->eigenvalue[0] = eigenvalues(g.nu - 2, chart_h(g));
	p->eigenvalue[1] = eigenvalues(g.nv - 2, chart_k(g));
	p->columns = malloc(omp_get_max_threads()*WIDTH*most*sizeof *p->columns);
	if (p->columns) {
		p->along_u = sines(g.nu - 2, p->columns);
		p->along_v = sines(g.nv - 2, p->columns);
	}
	if (p->along_u && p->along_v && p->eigenvalue[0] && p->eigenvalue[1])
		return 0;
	plate_free(p);
	return PLATE_ENOMEM;
}

/* `width` columns from column i of the field whose first inner node is z. */
static void
solve_columns(const Plate *p, double a, double b, int i, int width, double *column, double *z)
{
	int n = p->g.nv - 2, nu = p->g.nu, j, k;
	double norm = 4*(p->g.nu - 1.0)*(p->g.nv - 1.0), e;

	for (j = 0; j < n; j++)
		for (k = 0; k < width; k++)
			column[k*n+j] = z[(size_t)j*nu + i + k];
	for (k = 0; k < width; k++) {
		fftw_execute_r2r(p->along_v, column + k*n, column + k*n);
		for (j = 0; j < n; j++) {
			e = p->eigenvalue[0][i+k] + p->eigenvalue[1][j];
			column[k*n+j] /= norm*e*(a*e + b);
		}
		fftw_execute_r2r(p->along_v, column + k*n, column + k*n);
	}
	for (j = 0; j < n; j++)
		for (k = 0; k < width; k++)
			z[(size_t)j*nu + i + k] = column[k*n+j];
}

static void
transform_rows(const Plate *p, double *z)
{
	int rows = 3*p->g.nv, j;

#pragma omp for schedule(static)
	for (j = 0; j < rows; j++) {
		double *row = z + (size_t)j*p->g.nu + 1;

		if (j%p->g.nv != 0 && j%p->g.nv != p->g.nv - 1)
			fftw_execute_r2r(p->along_u, row, row);
	}
}

void
plate_solve(const Plate *p, double a, double b, double *z)
{
	int inner = p->g.nu - 2, groups = (inner + WIDTH - 1)/WIDTH;
	size_t n = (size_t)p->g.nu*p->g.nv;

#pragma omp parallel
	{
		double *column = p->columns + (size_t)omp_get_thread_num()*WIDTH*(p->g.nv - 2);
		int q;

		transform_rows(p, z);
#pragma omp for schedule(static)
		for (q = 0; q < 3*groups; q++) {
			int i = q%groups*WIDTH, width = inner - i < WIDTH ? inner - i : WIDTH;

			solve_columns(p, a, b, i, width, column, z + q/groups*n + p->g.nu + 1);
		}
		transform_rows(p, z);
	}
}
