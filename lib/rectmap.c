/* rectmap.c - the two harmonic functions and the modulus. */
#include <stdlib.h>
#include <string.h>

#include "rectmap.h"
#include "vec3.h"

/* Half the cotangent of each angle of triangle t: w[k] belongs to the edge that faces
 * corner k. */
static void
half_cotangents(const Mesh *m, int t, double w[3])
{
	const int *c = &m->tri[3*t];
	double a[3], b[3], n[3];
	int k;

	for (k = 0; k < 3; k++) {
		const double *x = &m->xyz[3*c[k]];

		sub3(&m->xyz[3*c[(k+1)%3]], x, a);
		sub3(&m->xyz[3*c[(k+2)%3]], x, b);
		cross3(a, b, n);
		w[k] = dot3(a, b)/(2*norm3(n));
	}
}

void
cotangent_apply(const Mesh *m, const double *x, double *y)
{
	double w[3], flow;
	int t, k;

	memset(y, 0, m->nv*sizeof *y);
	for (t = 0; t < m->nf; t++) {
		half_cotangents(m, t, w);
		for (k = 0; k < 3; k++) {
			int i = m->tri[3*t + (k+1)%3], j = m->tri[3*t + (k+2)%3];

			flow = w[k]*(x[i] - x[j]);
			y[i] += flow;
			y[j] -= flow;
		}
	}
}

static double
energy(const Mesh *m, const double *x, double *work)
{
	double e = 0;
	int i;

	cotangent_apply(m, x, work);
	for (i = 0; i < m->nv; i++)
		e += x[i]*work[i];
	return e;
}

/* The rows and columns of C where free[i] >= 0, its new number. */
static int
assemble(const Mesh *m, const int *number, int n, Spd *a)
{
	double w[3];
	int t, k, e = spd_init(a, n, 9*(size_t)m->nf);

	if (e)
		return e;
	for (t = 0; t < m->nf; t++) {
		half_cotangents(m, t, w);
		for (k = 0; k < 3; k++) {
			int i = number[m->tri[3*t + (k+1)%3]], j = number[m->tri[3*t + (k+2)%3]];

			if (i >= 0)
				spd_add(a, i, i, w[k]);
			if (j >= 0)
				spd_add(a, j, j, w[k]);
			if (i >= 0 && j >= 0)
				spd_add(a, i, j, -w[k]);
		}
	}
	return 0;
}

/* Sets side vertices of the loop, from corner a to corner b, to a value. */
static void
hold(const Disk *d, int a, int b, double value, double *x, int *number)
{
	int i;

	for (i = a; ; i = (i + 1)%d->nb) {
		x[d->loop[i]] = value;
		number[d->loop[i]] = -1;
		if (i == b)
			break;
	}
}

/* x harmonic, 0 on the side from zero[0] to zero[1] of the loop, 1 on the other, no
 * condition elsewhere.  C_ff x_f = -C_fs x_s for free f and sides s. */
static int
harmonic(const Disk *d, const int zero[2], const int one[2], double *x, SpdReport *report)
{
	int nv = d->m.nv, n = 0, i, e = SPD_ENOMEM;
	int *number = calloc(nv, sizeof *number);
	double *y = malloc(nv*sizeof *y);
	Spd a;

	if (!number || !y)
		goto done;
	memset(x, 0, nv*sizeof *x);
	hold(d, zero[0], zero[1], 0, x, number);
	hold(d, one[0], one[1], 1, x, number);
	cotangent_apply(&d->m, x, y);
	for (i = 0; i < nv; i++)
		if (number[i] >= 0) {
			y[n] = -y[i];
			number[i] = n++;
		}
	e = assemble(&d->m, number, n, &a);
	if (!e)
		e = spd_solve(&a, NULL, 1, y, report);
	for (i = 0; !e && i < nv; i++)
		if (number[i] >= 0)
			x[i] = y[number[i]];
done:
	free(number);
	free(y);
	return e;
}

int
rectmap(const Disk *d, const int corner[4], double *u, double *v, double *T,
	double *certificate, SpdReport *report)
{
	const int left[2] = { corner[3], corner[0] }, right[2] = { corner[1], corner[2] };
	const int bottom[2] = { corner[0], corner[1] }, top[2] = { corner[2], corner[3] };
	double *work = malloc(d->m.nv*sizeof *work), Eu, Ev;
	int i, e = SPD_ENOMEM;

	if (work)
		e = harmonic(d, left, right, u, report);
	if (!e)
		e = harmonic(d, bottom, top, v, report);
	if (!e) {
		Eu = energy(&d->m, u, work);
		Ev = energy(&d->m, v, work);
		*T = sqrt(Eu/Ev);
		*certificate = sqrt(Eu*Ev) - 1;
		for (i = 0; i < d->m.nv; i++)
			v[i] *= *T;
	}
	free(work);
	return e;
}

int
rectmap_flipped(const Mesh *m, const double *u, const double *v)
{
	int t, flipped = 0;

	for (t = 0; t < m->nf; t++) {
		int a = m->tri[3*t], b = m->tri[3*t+1], c = m->tri[3*t+2];

		flipped += (u[b] - u[a])*(v[c] - v[a]) - (u[c] - u[a])*(v[b] - v[a]) < 0;
	}
	return flipped;
}
