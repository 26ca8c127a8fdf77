/* parts.c - parts of equal area by halving, and the trimmed chi^2. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "parts.h"

enum { BINS = 16*160 };                 /* of ratios from 2^-80 to 2^80 */
static const double TRIMMED = 0.01;     /* of the area: as much as mesh2rect -n auto may lose.  Nostrils and
                                         * folds would outweigh all limbs */

static const double LOST = 100;

static int
by_real(const void *x, const void *y)
{
	double a = creal(((const PartFace *)x)->z), b = creal(((const PartFace *)y)->z);

	return (a > b) - (a < b);
}

static int
by_imag(const void *x, const void *y)
{
	double a = cimag(((const PartFace *)x)->z), b = cimag(((const PartFace *)y)->z);

	return (a > b) - (a < b);
}

/* Whether the faces extend farther along the real axis. */
static int
is_wide(const PartFace *f, int n)
{
	double lo[2] = { HUGE_VAL, HUGE_VAL }, hi[2] = { -HUGE_VAL, -HUGE_VAL };
	int i;

	for (i = 0; i < n; i++) {
		lo[0] = fmin(lo[0], creal(f[i].z)), hi[0] = fmax(hi[0], creal(f[i].z));
		lo[1] = fmin(lo[1], cimag(f[i].z)), hi[1] = fmax(hi[1], cimag(f[i].z));
	}
	return hi[0] - lo[0] >= hi[1] - lo[1];
}

static void
add_part(Parts *p, const PartFace *f, int n)
{
	double A = 0, S = 0;
	double complex z = 0;
	int i;

	for (i = 0; i < n; i++) {
		A += f[i].A;
		S += f[i].S;
		z += f[i].A*f[i].z;
	}
	if (!(A > 0 && S > 0))
		return;
	p->A[p->n] = A;
	p->S[p->n] = S;
	p->z[p->n++] = z/A;
}

void
parts_of_faces(Parts *p, PartFace *f, int n, int parts)
{
	double half = 0, sum = 0;
	int i;

	if (parts <= 1 || n <= 1) {
		add_part(p, f, n);
		return;
	}
	qsort(f, n, sizeof *f, is_wide(f, n) ? by_real : by_imag);
	for (i = 0; i < n; i++)
		half += f[i].A/2;
	for (i = 0; i < n - 1 && (i == 0 || sum + f[i].A/2 < half); i++)
		sum += f[i].A;
	parts_of_faces(p, f, i, parts/2);
	parts_of_faces(p, f + i, n - i, parts/2);
}

static PartFace
face_of(const Mesh *m, const double complex *z, int t)
{
	const int *c = &m->tri[3*(size_t)t];
	double complex a = z[c[1]] - z[c[0]], b = z[c[2]] - z[c[0]];
	double e[3], g[3], n[3];

	sub3(m->xyz + 3*(size_t)c[1], m->xyz + 3*(size_t)c[0], e);
	sub3(m->xyz + 3*(size_t)c[2], m->xyz + 3*(size_t)c[0], g);
	cross3(e, g, n);
	return (PartFace){ norm3(n)/2, fabs(cimag(conj(a)*b))/2, (z[c[0]] + z[c[1]] + z[c[2]])/3 };
}

int
parts_init(Parts *p, const Mesh *m, const double complex *z)
{
	PartFace *f = malloc(m->nf*sizeof *f);
	int t;

	*p = (Parts){ 0, malloc(PARTS_MOST*sizeof *p->A), malloc(PARTS_MOST*sizeof *p->S), malloc(PARTS_MOST*sizeof *p->z) };
	if (!f || !p->A || !p->S || !p->z) {
		free(f);
		parts_free(p);
		return PARTS_ENOMEM;
	}
	for (t = 0; t < m->nf; t++)
		f[t] = face_of(m, z, t);
	parts_of_faces(p, f, m->nf, PARTS_MOST);
	free(f);
	return 0;
}

void
parts_free(Parts *p)
{
	free(p->A);
	free(p->S);
	free(p->z);
	memset(p, 0, sizeof *p);
}

/* The bin of a ratio: sixteen for each power of two. */
static int
bin_of(double ratio)
{
	int e;
	double m = frexp(ratio, &e);

	e += BINS/32;
	return e < 0 ? 0 : e >= BINS/16 ? BINS - 1 : 16*e + (int)(32*m - 16);
}

/* The lowest bin whose parts, with those of all higher bins, have at most that share of the area. */
static int
trim(int n, const double *A, const double *ratio, double share)
{
	double area[BINS] = { 0 }, left = 0;
	int i, b;

	for (i = 0; i < n; i++) {
		area[bin_of(ratio[i])] += A[i];
		left += share*A[i];
	}
	for (b = BINS - 1; b >= 0 && area[b] <= left; b--)
		left -= area[b];
	return b + 1;
}

double
parts_bound(int n, const double *A, const double *ratio, double share)
{
	int b = trim(n, A, ratio, share);

	return b >= BINS ? HUGE_VAL : ldexp(16 + b%16, b/16 - BINS/32 - 5);
}

double
parts_chi2(int n, const double *A, const double *ratio)
{
	double area = 0, sum = 0, inverse = 0;
	int i, end = trim(n, A, ratio, TRIMMED);

	for (i = 0; i < n; i++) {
		if (bin_of(ratio[i]) >= end)
			continue;
		area += A[i];
		sum += A[i]/ratio[i];
		inverse += A[i]*ratio[i];
	}
	return inverse*sum/(area*area);
}

double
parts_lost(int n, const double *A, const double *ratio)
{
	double area = 0, sum = 0, lost = 0;
	int i;

	for (i = 0; i < n; i++) {
		area += A[i];
		sum += A[i]/ratio[i];
	}
	for (i = 0; i < n; i++)
		lost += A[i]/(area/(ratio[i]*sum) + 1/LOST);
	return lost/area;
}
