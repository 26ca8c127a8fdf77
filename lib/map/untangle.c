/* untangle.c - moves vertices so that no triangle is turned over. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collapse.h"
#include "harmonic.h"
#include "pocket.h"
#include "relax.h"
#include "untangle.h"
#include "vertexkey.h"

static const double APART = 1e-9;       /* distance of vertices of a side that had the same place */

/* Clamps all places to the rectangle, and puts the vertices of each side onto it. */
static void
put_on_sides(const Tangle *t, double T)
{
	int i;

	for (i = 0; i < t->d->m.nv; i++) {
		double *x = &t->place[2*(size_t)i];
		int side = t->side[i];

		x[0] = side & SIDE_LEFT ? 0 : side & SIDE_RIGHT ? 1 : fmin(fmax(x[0], 0), 1);
		x[1] = side & SIDE_BOTTOM ? 0 : side & SIDE_TOP ? T : fmin(fmax(x[1], 0), T);
	}
}

/* Spreads the m places at x evenly over their interval, made a little longer first, but not as far as
 * the neighbouring places x[-1] and x[m]. */
static void
spread(int m, double *x)
{
	double lo = x[0], hi = x[0], more;
	int k;

	for (k = 1; k < m; k++)
		lo = fmin(lo, x[k]), hi = fmax(hi, x[k]);
	more = fmax((hi - lo)/m, APART);
	lo = fmax(lo - more, (x[-1] + lo)/2);
	hi = fmin(hi + more, (x[m] + hi)/2);
	for (k = 0; k < m; k++)
		x[k] = lo + (hi - lo)*(k + 0.5)/m;
}

/* Makes the places x[0..n] along a side ascending; x[0] and x[n] stay.  Runs of places that are not
 * above all earlier and below all later ones are spread evenly.  below: workspace, [n] */
static void
sort_side(int n, double *x, double *below)
{
	double most = x[0];
	int i, first = 1;

	for (below[n-1] = x[n], i = n - 2; i >= 0; i--)
		below[i] = fmin(x[i+1], below[i+1]);            /* the least place behind i */
	for (i = 1; i <= n; i++)
		if (i == n || (x[i] > most && x[i] < below[i])) {
			if (first < i)
				spread(i - first, &x[first]);
			most = x[i];
			first = i + 1;
		} else
			most = fmax(most, x[i]);
}

/* Makes the places along the boundary follow each other in the order of the loop.  Returns 0 or
 * UNTANGLE_ENOMEM. */
static int
sort_boundary(const Tangle *t, const int corner[4])
{
	const Disk *d = t->d;
	double *x = malloc(2*((size_t)d->nb + 1)*sizeof *x);
	int k, i, n;

	if (!x)
		return UNTANGLE_ENOMEM;
	for (k = 0; k < 4; k++) {
		const int back = k >= 2, axis = k%2;

		n = (corner[(k+1)%4] - corner[k] + d->nb)%d->nb;
		for (i = 0; i <= n; i++)
			x[back ? n - i : i] = t->place[2*(size_t)d->loop[(corner[k] + i)%d->nb] + axis];
		sort_side(n, x, x + d->nb + 1);
		for (i = 0; i <= n; i++)
			t->place[2*(size_t)d->loop[(corner[k] + i)%d->nb] + axis] = x[back ? n - i : i];
	}
	free(x);
	return 0;
}

/* Allocates what relax and collapse need. */
static int
prepare(Tangle *t, const int corner[4], const double *u, const double *v)
{
	const Disk *d = t->d;
	size_t nv = d->m.nv, nf = d->m.nf;
	int vertex[4], k;

	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	t->key = vertex_keys(&d->m, vertex);
	t->inside = calloc(2*nv, 1);
	t->mover = malloc(nv*sizeof *t->mover);
	t->queue = malloc((nv + nf)*sizeof *t->queue);
	t->e = calloc(4*nv + 7*nf, sizeof *t->e);
	if (!t->key || !t->inside || !t->mover || !t->queue || !t->e || stars_init(&t->star, &d->m, u, v))
		return UNTANGLE_ENOMEM;
	t->ball = t->inside + nv;
	t->tri = t->queue + nv;
	t->force = t->e + 2*nv;
	t->w = t->force + 2*nv;
	t->area = t->w + 6*nf;
	return 0;
}

static void
release(Tangle *t)
{
	if (t->star.first)
		stars_free(&t->star);
	free(t->side);
	free(t->place);
	free(t->key);
	free(t->inside);
	free(t->mover);
	free(t->queue);
	free(t->e);
}

/* Turns the bad triangles back. */
static int
set_right(Tangle *t, const int corner[4], double T, const double *u, const double *v)
{
	if (prepare(t, corner, u, v) || pocket_sides(t->d, corner, t->side))
		return UNTANGLE_ENOMEM;
	put_on_sides(t, T);
	if (sort_boundary(t, corner))
		return UNTANGLE_ENOMEM;
	memcpy(t->p, t->place, 2*(size_t)t->d->m.nv*sizeof *t->p);
	relax(t);
	relax_back(t);
	collapse(t);
	return 0;
}

/* The result: p, compared with the given u, v, which it replaces. */
static void
finish(const Tangle *t, double *u, double *v, Untangled *r)
{
	int i;

	r->moved = r->farthest = 0;
	for (i = 0; i < t->d->m.nv; i++) {
		const double *p = &t->p[2*(size_t)i], far = hypot(p[0] - u[i], p[1] - v[i]);

		r->moved += far > 0;
		r->farthest = fmax(r->farthest, far);
		u[i] = p[0], v[i] = p[1];
	}
	r->turned = tangle_count(t);
}

int
untangle(const Disk *d, const int corner[4], double T, double *u, double *v, Untangled *r)
{
	size_t nv = d->m.nv, i;
	Tangle t = { .d = d, .side = malloc(nv), .place = malloc(4*nv*sizeof *t.place) };
	int e = t.side && t.place ? 0 : UNTANGLE_ENOMEM;

	if (!e) {
		harmonic_sides(d, corner, t.side);
		for (i = 0; i < nv; i++)
			t.place[2*i] = u[i], t.place[2*i+1] = v[i];
		put_on_sides(&t, T);
		t.p = t.place + 2*nv;
		memcpy(t.p, t.place, 2*nv*sizeof *t.p);
		if (tangle_count(&t) > 0)
			e = set_right(&t, corner, T, u, v);
	}
	if (!e)
		finish(&t, u, v, r);
	release(&t);
	return e;
}
