/* platefold.c - the plate on a sock, by transforms of half the doubled grid.
 *
 * Let A_m(j) be the Fourier coefficient of row j along u, turned to the middle between nodes 0 and nu-1.
 * The image of row j under the fold, row -1-j, has the coefficient conj(A_m(j)).  So on the doubled
 * column, j = -nv .. nv-1, the real part of A_m is even and the imaginary part odd.  Their sum is a real
 * column whose sines (cosines) of odd and of even number belong to one of them each, and the eigenvalues
 * of both are the same.  One transform of this column does for both.  doc/mathematics.md 6.4.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <omp.h>

#include "platepriv.h"

/* Steps of the doubled column. */
static int
steps(const Plate *p)
{
	return 2*p->g.nv - 1;
}

/* The unknown rows, and the numbers of a doubled column. */
static int
unknown_rows(const Plate *p)
{
	return p->free ? p->g.nv : p->g.nv - 1;
}

/* The workspace of a thread: two rows or a column, then the workspace of a transform. */
static size_t
front_room(const Plate *p)
{
	size_t row = 2*(size_t)p->g.nu, column = 2*(size_t)p->g.nv;

	return ((row > column ? row : column) + 7)/8*8;
}

static size_t
room(const Plate *p)
{
	return front_room(p) + (transform_room(&p->transform[1]) + 7)/8*8;
}

int
platefold_init(Plate *p)
{
	int nu = p->g.nu, e = transform_init(&p->transform[0], nu) || transform_init(&p->transform[1], steps(p));

	if (!e)
		p->work = fftw_alloc_real(omp_get_max_threads()*room(p));
	if (!p->work)
		return PLATE_ENOMEM;
	p->eigenvalue[0] = plate_eigenvalues(nu/2 + 1, 0, nu, chart_h(p->g));
	p->eigenvalue[1] = plate_eigenvalues(2*unknown_rows(p), p->free ? 0 : 1, 2.0*steps(p), chart_k(p->g));
	p->plan[0] = fftw_plan_r2r_1d(nu, p->work, p->work + nu, FFTW_R2HC, FFTW_ESTIMATE | FFTW_UNALIGNED);
	p->plan[1] = fftw_plan_r2r_1d(nu, p->work, p->work + nu, FFTW_HC2R, FFTW_ESTIMATE | FFTW_UNALIGNED);
	return p->plan[0] && p->plan[1] ? 0 : PLATE_ENOMEM;
}

/* Multiplies the half-complex coefficients x by exp(-i pi m/nu), or its inverse.  The last one, m = nu/2,
 * becomes purely imaginary, and is kept as its imaginary part. */
static void
turn(const Transform *t, int back, double *x)
{
	double re, im, c, s;
	int m, nu = t->N;

	for (m = 1; 2*m < nu; m++) {
		c = t->cosines[m], s = back ? t->sines[m] : -t->sines[m];
		re = x[m], im = x[nu-m];
		x[m] = c*re - s*im;
		x[nu-m] = s*re + c*im;
	}
	x[nu/2] = -x[nu/2];
}

static void
transform_rows(const Plate *p, int back, double *z, double *work)
{
	int nu = p->g.nu, rows = unknown_rows(p), n = 3*rows, q;

#pragma omp for schedule(static)
	for (q = 0; q < n; q++) {
		double *row = z + ((size_t)(q/rows)*p->g.nv + q%rows)*nu;

		memcpy(work, row, nu*sizeof *row);
		if (back)
			turn(&p->transform[0], 1, work);
		fftw_execute_r2r(p->plan[back], work, work + nu);
		if (!back)
			turn(&p->transform[0], 0, work + nu);
		memcpy(row, work + nu, nu*sizeof *row);
	}
}

static void
transform(const Plate *p, double *column, double *work)
{
	if (p->free)
		transform_cosine(&p->transform[1], column, work);
	else
		transform_sine(&p->transform[1], column, work);
}

/* Solves for the coefficients number m along u of one field. */
static void
solve_column(const Plate *p, double a, double b, double c, int m, double *z, double *column)
{
	int nu = p->g.nu, rows = unknown_rows(p), j, has_re = 2*m < nu, has_im = m > 0;
	double norm = nu*(double)steps(p)/2, e, re, im, *work = column + front_room(p);

	for (j = 0; j < rows; j++) {
		re = has_re ? z[(size_t)j*nu + m] : 0;
		im = has_im ? z[(size_t)j*nu + nu - m] : 0;
		column[rows+j] = re + im;
		column[rows-1-j] = re - im;
	}
	transform(p, column, work);
	for (j = 0; j < 2*rows; j++) {
		e = p->eigenvalue[0][m] + p->eigenvalue[1][j];
		column[j] /= norm*(e*(a*e + b) + c);
	}
	transform(p, column, work);
	for (j = 0; j < rows; j++) {
		if (has_re)
			z[(size_t)j*nu + m] = (column[rows+j] + column[rows-1-j])/2;
		if (has_im)
			z[(size_t)j*nu + nu - m] = (column[rows+j] - column[rows-1-j])/2;
	}
}

/* The constant c0 of plate.h.  The waves of one cycle in the doubled column are odd, so they are not
 * constant along u. */
static double
shift(const Plate *p, double b)
{
	return p->free ? b*fmin(p->eigenvalue[0][1], p->eigenvalue[1][2]) : 0;
}

void
platefold_solve(const Plate *p, double a, double b, double c, double *z)
{
	int columns = p->g.nu/2 + 1, k, i;
	size_t n = (size_t)p->g.nu*p->g.nv;

	c += shift(p, b);
	for (k = 0; k < 3 && p->free; k++)
		for (i = 0; i < p->g.nu; i++)
			z[k*n + n - 1 - i] *= 2;        /* W^-1 */
#pragma omp parallel
	{
		double *work = p->work + omp_get_thread_num()*room(p);
		int q;

		transform_rows(p, 0, z, work);
#pragma omp for schedule(static)
		for (q = 0; q < 3*columns; q++)
			solve_column(p, a, b, c, q%columns, z + q/columns*n, work);
		transform_rows(p, 1, z, work);
	}
}
