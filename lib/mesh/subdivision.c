/* subdivision.c - splits triangles at points within them and on their sides, point by point. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "refine.h"
#include "sortpoints.h"
#include "splitting.h"
#include "subdivision.h"
#include "topology.h"

static const double SAME = 1e-9;        /* a point this share of a triangle away from a side lies on it */

static void *
duplicate(const void *p, size_t n, size_t size)
{
	void *q = malloc(n*size + 1);

	return q && n > 0 ? memcpy(q, p, n*size) : q;
}

int
subdivision_init(Subdivision *s, const Disk *d)
{
	size_t nv = d->m.nv, sides = 3*(size_t)d->m.nf;

	*s = (Subdivision){ .d = { .m = { .nv = d->m.nv, .nf = d->m.nf }, .nb = d->nb }, .given = d->m.nv };
	s->d.m.xyz = duplicate(d->m.xyz, 3*nv, sizeof *d->m.xyz);
	s->d.m.tri = duplicate(d->m.tri, sides, sizeof *d->m.tri);
	s->d.twin = duplicate(d->twin, sides, sizeof *d->twin);
	s->d.loop = duplicate(d->loop, d->nb, sizeof *d->loop);
	s->inner = calloc(sides, 1);
	if (s->d.m.xyz && s->d.m.tri && s->d.twin && s->d.loop && s->inner)
		return 0;
	subdivision_free(s);
	return MESH_ENOMEM;
}

void
subdivision_free(Subdivision *s)
{
	disk_free(&s->d);
	free(s->corner);
	free(s->w);
	free(s->inner);
	s->corner = NULL;
	s->w = NULL;
	s->inner = NULL;
}

void
subdivision_extend(const Subdivision *s, int n, const double *f, double *all)
{
	int i, k;

	memmove(all, f, (size_t)s->given*n*sizeof *f);
	for (i = s->given; i < s->d.m.nv; i++) {
		const int *c = s->corner[i - s->given];
		const double *w = s->w[i - s->given];
		const double *a = &all[(size_t)n*c[0]], *b = &all[(size_t)n*c[1]], *e = &all[(size_t)n*c[2]];

		for (k = 0; k < n; k++)
			all[(size_t)n*i + k] = a[k] + w[1]*(b[k] - a[k]) + w[2]*(e[k] - a[k]);
	}
}

SurfacePoint
subdivision_on_side(int side, double place)
{
	SurfacePoint p = { side/3, { 0, 0, 0 } };

	p.w[side%3] = 1 - place;
	p.w[(side + 1)%3] = place;
	return p;
}

static int
grow(void *array, size_t n, size_t size)
{
	void **a = array, *b = realloc(*a, n*size + 1);

	if (!b)
		return MESH_ENOMEM;
	*a = b;
	return 0;
}

/* Makes room for n more vertices. */
static int
make_room(Subdivision *s, int n)
{
	size_t nv = s->d.m.nv + (size_t)n, sides = 3*(s->d.m.nf + 2*(size_t)n), added = nv - s->given;

	return grow(&s->d.m.xyz, 3*nv, sizeof(double)) || grow(&s->d.m.tri, sides, sizeof(int))
	    || grow(&s->d.twin, sides, sizeof(int)) || (s->inner && grow(&s->inner, sides, 1))
	    || grow(&s->d.loop, s->d.nb + (size_t)n, sizeof(int))
	    || grow(&s->corner, added, sizeof *s->corner) || grow(&s->w, added, sizeof *s->w)
	    ? MESH_ENOMEM : 0;
}

/* Adds a vertex at barycentric coordinates w of the triangle c.  Returns its number. */
static int
add_vertex(Subdivision *s, const int c[3], const double w[3])
{
	Mesh *m = &s->d.m;
	int k, v = m->nv++;

	memcpy(s->corner[v - s->given], c, sizeof s->corner[0]);
	memcpy(s->w[v - s->given], w, sizeof s->w[0]);
	for (k = 0; k < 3; k++) {
		const double *x = m->xyz + k;
		double a = x[3*(size_t)c[0]], b = x[3*(size_t)c[1]], e = x[3*(size_t)c[2]];

		m->xyz[3*(size_t)v + k] = a + w[1]*(b - a) + w[2]*(e - a);
	}
	return v;
}

/* Twice the area of the triangle a b c.  The three points are given by barycentric coordinates in
 * one triangle, whose area counts as 1/2. */
static double
area(const double a[3], const double b[3], const double c[3])
{
	return (b[1] - a[1])*(c[2] - a[2]) - (c[1] - a[1])*(b[2] - a[2]);
}

/* The barycentric coordinates w, in triangle c, of vertex v: a corner of c, or added within it. */
static void
coordinates(const Subdivision *s, const int c[3], int v, double w[3])
{
	int k;

	for (k = 0; k < 3; k++)
		w[k] = v == c[k];
	if (v != c[0] && v != c[1] && v != c[2])
		memcpy(w, s->w[v - s->given], sizeof s->w[0]);
}

/* The areas that the point w makes with the sides of t, a part of triangle c: a[k] with side k.  They
 * are positive if the point is inside t.  Returns the number of the smallest. */
static int
areas(const Subdivision *s, const int c[3], int t, const double w[3], double a[3])
{
	double x[3][3];
	int k;

	for (k = 0; k < 3; k++)
		coordinates(s, c, s->d.m.tri[3*(size_t)t + k], x[k]);
	for (k = 0; k < 3; k++)
		a[k] = area(x[k], x[(k+1)%3], w);
	k = a[1] < a[0];
	return a[2] < a[k] ? 2 : k;
}

/* Adds the point w of triangle c to its part t.  If the point lies on a side between two parts, up to rounding, both are
 * split at that side; if it lies at a vertex, it is not added.  The parts are triangle f and the triangles from number
 * `first` on. */
static void
add_to_part(Subdivision *s, const Splitting *p, const int c[3], int f, int first, int t, const double w[3])
{
	double a[3], small;
	int least = areas(s, c, t, w, a), side = 3*t + least, twin = s->d.twin[side];

	small = SAME*(a[0] + a[1] + a[2]);
	if (a[least] <= small && (a[(least+1)%3] <= small || a[(least+2)%3] <= small))
		return;
	if (a[least] <= small && twin >= 0 && (twin/3 == f || twin/3 >= first))
		splitting_edge(p, twin < side ? twin : side, add_vertex(s, c, w));
	else if (a[least] > 0)
		splitting_face(p, t, add_vertex(s, c, w));
}

/* Adds n points within one triangle, each to the part in which it lies deepest.  The parts are the
 * triangle itself and the new triangles, from number `first` on. */
static void
add_within(Subdivision *s, const Splitting *p, int n, const SurfacePoint *point)
{
	int c[3], f = point->triangle, first = s->d.m.nf, i, t, in;

	memcpy(c, &s->d.m.tri[3*(size_t)f], sizeof c);
	for (i = 0; i < n; i++) {
		const double *w = point[i].w;
		double a[3], deepest = a[areas(s, c, f, w, a)];

		for (in = f, t = first; t < s->d.m.nf; t++) {
			int least = areas(s, c, t, w, a);

			if (a[least] > deepest) {
				deepest = a[least];
				in = t;
			}
		}
		add_to_part(s, p, c, f, first, in, w);
	}
}

/* Whether point i is the first one on its edge. */
static int
begins_edge(const EdgePoint *point, int i)
{
	return i == 0 || point[i].side != point[i-1].side;
}

static void
mark_edges(Splitting *p, int n, const EdgePoint *point)
{
	int i;

	for (i = 0; i < n; i++)
		if (begins_edge(point, i)) {
			p->side[i] = point[i].side;
			p->line[point[i].side] = i;
		}
}

static void
split_edges(Subdivision *s, Splitting *p, int n, const EdgePoint *point)
{
	int i, h, end[3] = { 0, 0, 0 };

	for (i = 0; i < n; i++) {
		h = p->side[i];
		if (begins_edge(point, i)) {
			end[0] = end[2] = s->d.m.tri[h];
			end[1] = s->d.m.tri[topology_next(h)];
		}
		p->line[h] = -1;
		h = splitting_edge(p, h, add_vertex(s, end, (double[]){ 1 - point[i].place, point[i].place, 0 }));
		if (i + 1 < n && !begins_edge(point, i + 1)) {
			p->side[i+1] = h;
			p->line[h] = i + 1;
		}
	}
}

static void
split_faces(Subdivision *s, const Splitting *p, int n, const SurfacePoint *point)
{
	int i, k;

	for (i = 0; i < n; i = k) {
		for (k = i + 1; k < n && point[k].triangle == point[i].triangle; k++)
			;
		add_within(s, p, k - i, &point[i]);
	}
}

static int
add_sorted(Subdivision *s, const Sorted *points)
{
	size_t n = (size_t)points->nwithin + points->non;
	int i, e = MESH_ENOMEM, before = s->d.m.nv;
	Splitting p = { &s->d, NULL, NULL, NULL, NULL };

	if (make_room(s, n))
		return MESH_ENOMEM;
	p.inner = s->inner;
	p.line = malloc(3*(s->d.m.nf + 2*n)*sizeof *p.line);
	p.side = malloc(points->non*sizeof *p.side + 1);
	p.after = malloc((s->d.m.nv + n)*sizeof *p.after);
	if (p.line && p.side && p.after) {
		memset(p.line, -1, 3*(size_t)s->d.m.nf*sizeof *p.line);
		for (i = 0; i < s->d.nb; i++)
			p.after[s->d.loop[i]] = s->d.loop[(i+1)%s->d.nb];
		mark_edges(&p, points->non, points->on);
		split_faces(s, &p, points->nwithin, points->within);
		split_edges(s, &p, points->non, points->on);
		splitting_write_loop(&p);
		e = s->d.m.nv - before;
	}
	free(p.line);
	free(p.side);
	free(p.after);
	return e;
}

int
subdivision_add(Subdivision *s, int n, const SurfacePoint *point)
{
	Sorted sorted;
	int e = sort_points(&s->d, n, point, &sorted);

	if (!e)
		e = add_sorted(s, &sorted);
	free(sorted.within);
	free(sorted.on);
	return e;
}

int
subdivision_refine(Subdivision *s, const unsigned char *marked, const double *key, Disk *before)
{
	Disk finer;
	int (*ends)[2], i, old = s->d.m.nv;

	if (refine_split(&s->d, marked, key, &finer, &ends))
		return MESH_ENOMEM;
	if (grow(&s->corner, finer.m.nv - (size_t)s->given, sizeof *s->corner)
	    || grow(&s->w, finer.m.nv - (size_t)s->given, sizeof *s->w)) {
		disk_free(&finer);
		free(ends);
		return MESH_ENOMEM;
	}
	for (i = old; i < finer.m.nv; i++) {
		int *c = s->corner[i - s->given];

		c[0] = c[2] = ends[i - old][0];
		c[1] = ends[i - old][1];
		memcpy(s->w[i - s->given], (double[]){ 0.5, 0.5, 0 }, sizeof s->w[0]);
	}
	free(ends);
	if (before)
		*before = s->d;
	else
		disk_free(&s->d);
	s->d = finer;
	free(s->inner);
	s->inner = NULL;
	return 0;
}
