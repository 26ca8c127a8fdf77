/* overlay.c - every intrinsic triangle cut along the mesh edges that cross it. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/topology.h"
#include "crossings.h"
#include "overlay.h"
#include "places.h"

enum { CORNERS = 6 };   /* of a polygon, at most: two on each side of its triangle */

typedef struct Overlaid {
	const Intrinsic *t;
	const Places    *places;
	int             *tri, nf;
} Overlaid;

/* The vertex at crossing p of side h, counted from the start of the side. */
static int
vertex_at(const Overlaid *o, int h, int p)
{
	int e = o->t->edge[h], n = o->t->crossings[e];

	return o->t->nv + (int)o->places->first[e] + (o->t->side[e] == h ? p : n - 1 - p);
}

static int
crossings_of(const Overlaid *o, int h)
{
	return o->t->crossings[o->t->edge[h]];
}

/* Adds a convex polygon of n corners as a fan of triangles round corner[0]. */
static void
add_polygon(Overlaid *o, int n, const int *corner)
{
	int k;

	for (k = 1; k + 1 < n; k++) {
		int *c = &o->tri[3*(size_t)o->nf++];

		c[0] = corner[0];
		c[1] = corner[k];
		c[2] = corner[k+1];
	}
}

/* Mesh edges cut off the corner of a triangle at which side h starts.  Adds the parts between these
 * pieces: a triangle at the corner, then a quadrilateral between each two neighbouring pieces. */
static void
add_round_corner(Overlaid *o, int h, int pieces)
{
	int last = intrinsic_last(h), n = crossings_of(o, last), p;

	for (p = 0; p < pieces; p++) {
		int out = vertex_at(o, h, p), in = vertex_at(o, last, n - 1 - p);

		if (p == 0)
			add_polygon(o, 3, (int[]){ o->t->from[h], out, in });
		else
			add_polygon(o, 4, (int[]){ vertex_at(o, h, p - 1), out, in, vertex_at(o, last, n - p) });
	}
}

/* When the corners of a triangle are cut off, its middle polygon remains.  Finds the corners of that
 * polygon near the start of side h: the vertex there or, if pieces cut it off, the two ends of the
 * piece farthest from the vertex, counterclockwise.  Returns the number of these corners. */
static int
remaining_corner(const Overlaid *o, int h, int pieces, int corner[2])
{
	int last = intrinsic_last(h);

	if (pieces == 0) {
		corner[0] = o->t->from[h];
		return 1;
	}
	corner[0] = vertex_at(o, last, crossings_of(o, last) - pieces);
	corner[1] = vertex_at(o, h, pieces - 1);
	return 2;
}

/* Adds the rest of a triangle in which no mesh edge starts at a corner. */
static void
add_middle(Overlaid *o, int f, const Pieces *pieces)
{
	int corner[CORNERS], n = 0, k;

	for (k = 0; k < 3; k++)
		n += remaining_corner(o, 3*f + k, pieces->round[k], &corner[n]);
	add_polygon(o, n, corner);
}

/* Adds the rest of a triangle in which mesh edges go from the start of side h to the opposite
 * side. */
static void
add_fan(Overlaid *o, int h, const Pieces *pieces)
{
	int next = intrinsic_next(h), last = intrinsic_last(h), k = h%3;
	int from = o->t->from[h], first = pieces->round[(k+1)%3], n, p, corner[CORNERS];

	corner[0] = from;
	n = 1 + remaining_corner(o, next, first, &corner[1]);
	corner[n++] = vertex_at(o, next, first);
	add_polygon(o, n, corner);
	for (p = first; p + 1 < first + pieces->start[k]; p++)
		add_polygon(o, 3, (int[]){ from, vertex_at(o, next, p), vertex_at(o, next, p + 1) });
	corner[1] = vertex_at(o, next, p);
	n = 2 + remaining_corner(o, last, pieces->round[(k+2)%3], &corner[2]);
	add_polygon(o, n, corner);
}

static void
cut_triangle(Overlaid *o, int f)
{
	Pieces pieces = crossings_pieces(o->t, f);
	int k;

	for (k = 0; k < 3; k++)
		add_round_corner(o, 3*f + k, pieces.round[k]);
	for (k = 0; k < 3 && pieces.start[k] == 0; k++)
		;
	if (k == 3)
		add_middle(o, f, &pieces);
	else
		add_fan(o, 3*f + k, &pieces);
}

static int
resize(double **x, size_t n)
{
	double *more = realloc(*x, n*sizeof *more);

	if (!more)
		return INTRINSIC_ENOMEM;
	*x = more;
	return 0;
}

/* Continues x, u or v, to the crossings, linearly along the edges of the triangulation.  Crossings lie
 * inside the disk, so x lies in the open interval from 0 to its maximum.  If rounding puts it at an
 * end, it is replaced by the nearest number inside: only a corner of the disk may be mapped exactly
 * to a corner of the rectangle (locate.h). */
static void
extend_map(const Overlaid *o, double *x)
{
	const Intrinsic *t = o->t;
	double most = 0;
	size_t k;
	int e, i;

	for (i = 0; i < t->nv; i++)
		most = fmax(most, x[i]);
	most *= 1 - DBL_EPSILON;
	for (e = 0; e < t->ne; e++) {
		double a = x[t->from[t->side[e]]], b = x[t->from[intrinsic_next(t->side[e])]];

		for (k = o->places->first[e]; k < o->places->first[e+1]; k++)
			x[t->nv + k] = fmin(fmax(a + (b - a)*o->places->on_edge[k], DBL_MIN), most);
	}
}

/* Adds the crossings to s as vertices.  The triangles of s are not changed yet. */
static int
add_crossings(const Overlaid *o, Subdivision *s)
{
	const Intrinsic *t = o->t;
	size_t n = o->places->first[t->ne], k, i;
	int *mesh_to = malloc(t->ne*sizeof *mesh_to), e;
	size_t added = t->nv - s->given + n;
	void *corner = realloc(s->corner, (added + 1)*sizeof *s->corner);
	void *w = realloc(s->w, (added + 1)*sizeof *s->w);

	s->corner = corner ? corner : s->corner;
	s->w = w ? w : s->w;
	if (!mesh_to || !corner || !w || resize(&s->d.m.xyz, 3*(t->nv + n))) {
		free(mesh_to);
		return INTRINSIC_ENOMEM;
	}
	for (e = 0; e < t->ne; e++)
		mesh_to[e] = s->d.m.tri[topology_next(t->mesh_side[e])];
	for (e = 0; e < t->ne; e++)
		for (k = o->places->first[e], i = 0; k < o->places->first[e+1]; k++, i++) {
			int *c = s->corner[t->nv - s->given + k], id = t->crossing[e][i];
			double *b = s->w[t->nv - s->given + k];

			c[0] = c[2] = t->mesh_from[id];
			c[1] = mesh_to[id];
			b[0] = 1 - o->places->on_mesh[k];
			b[1] = o->places->on_mesh[k];
			b[2] = 0;
		}
	s->d.m.nv = t->nv + n;
	subdivision_extend(s, 3, s->d.m.xyz, s->d.m.xyz);
	free(mesh_to);
	return 0;
}

/* Fills twin: pairs sides that run between the same two vertices in opposite directions.  Two edges
 * may have the same two ends if they were too short to be split.  More than two sides then match, and
 * any two of opposite direction are paired.  first, at: workspace, [nv+2] and [3*nf]. */
static void
match_sides(int nv, int nf, const int *tri, int *first, int *at, int *twin)
{
	int s, k, i;

	memset(first, 0, (nv + (size_t)2)*sizeof *first);
	for (s = 0; s < 3*nf; s++)
		first[tri[s]+2]++;
	for (i = 0; i < nv; i++)
		first[i+2] += first[i+1];
	for (s = 0; s < 3*nf; s++) {
		twin[s] = -1;
		at[first[tri[s]+1]++] = s;
	}
	for (s = 0; s < 3*nf; s++) {
		int from = tri[s], to = tri[topology_next(s)];

		if (first[to+1] - first[to] > first[from+1] - first[from])
			continue;       /* found from the other side, by a shorter search */
		for (k = first[to]; k < first[to+1] && twin[s] < 0; k++)
			if (tri[topology_next(at[k])] == from && twin[at[k]] < 0 && at[k] != s) {
				twin[s] = at[k];
				twin[at[k]] = s;
			}
	}
}

/* Replaces the triangles and twins of s by those of the common subdivision. */
static int
replace_triangles(Overlaid *o, Subdivision *s)
{
	size_t most = o->t->nf + 2*o->places->first[o->t->ne];
	int f, *twin = malloc(3*most*sizeof *twin), *at = malloc(3*most*sizeof *at);
	int *first = malloc((s->d.m.nv + (size_t)2)*sizeof *first);

	o->tri = malloc(3*most*sizeof *o->tri);
	if (!o->tri || !twin || !at || !first) {
		free(o->tri);
		free(twin);
		free(at);
		free(first);
		return INTRINSIC_ENOMEM;
	}
	for (f = 0; f < o->t->nf; f++)
		cut_triangle(o, f);
	match_sides(s->d.m.nv, o->nf, o->tri, first, at, twin);
	free(at);
	free(first);
	free(s->d.m.tri);
	free(s->d.twin);
	s->d.m.tri = o->tri;
	s->d.m.nf = o->nf;
	s->d.twin = twin;
	return 0;
}

int
overlay(const Intrinsic *t, Subdivision *s, double **u, double **v)
{
	Places places;
	Overlaid o = { t, &places, NULL, 0 };
	int e = places_init(t, &places);

	if (e)
		return e;
	e = resize(u, t->nv + places.first[t->ne]) || resize(v, t->nv + places.first[t->ne])
	    || add_crossings(&o, s)
	    || replace_triangles(&o, s);
	if (!e) {
		extend_map(&o, *u);
		extend_map(&o, *v);
	}
	places_free(&places);
	return e ? INTRINSIC_ENOMEM : 0;
}
