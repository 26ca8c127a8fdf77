/* warpenergy.c - the energy of a map between two charts. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "warpenergy.h"

int
warpenergy_init(WarpEnergy *e, int nu, int nv, double T, int M)
{
	size_t n = (size_t)nu*nv;

	memset(e, 0, sizeof *e);
	e->nu = nu;
	e->nv = nv;
	e->T = T;
	e->M = M;
	if (!(e->f = malloc((4*n + nv)*sizeof *e->f)) || warpmodes_init(&e->modes, nu, nv, M) ||
	    warpdistortion_init(&e->distortion, nu, nv, T)) {
		warpenergy_free(e);
		return WARP_ENOMEM;
	}
	e->g = e->f + 2*n;
	e->row = e->g + 2*n;
	return 0;
}

void
warpenergy_free(WarpEnergy *e)
{
	free(e->f);
	warpmodes_free(&e->modes);
	warpdistortion_free(&e->distortion);
	memset(e, 0, sizeof *e);
}

void
warpenergy_map(const WarpEnergy *e, const double *x)
{
	size_t n = (size_t)e->nu*e->nv, p;
	int i, j;

	warpmodes_field(&e->modes, x, e->f);
	for (j = 0, p = 0; j < e->nv; j++)
		for (i = 0; i < e->nu; i++, p++) {
			e->f[p] += i/(e->nu - 1.0);
			e->f[n+p] += j*e->T/(e->nv - 1);
		}
}

/* beta mean |f(p) - q|^2 */
static double
landmarks(const WarpEnergy *e, const double *x, double *grad)
{
	double d[2], sum = 0, s = e->marks.n ? e->beta/e->marks.n : 0;
	int i, c;

	for (i = 0; i < e->marks.n; i++) {
		const double *p = e->marks.p[i];

		warpmodes_at(e->M, e->T, x, p[0], p[1], d);
		for (c = 0; c < 2; c++) {
			d[c] += p[c] - e->marks.q[i][c];
			sum += s*d[c]*d[c];
			d[c] *= 2*s;
		}
		warpmodes_at_adjoint(e->M, e->T, d, p[0], p[1], grad);
	}
	return sum;
}

double
warpenergy(void *ctx, const double *x, double *grad)
{
	const WarpEnergy *e = ctx;
	double E;

	warpenergy_map(e, x);
	memset(e->g, 0, 2*(size_t)e->nu*e->nv*sizeof *e->g);
	E = warpdistortion(&e->distortion, e->f, e->alpha, e->g);
	if (!(E < INFINITY))
		return INFINITY;
	E *= e->alpha;
	if (e->a)
		E += warpimages_mismatch(e->nu, e->nv, e->T, e->a, e->b, e->f, e->g, e->row);
	warpmodes_adjoint(&e->modes, e->g, grad);
	return E + landmarks(e, x, grad);
}
