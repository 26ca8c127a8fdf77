/* platefold.c - the plate on a sock or a pillow, by transforms of half the doubled grid.
 *
 * Let A_m(j) be the Fourier coefficient of row j along u, turned to the middle between nodes 0 and nu-1.
 * The image of row j under the fold, row -1-j, has the coefficient conj(A_m(j)).  So on the doubled
 * column, j = -nv .. nv-1, the real part of A_m is even and the imaginary part odd.  Their sum is a real
 * column whose sines (cosines) of odd and of even number belong to one of them each, and the eigenvalues
 * of both are the same.  One transform of this column does for both.  doc/mathematics.md 6.4.
 *
 * On the pillow the doubled column is periodic, and its real Fourier coefficients take the place of the sines or
 * cosines.
 */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <omp.h>

#include "platepriv.h"

static int
is_closed(const Plate *p)
{
	return p->g.kind->closed;
}

/* Steps of the doubled column. */
static int
steps(const Plate *p)
{
	return is_closed(p) ? 2*p->g.nv : 2*p->g.nv - 1;
}

static int
unknown_rows(const Plate *p)
{
	return p->free || is_closed(p) ? p->g.nv : p->g.nv - 1;
}

/* Where, in the workspace of a thread, the Fourier coefficients of a row begin: after the row. */
static size_t
spectrum_offset(const Plate *p)
{
	return ((size_t)p->g.nu + 7)/8*8;
}

/* The numbers of a doubled column. */
static size_t
column_room(const Plate *p)
{
	return (2*(size_t)p->g.nv + 7)/8*8;
}

/* The workspace of a thread: a row and its coefficients, or two columns; then the workspace of a transform. */
static size_t
front_room(const Plate *p)
{
	size_t row = (spectrum_offset(p) + p->g.nu + 2 + 7)/8*8, columns = 2*column_room(p);

	return row > columns ? row : columns;
}

static size_t
room(const Plate *p)
{
	return front_room(p) + (is_closed(p) ? 0 : (transform_pair_room(&p->transform[1]) + 7)/8*8);
}

/* The plans of the doubled columns of a pillow, and the eigenvalues along doubled columns, in the order of the
 * coefficients. */
static int
init_columns(Plate *p)
{
	int n = steps(p);

	p->eigenvalue[1] = is_closed(p) ? plate_eigenvalues(n, 0, n, chart_k(p->g))
	    : plate_eigenvalues(2*unknown_rows(p), p->free ? 0 : 1, 2.0*n, chart_k(p->g));
	if (!is_closed(p))
		return 0;
	p->column[0] = fftw_plan_r2r_1d(n, p->work, p->work, FFTW_R2HC, FFTW_ESTIMATE);
	p->column[1] = fftw_plan_r2r_1d(n, p->work, p->work, FFTW_HC2R, FFTW_ESTIMATE);
	return !p->column[0] || !p->column[1];
}

static int
init_rows(Plate *p)
{
	fftw_complex *spectrum = (fftw_complex *)(p->work + spectrum_offset(p));
	int nu = p->g.nu;

	p->eigenvalue[0] = plate_eigenvalues(nu/2 + 1, 0, nu, chart_h(p->g));
	p->plan[0] = fftw_plan_dft_r2c_1d(nu, p->work, spectrum, FFTW_ESTIMATE);
	p->plan[1] = fftw_plan_dft_c2r_1d(nu, spectrum, p->work, FFTW_ESTIMATE);
	return transform_init(&p->transform[0], nu) || !p->plan[0] || !p->plan[1];
}

int
platefold_init(Plate *p)
{
	Transform *columns = &p->transform[1];

	if (!is_closed(p) && (transform_init(columns, steps(p)) || transform_init_pair(columns)))
		return PLATE_ENOMEM;
	p->work = fftw_alloc_real(omp_get_max_threads()*room(p));
	return !p->work || init_rows(p) || init_columns(p) ? PLATE_ENOMEM : 0;
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
transform_columns(const Plate *p, int back, double *column[2], double *work)
{
	int l;

	if (is_closed(p))
		for (l = 0; l < 2; l++)
			fftw_execute_r2r(p->column[back], column[l], column[l]);
	else if (p->free)
		transform_cosine_pair(&p->transform[1], column[0], column[1], work);
	else
		transform_sine_pair(&p->transform[1], column[0], column[1], work);
}

/* Copies the coefficients number m along u of one field, z, to the doubled column, and back. */
static void
copy_in(const Plate *p, int m, const double *z, double *column)
{
	int nu = p->g.nu, rows = unknown_rows(p), j, has_re = 2*m < nu, has_im = m > 0;
	double re, im;

	for (j = 0; j < rows; j++) {
		re = has_re ? z[(size_t)j*nu + m] : 0;
		im = has_im ? z[(size_t)j*nu + nu - m] : 0;
		column[rows+j] = re + im;
		column[rows-1-j] = re - im;
	}
}

static void
copy_out(const Plate *p, int m, const double *column, double *z)
{
	int nu = p->g.nu, rows = unknown_rows(p), j;

	for (j = 0; j < rows; j++) {
		if (2*m < nu)
			z[(size_t)j*nu + m] = (column[rows+j] + column[rows-1-j])/2;
		if (m > 0)
			z[(size_t)j*nu + nu - m] = (column[rows+j] - column[rows-1-j])/2;
	}
}

static void
divide(const Plate *p, double a, double b, double c, int m, double *column)
{
	int n = 2*unknown_rows(p), j;
	double norm = p->g.nu*(double)steps(p)/(is_closed(p) ? 1 : 2), e;

	for (j = 0; j < n; j++) {
		e = p->eigenvalue[0][m] + p->eigenvalue[1][j];
		column[j] /= norm*(e*(a*e + b) + c);
	}
}

/* Solves for the columns number q and q+1 of all columns of the three fields; for the last alone if there is
 * no other. */
static void
solve_columns(const Plate *p, double a, double b, double c, int q, double *z, double *work)
{
	size_t n = (size_t)p->g.nu*p->g.nv;
	int columns = p->g.nu/2 + 1, last = q + 1 < 3*columns ? 1 : 0, l, at[2] = { q, q + last };
	double *column[2] = { work, work + column_room(p) };

	for (l = 0; l < 2; l++)
		copy_in(p, at[l]%columns, z + at[l]/columns*n, column[l]);
	transform_columns(p, 0, column, work + front_room(p));
	for (l = 0; l < 2; l++)
		divide(p, a, b, c, at[l]%columns, column[l]);
	transform_columns(p, 1, column, work + front_room(p));
	for (l = 0; l <= last; l++)
		copy_out(p, at[l]%columns, column[l], z + at[l]/columns*n);
}

/* The constant c0 of plate.h.  On the sock the waves of one cycle in the doubled column are odd, so they are not
 * constant along u. */
static double
shift(const Plate *p, double b)
{
	if (is_closed(p))
		return b*fmin(p->eigenvalue[0][1], p->eigenvalue[1][1]);
	return p->free ? b*fmin(p->eigenvalue[0][1], p->eigenvalue[1][2]) : 0;
}

void
platefold_solve(const Plate *p, double a, double b, double c, double *z)
{
	int columns = p->g.nu/2 + 1, k, i;
	size_t n = (size_t)p->g.nu*p->g.nv;

	c += shift(p, b);
	for (k = 0; k < 3 && p->free && !is_closed(p); k++)
		for (i = 0; i < p->g.nu; i++)
			z[k*n + n - 1 - i] *= 2;        /* W^-1 */
#pragma omp parallel
	{
		double *work = p->work + omp_get_thread_num()*room(p);
		int q;

		transform_rows(p, 0, z, work);
#pragma omp for schedule(static)
		for (q = 0; q < 3*columns; q += 2)
			solve_columns(p, a, b, c, q, z, work);
		transform_rows(p, 1, z, work);
	}
}
