/* sphereparts.c - parts of either half of the sphere, and their chi^2. */
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "parts.h"
#include "sphereparts.h"

enum { CLUSTERS = 4 };                  /* faces are put together until there are this many times `parts` */
static const double TRIMMED = 0.001;    /* of the area.  With 1 %, as on the sock, the farthest vertex of a
                                         * skull is three times as far from the grid */
static const double SPREAD = 1./16;     /* |p x Z|^2 is taken as |p x Z|^2 + S/16, the mean over a part that holds
                                         * the cone */

/* ---- the parts ------------------------------------------------------- */

typedef struct Face {
	PartFace f;
	uint64_t key;
	int      t;
} Face;

static double
face_area(const Mesh *m, const int c[3])
{
	double a[3], b[3], n[3];

	sub3(&m->xyz[3*(size_t)c[1]], &m->xyz[3*(size_t)c[0]], a);
	sub3(&m->xyz[3*(size_t)c[2]], &m->xyz[3*(size_t)c[0]], b);
	cross3(a, b, n);
	return norm3(n)/2;
}

/* The bits of x in -1 .. 1, each followed by a 0. */
static uint64_t
spread(double x)
{
	uint64_t k = (uint64_t)((fmin(fmax(x, -1), 1) + 1)*0x7fffffff);

	k = (k | k << 16) & 0x0000ffff0000ffff;
	k = (k | k << 8) & 0x00ff00ff00ff00ff;
	k = (k | k << 4) & 0x0f0f0f0f0f0f0f0f;
	k = (k | k << 2) & 0x3333333333333333;
	return (k | k << 1) & 0x5555555555555555;
}

/* Face t in the plane of z, or of 1/z if `far`, seen from its corner 0.  Returns whether it belongs to that half of
 * the sphere. */
static int
face_part(const Mesh *m, Spinor *Z, int t, int far, Face *face)
{
	const int *c = &m->tri[3*(size_t)t];
	double complex p = moebius_seen_from(Z[c[0]], Z[c[1]]), q = moebius_seen_from(Z[c[0]], Z[c[2]]), z;
	Spinor middle;

	moebius_point(Z[c[0]], (p + q)/3, middle);
	if ((moebius_square(middle[0]) > moebius_square(middle[1])) != far)
		return 0;
	z = far ? middle[1]/middle[0] : middle[0]/middle[1];
	face->f = (PartFace){ face_area(m, c), fabs(cimag(conj(p)*q))/(2*M_PI), z };
	face->t = t;
	face->key = spread(creal(z)) | spread(cimag(z)) << 1;
	return 1;
}

static int
by_key(const void *a, const void *b)
{
	const Face *x = a, *y = b;

	return x->key != y->key ? (x->key > y->key) - (x->key < y->key) : (x->t > y->t) - (x->t < y->t);
}

/* Puts neighbours together, in the order of the keys (Morton's), until a cluster has the given area.  Returns the
 * number of clusters. */
static int
cluster(Face *face, int n, double area, PartFace *f)
{
	double complex z = 0;
	PartFace sum = { 0, 0, 0 };
	int i, k = 0;

	qsort(face, n, sizeof *face, by_key);
	for (i = 0; i < n; i++) {
		sum.A += face[i].f.A;
		sum.S += face[i].f.S;
		z += face[i].f.A*face[i].f.z;
		if (sum.A >= area || i == n - 1) {
			sum.z = z/sum.A;
			f[k++] = sum;
			sum = (PartFace){ 0, 0, 0 };
			z = 0;
		}
	}
	return k;
}

static void
append(SphereParts *p, const Parts *half, int far)
{
	int i;

	for (i = 0; i < half->n; i++, p->n++) {
		p->A[p->n] = half->A[i];
		p->S[p->n] = half->S[i];
		p->Z[p->n][far] = half->z[i];
		p->Z[p->n][!far] = 1;
		moebius_normalise(p->Z[p->n]);
	}
}

int
sphereparts_init(SphereParts *p, const Mesh *m, Spinor *Z, int parts)
{
	Face *face = malloc(m->nf*sizeof *face);
	PartFace *f = malloc(m->nf*sizeof *f);
	Parts half = { 0, malloc(PARTS_MOST*sizeof *half.A), malloc(PARTS_MOST*sizeof *half.S),
	    malloc(PARTS_MOST*sizeof *half.z) };
	double area = mesh_area(m)/(2*CLUSTERS*(double)parts);
	int far, t, n, e;

	*p = (SphereParts){ 0, malloc(2*PARTS_MOST*sizeof *p->A), malloc(2*PARTS_MOST*sizeof *p->S),
	    malloc(2*PARTS_MOST*sizeof *p->Z), malloc(2*PARTS_MOST*sizeof *p->ratio) };
	e = face && f && half.A && half.S && half.z && p->A && p->S && p->ratio && p->Z ? 0 : SPHEREPARTS_ENOMEM;
	for (far = 0; !e && far < 2; far++) {
		for (n = t = 0; t < m->nf; t++)
			n += face_part(m, Z, t, far, &face[n]);
		half.n = 0;
		parts_of_faces(&half, f, cluster(face, n, area, f), parts);
		append(p, &half, far);
	}
	free(face);
	free(f);
	parts_free(&half);
	if (e)
		sphereparts_free(p);
	return e;
}

void
sphereparts_free(SphereParts *p)
{
	free(p->A);
	free(p->S);
	free(p->Z);
	free(p->ratio);
	memset(p, 0, sizeof *p);
}

/* ---- chi^2 ----------------------------------------------------------- */

static double
softened(double complex x, double S)
{
	return moebius_square(x) + SPREAD*4*M_PI*S;
}

/* Sets p->ratio, and returns the bound from which on parts are trimmed. */
static double
set_ratios(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES])
{
	double q;
	int i, k;

	for (i = 0; i < p->n; i++) {
		for (q = 1, k = 0; k < SPHEREPARTS_CONES; k++)
			q *= softened(moebius_cross(cone[k], p->Z[i]), p->S[i]);
		p->ratio[i] = p->A[i]/p->S[i]*sqrt(q);
	}
	return parts_bound(p->n, p->A, p->ratio, TRIMMED);
}

/* Sets sum to those of A^2/a, a, A over the parts that are left. */
static void
add_sums(const SphereParts *p, double bound, double sum[3])
{
	int i;

	memset(sum, 0, 3*sizeof *sum);
	for (i = 0; i < p->n; i++)
		if (p->ratio[i] < bound) {
			sum[0] += p->A[i]*p->ratio[i];
			sum[1] += p->A[i]/p->ratio[i];
			sum[2] += p->A[i];
		}
}

static double
log_chi2(const double sum[3])
{
	return log(sum[0]/sum[2]*(sum[1]/sum[2]));
}

double
sphereparts_value(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES])
{
	double sum[3];

	add_sums(p, set_ratios(p, cone), sum);
	return log_chi2(sum);
}

/* The derivatives of log A/a of part i by the eight numbers. */
static void
slopes(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES], int i, double d[SPHEREPARTS_FREE])
{
	int k;

	for (k = 0; k < SPHEREPARTS_CONES; k++) {
		const double complex *c = cone[k], *Z = p->Z[i];
		double complex x = moebius_cross(c, Z), along = conj(c[1])*Z[1] + conj(c[0])*Z[0];
		double complex D = conj(x)*along/softened(x, p->S[i]);

		d[2*k] = creal(D);
		d[2*k+1] = -cimag(D);
	}
}

double
sphereparts_derivatives(const SphereParts *p, Spinor cone[SPHEREPARTS_CONES], double g[SPHEREPARTS_FREE],
	double H[SPHEREPARTS_FREE][SPHEREPARTS_FREE])
{
	enum { N = SPHEREPARTS_FREE };
	double bound = set_ratios(p, cone), sum[3], d[N], mean[2][N] = { { 0 } }, w[2];
	int i, k, l;

	add_sums(p, bound, sum);
	memset(H, 0, N*sizeof *H);
	for (i = 0; i < p->n; i++) {
		if (!(p->ratio[i] < bound))
			continue;
		w[0] = p->A[i]*p->ratio[i]/sum[0];
		w[1] = p->A[i]/p->ratio[i]/sum[1];
		slopes(p, cone, i, d);
		for (k = 0; k < N; k++) {
			mean[0][k] += w[0]*d[k];
			mean[1][k] += w[1]*d[k];
			for (l = 0; l <= k; l++)
				H[k][l] += (w[0] + w[1])*d[k]*d[l];
		}
	}
	for (k = 0; k < N; k++) {
		g[k] = mean[0][k] - mean[1][k];
		for (l = 0; l <= k; l++)
			H[l][k] = H[k][l] -= mean[0][k]*mean[0][l] + mean[1][k]*mean[1][l];
	}
	return log_chi2(sum);
}
