/* likepoints.c - moments, and a systematic sample of the area. */
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "likepoints.h"

static double
face_area(const Mesh *m, const int *c)
{
	double a[3], b[3], n[3];

	sub3(&m->xyz[3*(size_t)c[1]], &m->xyz[3*(size_t)c[0]], a);
	sub3(&m->xyz[3*(size_t)c[2]], &m->xyz[3*(size_t)c[0]], b);
	cross3(a, b, n);
	return norm3(n)/2;
}

/* The middle of a face. */
static void
face_middle(const Mesh *m, const int *c, double x[3])
{
	int k;

	for (k = 0; k < 3; k++)
		x[k] = (m->xyz[3*(size_t)c[0]+k] + m->xyz[3*(size_t)c[1]+k] + m->xyz[3*(size_t)c[2]+k])/3;
}

/* ---- moments --------------------------------------------------------- */

/* Adds the second moments about the mean of a face of area A: A/12 (sum of v v' + 9 c c') with corners v and middle
 * c. */
static void
add_moments(const Mesh *m, const int *c, double A, const double mean[3], double C[3][3])
{
	double v[4][3];
	int corner, i, k;

	face_middle(m, c, v[3]);
	for (corner = 0; corner < 3; corner++)
		memcpy(v[corner], &m->xyz[3*(size_t)c[corner]], sizeof v[corner]);
	for (corner = 0; corner < 4; corner++)
		for (i = 0; i < 3; i++)
			for (k = 0; k < 3; k++)
				C[i][k] += (corner == 3 ? 9 : 1)*A/12*(v[corner][i] - mean[i])*(v[corner][k] - mean[k]);
}

/* Sets the mean, radius and axes of p.  Returns the area. */
static double
moments(const Mesh *m, LikePoints *p)
{
	double C[3][3] = { { 0 } }, x[3], value[3], work[64], area = 0, A;
	int t, k, pass;

	for (pass = 0; pass < 2; pass++)
		for (t = 0; t < m->nf; t++) {
			const int *c = &m->tri[3*(size_t)t];

			A = face_area(m, c);
			if (pass) {
				add_moments(m, c, A/area, p->mean, C);
				continue;
			}
			face_middle(m, c, x);
			for (k = 0; k < 3; k++)
				p->mean[k] += (x[k] - p->mean[k])*(area + A > 0 ? A/(area + A) : 0);
			area += A;
		}
	p->radius = sqrt(C[0][0] + C[1][1] + C[2][2]);
	if (!(p->radius > 0 && p->radius < HUGE_VAL))
		return -1;
	/* Of a symmetric matrix; the eigenvectors are the columns for LAPACK, so rows here. */
	if (LAPACKE_dsyev_work(LAPACK_COL_MAJOR, 'V', 'U', 3, &C[0][0], 3, value, work, 64))
		return -1;
	cross3(C[0], C[1], C[2]);
	memcpy(p->axis, C, sizeof p->axis);
	return area;
}

/* ---- points ---------------------------------------------------------- */

/* The place of the middle of a face. */
static void
middle_place(Spinor *Z, const int *c, Spinor middle)
{
	double complex p = moebius_seen_from(Z[c[0]], Z[c[1]]), q = moebius_seen_from(Z[c[0]], Z[c[2]]);

	moebius_point(Z[c[0]], (p + q)/3, middle);
}

/* The middles of the faces in which the area, summed over the faces in their order, passes (k+1/2)/n of the whole. */
static void
sample(const Mesh *m, Spinor *Z, double area, LikePoints *p, int n)
{
	double sum = 0, x[3];
	int t, k;

	for (t = 0; t < m->nf; t++) {
		const int *c = &m->tri[3*(size_t)t];

		for (sum += face_area(m, c); p->n < n && sum > (p->n + 0.5)/n*area; p->n++) {
			face_middle(m, c, x);
			middle_place(Z, c, p->Z[p->n]);
			for (k = 0; k < 3; k++)
				p->x[3*p->n+k] = (x[k] - p->mean[k])/p->radius;
		}
	}
}

int
likepoints_init(LikePoints *p, const Mesh *m, Spinor *Z, int n)
{
	double area;

	*p = (LikePoints){ 0, malloc(3*n*sizeof *p->x), malloc(n*sizeof *p->Z), { 0 }, 0, { { 0 } } };
	if (!p->x || !p->Z) {
		likepoints_free(p);
		return LIKEPOINTS_ENOMEM;
	}
	area = moments(m, p);
	if (area > 0)
		sample(m, Z, area, p, n);
	if (p->n > 0)
		return 0;
	likepoints_free(p);
	return LIKEPOINTS_EVALUE;
}

void
likepoints_free(LikePoints *p)
{
	free(p->x);
	free(p->Z);
	p->x = NULL;
	p->Z = NULL;
}
