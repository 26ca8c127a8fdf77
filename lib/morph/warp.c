/* warp.c - a map between the charts of two surfaces, from coarse to fine. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "warp.h"
#include "warpminimise.h"

/* Standard deviation of the smoothing, as a share of the sides; modes; and nodes at most, in each
 * direction. */
typedef struct Level {
	double smooth;
	int    modes, nodes;
} Level;

static const Level LEVEL[WARP_LEVELS] = {
	{ 8/128.0, 6, 65 }, { 5/128.0, 10, 65 }, { 3/128.0, 16, 65 }, { 1.8/128, WARP_MODES, WARP_NODES }
};

/* The distortion grows faster beyond this share of the largest |mu|; how much faster, and by which factor more
 * while |mu| is still too large. */
static const double MARGIN = 0.95, STIFF = 3, RAISE = 4;
enum { RAISES = 12 };

/* The weights of distortion and of landmarks: normals only, with landmarks, landmarks only. */
static const double ALPHA[2] = { 1, 0.3 }, BETA[2] = { 130, 50 };

/* The coefficients of M modes among those of WARP_MODES, out or in. */
static void
take(const Warp *w, int M, double *x)
{
	int r;

	for (r = 0; r < 2*M; r++)
		memcpy(x + r*M, w->c + ((r >= M)*WARP_MODES + r%M)*WARP_MODES, M*sizeof *x);
}

static void
put(Warp *w, int M, const double *x)
{
	int r;

	memset(w->c, 0, sizeof w->c);
	for (r = 0; r < 2*M; r++)
		memcpy(w->c + ((r >= M)*WARP_MODES + r%M)*WARP_MODES, x + r*M, M*sizeof *x);
}

void
warp_at(const Warp *w, double u, double v, double f[2])
{
	warpmodes_at(WARP_MODES, w->T, w->c, u, v, f);
	f[0] = fmin(fmax(f[0] + u, 0), 1);
	f[1] = fmin(fmax(f[1] + v, 0), w->T);
}

/* B's triples x at the images e->f of the nodes, into y. */
static void
pull(const WarpEnergy *e, const double *x, double *y)
{
	size_t n = (size_t)e->nu*e->nv, p;

	for (p = 0; p < n; p++)
		warpimages_at(e->nu, e->nv, x, e->f[p], e->f[n+p]/e->T, y + 3*p, NULL, NULL);
}

/* The rigid motion of B onto A under the map e->f, on the grid of the surfaces; y: workspace [n][3]. */
static int
estimate(const WarpTask *t, const WarpEnergy *e, double *y, Rigid *r)
{
	double rms;

	pull(e, t->b->phi, y);
	return procrustes(e->nu*e->nv, t->a->area, t->a->phi, y, r, &rms) ? WARP_EVALUE : 0;
}

static void
turn(double R[3][3], const double *x, double *y)
{
	double z[3];
	int c;

	for (c = 0; c < 3; c++)
		z[c] = dot3(R[c], x);
	memcpy(y, z, sizeof z);
}

/* Sets all of fit but the weights. */
static int
judge(const WarpTask *t, const Warp *w, WarpFit *fit)
{
	size_t n = (size_t)t->a->nu*t->a->nv, p;
	double *y = malloc(3*n*sizeof *y), z[2];
	WarpEnergy e;
	int i, bad;

	if (!y || warpenergy_init(&e, t->a->nu, t->a->nv, t->T, WARP_MODES)) {
		free(y);
		return WARP_ENOMEM;
	}
	warpenergy_map(&e, w->c);
	warpdistortion_mu(&e.distortion, e.f, t->stretch, &fit->mu_mean, &fit->mu_max);
	fit->apart = fit->marks = 0;
	if (!(bad = estimate(t, &e, y, &fit->move))) {
		pull(&e, t->b->normal, y);
		for (p = 0; p < n; p++) {
			double *x = y + 3*p, len;

			turn(fit->move.R, x, x);
			len = fmax(norm3(x), 1e-300);
			for (i = 0; i < 3; i++)
				x[i] = x[i]/len - t->a->normal[3*p+i];
			fit->apart += t->a->area[p]*dot3(x, x)/n;
		}
	}
	for (i = 0; i < t->marks.n; i++) {
		warp_at(w, t->marks.p[i][0], t->marks.p[i][1], z);
		fit->marks += hypot(z[0] - t->marks.q[i][0], z[1] - t->marks.q[i][1])/t->marks.n;
	}
	warpenergy_free(&e);
	free(y);
	return bad;
}

/* The smoothed normals of both surfaces on the nu x nv nodes of a level, a then b, turned by R; scaled
 * so that the largest mean square of a component is 1. */
static int
images(const WarpTask *t, double share, double R[3][3], int nu, int nv, double *a, double *b)
{
	int full_u = t->a->nu, full_v = t->a->nv, n = nu*nv, side, i, j, c;
	double *y = malloc(3*(size_t)full_u*full_v*sizeof *y), square[3] = { 0, 0, 0 }, most = 0;

	for (side = 0; y && side < 2; side++) {
		double *to = side ? b : a;

		if (warpimages_smooth(full_u, full_v, share, side ? t->b->normal : t->a->normal, y))
			break;
		for (j = 0; j < nv; j++)
			for (i = 0; i < nu; i++, to += 3) {
				warpimages_at(full_u, full_v, y, i/(nu - 1.0), j/(nv - 1.0), to, NULL, NULL);
				if (side)
					turn(R, to, to);
				for (c = 0; c < 3; c++)
					square[c] += to[c]*to[c]/(2*n);
			}
	}
	free(y);
	if (side < 2)
		return WARP_ENOMEM;
	for (c = 0; c < 3; c++)
		most = fmax(most, square[c]);
	for (i = 0; i < 3*n; i++) {
		a[i] /= sqrt(fmax(most, 1e-18));
		b[i] /= sqrt(fmax(most, 1e-18));
	}
	return 0;
}

static int
minimise(WarpEnergy *e, Warp *w)
{
	double *x = malloc(2*(size_t)e->M*e->M*sizeof *x);
	int bad;

	if (!x)
		return WARP_ENOMEM;
	take(w, e->M, x);
	bad = warpminimise(e, x);
	put(w, e->M, x);
	free(x);
	return bad;
}

/* Improves w at one level, with the weights of fit, B turned by R. */
static int
level(const WarpTask *t, const Level *l, const WarpFit *fit, double R[3][3], Warp *w)
{
	int nu = t->a->nu < l->nodes ? t->a->nu : l->nodes, nv = t->a->nv < l->nodes ? t->a->nv : l->nodes, bad;
	double *a = NULL;
	WarpEnergy e;

	if (warpenergy_init(&e, nu, nv, t->T, l->modes))
		return WARP_ENOMEM;
	e.alpha = fit->alpha;
	e.distortion.stretch = t->stretch;
	e.distortion.limit = warpdistortion_of(MARGIN*t->mumax);
	e.distortion.stiff = fit->stiff;
	e.beta = BETA[t->normals];
	e.marks = t->marks;
	bad = 0;
	if (t->normals) {
		a = malloc(6*(size_t)nu*nv*sizeof *a);
		bad = !a || images(t, l->smooth, R, nu, nv, a, a + 3*(size_t)nu*nv) ? WARP_ENOMEM : 0;
		e.a = a;
		e.b = a + 3*(size_t)nu*nv;
	}
	if (!bad)
		bad = minimise(&e, w);
	free(a);
	warpenergy_free(&e);
	return bad;
}

int
warp_identity(const WarpTask *t, Warp *w, WarpFit *fit)
{
	memset(w, 0, sizeof *w);
	w->T = t->T;
	fit->alpha = ALPHA[t->normals];
	fit->stiff = STIFF;
	return judge(t, w, fit);
}

int
warp_find(const WarpTask *t, int levels, Warp *w, WarpFit *fit)
{
	int k, raise, bad = warp_identity(t, w, fit);

	for (k = 0; !bad && k < levels; k++) {
		bad = level(t, &LEVEL[k], fit, fit->move.R, w);
		if (!bad)
			bad = judge(t, w, fit);
	}
	for (raise = 0; !bad && levels == WARP_LEVELS && !(fit->mu_max < t->mumax); raise++) {
		if (raise == RAISES)
			return WARP_EMU;
		fit->stiff *= RAISE;
		bad = level(t, &LEVEL[levels-1], fit, fit->move.R, w);
		if (!bad)
			bad = judge(t, w, fit);
	}
	return bad;
}

int
warp_field(const Warp *w, int nu, int nv, double stretch, double *f)
{
	size_t n = (size_t)nu*nv, p;
	WarpEnergy e;
	int i, j, bad;

	if (warpenergy_init(&e, nu, nv, w->T, WARP_MODES))
		return WARP_ENOMEM;
	warpenergy_map(&e, w->c);
	bad = !(warpdistortion(&e.distortion, e.f, 1, e.g) < INFINITY);
	for (j = 0, p = 0; j < nv; j++)
		for (i = 0; i < nu; i++, p++) {
			f[p] = i == 0 ? 0 : i == nu - 1 ? 1 : e.f[p];
			f[n+p] = stretch*(j == 0 ? 0 : j == nv - 1 ? w->T : e.f[n+p]);
		}
	warpenergy_free(&e);
	return bad ? WARP_EMU : 0;
}
