/* sphereplace.c - centre, orientation and means of points of the sphere. */
#include <stdlib.h>
#include <string.h>

#include "sphereface.h"
#include "sphereplace.h"

enum { CENTRING = 200 };        /* steps */

/* The areas of the faces at each vertex. */
static void
areas_at_vertices(const Mesh *m, double *area)
{
	int t, k;

	memset(area, 0, m->nv*sizeof *area);
	for (t = 0; t < m->nf; t++) {
		double twice = sphereface_area2(m, t);

		for (k = 0; k < 3; k++)
			area[m->tri[3*(size_t)t+k]] += twice;
	}
}

/* One step towards the centre and the size of z, below. */
static double
centre_step(int n, const double complex *at, const double *area, double complex *centre, double *size)
{
	double sum[2] = { 0, 0 }, w, far;
	double complex z = 0, old = *centre;
	int i;

	for (i = 0; i < n; i++) {
		far = moebius_square(at[i] - old);
		w = area[i]/(far + *size**size);
		z += w*at[i];
		sum[0] += w;
		sum[1] += w*far;
	}
	*centre = z/sum[0];
	far = sqrt(sum[1]/sum[0]);
	w = fabs(far - *size) + cabs(*centre - old);
	*size = far;
	return w/far;
}

/* The iteration is the EM algorithm for
 * the position and the width of a Cauchy distribution, which has the same equations; it does not depend on the
 * direction of the axes of z. */
int
sphereplace_centre(const Mesh *m, double complex *z)
{
	double *area = malloc(m->nv*sizeof *area), size, all = 0;
	double complex middle = 0;
	int n = m->nv, i, k;

	if (!area)
		return SPHEREPLACE_ENOMEM;
	areas_at_vertices(m, area);
	for (i = 0; i < n; i++) {
		middle += area[i]*z[i];
		all += area[i];
	}
	middle /= all;
	for (size = 0, i = 0; i < n; i++)
		size += area[i]*cabs(z[i] - middle)/all;
	for (k = 0; k < CENTRING && centre_step(n, z, area, &middle, &size) > 1e-14; k++)
		;
	for (i = 0; i < n; i++)
		z[i] = (z[i] - middle)/size;
	free(area);
	return 0;
}

void
sphereplace_orient(const Mesh *m, double complex *z)
{
	int i, t, turned = 0;

	for (t = 0; t < m->nf; t++) {
		const int *c = &m->tri[3*(size_t)t];

		turned += cimag(conj(z[c[1]] - z[c[0]])*(z[c[2]] - z[c[0]])) < 0;
	}
	for (i = 0; 2*turned > m->nf && i < m->nv; i++)
		z[i] = conj(z[i]);
}

void
sphereplace_put(int n, const double complex *z, Spinor *Z)
{
	int i;

	for (i = 0; i < n; i++) {
		double r = cabs(z[i]), norm = hypot(1, r < 1 ? r : 1/r);

		Z[i][0] = (r < 1 ? z[i] : z[i]/r)/norm;
		Z[i][1] = (r < 1 ? 1 : 1/r)/norm;
	}
}

void
sphereplace_get(int n, Spinor *Z, double complex *z)
{
	int i;

	for (i = 0; i < n; i++)
		z[i] = Z[i][1] == 0 ? SPHEREPLACE_FAR : Z[i][0]/Z[i][1];
}

/* The means are those of vectors, which are multiplied by numbers of modulus 1,
 * so that all products with the first are real. */
void
sphereplace_extend(const Subdivision *s, int from, Spinor *Z)
{
	int i, k;

	for (i = from; i < s->d.m.nv; i++) {
		const int *c = s->corner[i - s->given];
		const double *w = s->w[i - s->given];
		const double complex *a = NULL, *b;
		double complex turn;

		Z[i][0] = Z[i][1] = 0;
		for (k = 0; k < 3; k++) {
			if (!(w[k] > 0))
				continue;
			b = Z[c[k]];
			a = a ? a : b;
			turn = conj(b[0])*a[0] + conj(b[1])*a[1];
			Z[i][0] += w[k]*turn/cabs(turn)*b[0];
			Z[i][1] += w[k]*turn/cabs(turn)*b[1];
		}
		moebius_normalise(Z[i]);
	}
}
