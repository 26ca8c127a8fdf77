/* sample.c - scan conversion in the parameter plane. */
#include <math.h>
#include <stdlib.h>

#include "sample.h"

/* A node belongs to a triangle from this depth on: rounding must leave no gap between
 * neighbours. */
static const double DEPTH = -1e-9;

/* The triangle found for each node so far, and how deep the node lies in it: its least
 * barycentric coordinate. */
typedef struct Cover {
	int    *tri;
	double *depth;
} Cover;

/* Barycentric coordinates of (x,y) in the triangle a, b, c; 0 when it has no area. */
static int
barycentric(const double *u, const double *v, const int *tri, double x, double y, double w[3])
{
	int a = tri[0], b = tri[1], c = tri[2];
	double area = (u[b] - u[a])*(v[c] - v[a]) - (u[c] - u[a])*(v[b] - v[a]);

	if (area == 0)
		return 0;
	w[1] = ((x - u[a])*(v[c] - v[a]) - (u[c] - u[a])*(y - v[a]))/area;
	w[2] = ((u[b] - u[a])*(y - v[a]) - (x - u[a])*(v[b] - v[a]))/area;
	w[0] = 1 - w[1] - w[2];
	return isfinite(w[0]);
}

static double
least(const double w[3])
{
	return fmin(w[0], fmin(w[1], w[2]));
}

/* Where the line v = y crosses the triangle: [lo,hi] in u. */
static void
crossing(const double *u, const double *v, const int *tri, double y, double *lo, double *hi)
{
	int k;

	*lo = HUGE_VAL;
	*hi = -HUGE_VAL;
	for (k = 0; k < 3; k++) {
		int a = tri[k], b = tri[(k+1)%3];
		double low = fmin(v[a], v[b]), high = fmax(v[a], v[b]), t, x;

		if (y < low || y > high)
			continue;
		t = high > low ? (y - v[a])/(v[b] - v[a]) : 0;
		x = u[a] + t*(u[b] - u[a]);
		*lo = fmin(*lo, x);
		*hi = fmax(*hi, x);
		if (high == low) {
			*lo = fmin(*lo, u[b]);
			*hi = fmax(*hi, u[b]);
		}
	}
}

static int
clampi(double x, int lo, int hi)
{
	return x < lo ? lo : x > hi ? hi : (int)x;
}

/* Offer triangle t to the inner nodes it covers. */
static void
scan(const Mesh *m, int t, const double *u, const double *v, Chart g, Cover *cover)
{
	const int *tri = &m->tri[3*t];
	double h = chart_h(g), k = chart_k(g), w[3], lo, hi;
	double low = fmin(v[tri[0]], fmin(v[tri[1]], v[tri[2]]));
	double high = fmax(v[tri[0]], fmax(v[tri[1]], v[tri[2]]));
	int j, j1 = clampi(floor(high/k + 1e-9), 1, g.nv - 2), i, i1, p;

	for (j = clampi(ceil(low/k - 1e-9), 1, g.nv - 1); j <= j1; j++) {
		crossing(u, v, tri, fmin(fmax(j*k, low), high), &lo, &hi);
		i1 = clampi(floor(hi/h + 1e-9), 0, g.nu - 2);
		for (i = clampi(ceil(lo/h - 1e-9), 1, g.nu - 1); i <= i1; i++) {
			p = j*g.nu + i;
			if (!barycentric(u, v, tri, i*h, j*k, w) || !(least(w) > cover->depth[p]))
				continue;
			cover->depth[p] = least(w);
			cover->tri[p] = t;
		}
	}
}

static void
inner(const Mesh *m, const double *u, const double *v, Chart g, const Cover *cover, double *const phi[3])
{
	double h = chart_h(g), k = chart_k(g), w[3];
	int i, j, p, c;

	for (j = 1; j < g.nv - 1; j++)
		for (i = 1; i < g.nu - 1; i++) {
			const int *tri = &m->tri[3*cover->tri[p = j*g.nu + i]];

			barycentric(u, v, tri, i*h, j*k, w);
			for (c = 0; c < 3; c++)
				phi[c][p] = w[0]*m->xyz[3*tri[0] + c] + w[1]*m->xyz[3*tri[1] + c]
				    + w[2]*m->xyz[3*tri[2] + c];
		}
}

/* One side of the rectangle: the loop from place a to place b, along which the parameter
 * s runs from s0 to s1. */
typedef struct Side {
	int           a, b;
	const double *s;
	double        s0, s1;
} Side;

/* The parameter at place i as a share of the side, not below `reached`: where it turns
 * back (a ragged edge may do that) the side is still walked once. */
static double
share(const Disk *d, const Side *e, int i, double reached)
{
	double t = (e->s[d->loop[i]] - e->s0)/(e->s1 - e->s0);

	return i == e->b ? 1 : fmin(1, fmax(reached, t));
}

static void
between(const Disk *d, int i, int j, double w, double *const phi[3], int p)
{
	int c;

	for (c = 0; c < 3; c++)
		phi[c][p] = (1 - w)*d->m.xyz[3*d->loop[i] + c] + w*d->m.xyz[3*d->loop[j] + c];
}

/* The n nodes p = first + l*stride of one side; its ends are the corners themselves. */
static void
along_side(const Disk *d, const Side *e, int n, int first, int stride, double *const phi[3])
{
	int l, i = e->a, next = (i + 1)%d->nb;
	double t, t0 = 0, t1 = share(d, e, next, 0);

	for (l = 1; l < n - 1; l++) {
		t = l/(n - 1.0);
		while (t > t1) {
			t0 = t1;
			i = next;
			next = (next + 1)%d->nb;
			t1 = share(d, e, next, t0);
		}
		between(d, i, next, (t - t0)/(t1 - t0), phi, first + l*stride);
	}
	between(d, e->a, e->a, 0, phi, first);
	between(d, e->b, e->b, 0, phi, first + (n - 1)*stride);
}

static int
cover_all(const Mesh *m, const double *u, const double *v, Chart g, Cover *cover)
{
	int n = g.nu*g.nv, p, t;

	for (p = 0; p < n; p++) {
		cover->tri[p] = -1;
		cover->depth[p] = DEPTH;
	}
	for (t = 0; t < m->nf; t++)
		scan(m, t, u, v, g, cover);
	for (p = 0; p < n; p++)
		if (cover->tri[p] < 0 && p%g.nu > 0 && p%g.nu < g.nu - 1 && p/g.nu > 0 && p/g.nu < g.nv - 1)
			return p;
	return -1;
}

int
sample_disk(const Disk *d, const int corner[4], const double *u, const double *v,
	Chart g, double *const phi[3], int *at)
{
	Cover cover = { malloc((size_t)g.nu*g.nv*sizeof(int)), malloc((size_t)g.nu*g.nv*sizeof(double)) };
	int e = SAMPLE_ENOMEM;

	if (cover.tri && cover.depth) {
		*at = cover_all(&d->m, u, v, g, &cover);
		e = *at >= 0 ? SAMPLE_EHOLE : 0;
	}
	if (!e) {
		Side bottom = { corner[0], corner[1], u, 0, 1 }, right = { corner[1], corner[2], v, 0, g.T };
		Side top = { corner[2], corner[3], u, 1, 0 }, left = { corner[3], corner[0], v, g.T, 0 };

		inner(&d->m, u, v, g, &cover, phi);
		along_side(d, &bottom, g.nu, 0, 1, phi);
		along_side(d, &right, g.nv, g.nu - 1, g.nu, phi);
		along_side(d, &top, g.nu, g.nu*g.nv - 1, -1, phi);
		along_side(d, &left, g.nv, (g.nv - 1)*g.nu, -g.nu, phi);
	}
	free(cover.tri);
	free(cover.depth);
	return e;
}
