/* edgepoints.c - points on intrinsic edges, by unfolding. */
#include <stdlib.h>
#include <string.h>

#include "edgepoints.h"
#include "places.h"

static const double ON_SIDE = 1e-9;     /* smaller barycentric coordinates are set to 0 */

static int
add_point(EdgePoints *p, SurfacePoint point)
{
	if (p->n == p->room) {
		int room = 2*p->room + 64;
		SurfacePoint *more = realloc(p->point, room*sizeof *more);

		if (!more)
			return INTRINSIC_ENOMEM;
		p->point = more;
		p->room = room;
	}
	p->point[p->n++] = point;
	return 0;
}

/* A point of an intrinsic edge: one of its ends, or a crossing with a mesh edge. */
typedef struct Stop {
	double at;              /* 0..1 along the edge */
	int    vertex;          /* the end, or -1 at a crossing */
	int    side;            /* a side of the mesh edge that is crossed; -1 at a vertex */
	double place;           /* 0..1 along that side */
} Stop;

/* Stop k of edge e: -1 is its start, 0 .. n-1 are its n crossings, n is its end. */
static Stop
stop(const Intrinsic *t, const Places *p, int e, int k)
{
	int h = t->side[e];
	size_t at = p->first[e] + k;

	if (k < 0)
		return (Stop){ 0, t->from[h], -1, 0 };
	if (k == t->crossings[e])
		return (Stop){ 1, t->from[intrinsic_next(h)], -1, 0 };
	return (Stop){ p->on_edge[at], -1, t->mesh_side[t->crossing[e][k]], p->on_mesh[at] };
}

/* Whether the stop is a corner of triangle f of the mesh, or on a side of it.  If so, w is set to
 * its barycentric coordinates in f. */
static int
has_stop(const Disk *d, int f, const Stop *s, double w[3])
{
	int k, twin = s->side < 0 ? -1 : d->twin[s->side];

	for (k = 0; k < 3; k++)
		w[k] = s->vertex >= 0 && d->m.tri[3*(size_t)f + k] == s->vertex;
	if (s->vertex >= 0)
		return w[0] + w[1] + w[2] == 1;
	if (s->side/3 == f)
		memcpy(w, subdivision_on_side(s->side, s->place).w, 3*sizeof *w);
	else if (twin >= 0 && twin/3 == f)
		memcpy(w, subdivision_on_side(twin, 1 - s->place).w, 3*sizeof *w);
	else
		return 0;
	return 1;
}

/* The point between two neighbouring stops a and b of an edge, at `place` 0..1 from a.  Between
 * them the edge runs within one triangle of the mesh. */
static SurfacePoint
between(const Disk *d, const Stop *a, const Stop *b, double place)
{
	int side = a->side >= 0 ? a->side : b->side, f = side/3, k;
	SurfacePoint p;
	double x[3], y[3], sum = 0;

	if (!has_stop(d, f, a, x) || !has_stop(d, f, b, y)) {
		f = d->twin[side]/3;
		has_stop(d, f, a, x);
		has_stop(d, f, b, y);
	}
	p.triangle = f;
	for (k = 0; k < 3; k++) {
		p.w[k] = (1 - place)*x[k] + place*y[k];
		if (p.w[k] < ON_SIDE)
			p.w[k] = 0;
		sum += p.w[k];
	}
	for (k = 0; k < 3; k++)
		p.w[k] /= sum;
	return p;
}

/* The middle of edge e. */
static SurfacePoint
middle(const Intrinsic *t, const Disk *mesh, const Places *p, int e)
{
	Stop a, b;
	int k = 0;

	if (t->along[e] >= 0)
		return subdivision_on_side(t->mesh_side[t->along[e]], 0.5);
	while (k < t->crossings[e] && p->on_edge[p->first[e] + k] <= 0.5)
		k++;
	a = stop(t, p, e, k - 1);
	b = stop(t, p, e, k);
	return between(mesh, &a, &b, b.at > a.at ? (0.5 - a.at)/(b.at - a.at) : 0.5);
}

int
edgepoints_feet(const Intrinsic *t, EdgePoints *points)
{
	int e, error = 0;

	for (e = 0; !error && e < t->ne; e++) {
		int h = t->side[e];
		double height, place = intrinsic_foot(t, h, &height)/t->length[e];

		if (t->twin[h] >= 0 || t->length[e] <= INTRINSIC_SHORTEST
		    || intrinsic_cotangent(t, h) > -1e-6 || !(place > 0.01 && place < 0.99))
			continue;
		error = add_point(points, subdivision_on_side(t->mesh_side[t->along[e]], place));
	}
	return error;
}

int
edgepoints_middles(const Intrinsic *t, const Disk *mesh, const unsigned char *marked,
	EdgePoints *points)
{
	Places places;
	int e, error;

	if (!memchr(marked, 1, t->ne))
		return 0;
	error = places_init(t, &places);
	if (error)
		return error;
	for (e = 0; !error && e < t->ne; e++)
		if (marked[e] && t->length[e] > INTRINSIC_SHORTEST)
			error = add_point(points, middle(t, mesh, &places, e));
	places_free(&places);
	return error;
}
