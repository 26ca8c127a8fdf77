/* untangle.c - moves vertices so that no triangle is turned over. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "collapse.h"
#include "held.h"
#include "relax.h"
#include "untangle.h"
#include "vertexkey.h"

/* Allocates what relax and collapse need. */
static int
prepare(Tangle *t, const double *u, const double *v)
{
	const Disk *d = t->d;
	size_t nv = d->m.nv, nf = d->m.nf;
	int vertex[4], k;

	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[t->corner[k]];
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
	free(t->sheet);
	free(t->place);
	free(t->key);
	free(t->inside);
	free(t->mover);
	free(t->queue);
	free(t->e);
}

/* Draws each triangle with its corners at the places p, on one sheet. */
static void
set_sheets(Tangle *t, const double *p)
{
	int f, k;

	#pragma omp parallel for private(k) schedule(static)
	for (f = 0; f < t->d->m.nf; f++) {
		const int *c = &t->d->m.tri[3*(size_t)f];
		double u[3], v[3];

		for (k = 0; k < 3; k++) {
			u[k] = p[2*(size_t)c[k]], v[k] = p[2*(size_t)c[k]+1];
			t->sheet[3*(size_t)f+k] = (Sheet){ 1, 0 };
		}
		if (t->kind->folded)
			sheet_polygon(3, u, v, &t->sheet[3*(size_t)f]);
	}
}

/* Turns the bad triangles back. */
static int
set_right(Tangle *t, const double *u, const double *v)
{
	if (prepare(t, u, v) || held_sort(t))
		return UNTANGLE_ENOMEM;
	set_sheets(t, t->place);
	memcpy(t->p, t->place, 2*(size_t)t->d->m.nv*sizeof *t->p);
	relax(t);
	relax_back(t);
	collapse(t);
	return 0;
}

/* The result: p, compared with the given u, v, which it replaces.  Triangles are counted as whoever
 * reads the result will draw them. */
static void
finish(Tangle *t, double *u, double *v, Untangled *r)
{
	double *x, far;
	Sheet s;
	int i;

	r->moved = r->farthest = 0;
	for (i = 0; i < t->d->m.nv; i++) {
		x = &t->p[2*(size_t)i];
		held_wrap(t, x, x + 1);
		s = t->kind->folded ? sheet_nearest(x[0], x[1], u[i], v[i]) : (Sheet){ 1, 0 };
		far = hypot(sheet_u(s, x[0]) - u[i], sheet_v(s, x[1]) - v[i]);
		r->moved += far > 0;
		r->farthest = fmax(r->farthest, far);
		u[i] = x[0], v[i] = x[1];
	}
	set_sheets(t, t->p);
	r->turned = tangle_count(t);
}

int
untangle(const Disk *d, const UntangleChart *on, double *u, double *v, Untangled *r)
{
	size_t nv = d->m.nv, i;
	Tangle t = { .d = d, .kind = on->kind, .T = on->T, .corner = on->corner, .cone = on->cone,
		.side = malloc(nv), .place = malloc(4*nv*sizeof *t.place),
		.sheet = malloc(3*(size_t)d->m.nf*sizeof *t.sheet) };
	int e = t.side && t.place && t.sheet ? 0 : UNTANGLE_ENOMEM;

	if (!e) {
		for (i = 0; i < nv; i++)
			t.place[2*i] = u[i], t.place[2*i+1] = v[i];
		held_put(&t);
		set_sheets(&t, t.place);
		t.p = t.place + 2*nv;
		memcpy(t.p, t.place, 2*nv*sizeof *t.p);
		if (tangle_count(&t) > 0)
			e = set_right(&t, u, v);
	}
	if (!e)
		finish(&t, u, v, r);
	release(&t);
	return e;
}
