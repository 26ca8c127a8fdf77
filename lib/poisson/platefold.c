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

/* Where, in the workspace of a thread, the Fourier coefficients of a row begin: after the row. */
static size_t
spectrum_offset(const Plate *p)
{
	return ((size_t)p->g.nu + 7)/8*8;
}

/* The workspace of a thread: a row and its coefficients, or a column; then the workspace of a transform. */
static size_t
front_room(const Plate *p)
{
	size_t row = spectrum_offset(p) + p->g.nu + 2, column = 2*(size_t)p->g.nv;

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
	fftw_complex *spectrum;

	if (!e)
		p->work = fftw_alloc_real(omp_get_max_threads()*room(p));
	if (!p->work)
		return PLATE_ENOMEM;
	spectrum = (fftw_complex *)(p->work + spectrum_offset(p));
	p->eigenvalue[0] = plate_eigenvalues(nu/2 + 1, 0, nu, chart_h(p->g));
	p->eigenvalue[1] = plate_eigenvalues(2*unknown_rows(p), p->free ? 0 : 1, 2.0*steps(p), chart_k(p->g));
	p->plan[0] = fftw_plan_dft_r2c_1d(nu, p->work, spectrum, FFTW_ESTIMATE);
	p->plan[1] = fftw_plan_dft_c2r_1d(nu, spectrum, p->work, FFTW_ESTIMATE);
	return p->plan[0] && p->plan[1] ? 0 : PLATE_ENOMEM;
}

/* Replaces a row by its Fourier coefficients times exp(-i pi m/nu): the real part of number m at m, the
 * imaginary part at nu-m.  Number nu/2 becomes purely imaginary. */
static void
forward(const Plate *p, double *row, double *work)
{
	const Transform *t = &p->transform[0];
	fftw_complex *x = (fftw_complex *)(work + spectrum_offset(p));
	int nu = p->g.nu, m;

	memcpy(work, row, nu*sizeof *row);
	fftw_execute_dft_r2c(p->plan[0], work, x);
	row[0] = x[0][0];
	for (m = 1; 2*m < nu; m++) {
		row[m] = t->cosines[m]*x[m][0] + t->sines[m]*x[m][1];
		row[nu-m] = t->cosines[m]*x[m][1] - t->sines[m]*x[m][0];
	}
	row[nu/2] = -x[nu/2][0];
}

static void
backward(const Plate *p, double *row, double *work)
{
	const Transform *t = &p->transform[0];
	fftw_complex *x = (fftw_complex *)(work + spectrum_offset(p));
	int nu = p->g.nu, m;

	for (m = 1; 2*m < nu; m++) {
		x[m][0] = t->cosines[m]*row[m] - t->sines[m]*row[nu-m];
		x[m][1] = t->cosines[m]*row[nu-m] + t->sines[m]*row[m];
	}
	x[0][0] = row[0];
	x[nu/2][0] = -row[nu/2];
	x[0][1] = x[nu/2][1] = 0;
	fftw_execute_dft_c2r(p->plan[1], x, work);
	memcpy(row, work, nu*sizeof *row);
}

static void
transform_rows(const Plate *p, int back, double *z, double *work)
{
	int rows = unknown_rows(p), n = 3*rows, q;

#pragma omp for schedule(static)
	for (q = 0; q < n; q++) {
		double *row = z + ((size_t)(q/rows)*p->g.nv + q%rows)*p->g.nu;

		if (back)
			backward(p, row, work);
		else
			forward(p, row, work);
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
