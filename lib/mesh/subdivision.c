/* subdivision.c - triangles split at points within them and on their sides, one after the other. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "refine.h"
#include "subdivision.h"
#include "topology.h"

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

/* A point on an edge: `place` 0..1 from the start of the side. */
typedef struct EdgePoint {
	int    side;
	double place;
} EdgePoint;

/* The splitting of a disk.  A piece of an edge that still has points is known by a side of it. */
typedef struct Splitting {
	Disk *d;
	unsigned char *inner;   /* of the subdivision */
	int  *line;             /* [3*nf] a point's number on each side that a splitting may move, or -1 */
	int  *side;             /* [points] where the rest of the point's edge is now */
	int  *after;            /* [nv] the next vertex of the boundary, or -1 */
} Splitting;

/* Moves what is known of one side to another. */
static void
move_side(const Splitting *s, int from, int to)
{
	Disk *d = s->d;

	d->twin[to] = d->twin[from];
	if (d->twin[to] >= 0)
		d->twin[d->twin[to]] = to;
	if (s->inner)
		s->inner[to] = s->inner[from];
	s->line[to] = s->line[from];
	s->line[from] = -1;
	if (s->line[to] >= 0)
		s->side[s->line[to]] = to;
}

/* Splits the triangle of side h at vertex m on that side into (a,m,c), which keeps its number, and
 * (m,b,c), which becomes triangle f. */
static void
split_triangle(const Splitting *s, int h, int m, int f)
{
	Disk *d = s->d;
	int next = topology_next(h), last = topology_next(next), *t = &d->m.tri[3*(size_t)f];

	t[0] = m;
	t[1] = d->m.tri[next];
	t[2] = d->m.tri[last];
	d->m.tri[next] = m;
	s->line[3*f] = s->line[3*f+2] = -1;
	move_side(s, next, 3*f + 1);
	if (s->inner) {
		s->inner[3*f] = s->inner[h];
		s->inner[next] = s->inner[3*f+2] = 1;
	}
	d->twin[next] = 3*f + 2;
	d->twin[3*f+2] = next;
}

/* Splits the edge of side h at vertex m.  Returns the side of its second half. */
static int
split_edge(const Splitting *s, int h, int m)
{
	Disk *d = s->d;
	int g = d->twin[h], f = d->m.nf++, a = d->m.tri[h];

	split_triangle(s, h, m, f);
	if (g < 0) {
		d->twin[3*f] = -1;
		s->after[m] = s->after[a];
		s->after[a] = m;
		d->nb++;
		return 3*f;
	}
	split_triangle(s, g, m, d->m.nf++);
	d->twin[3*f] = g;
	d->twin[g] = 3*f;
	d->twin[h] = 3*(f + 1);
	d->twin[3*(f+1)] = h;
	return 3*f;
}

/* The point as seen from the side of lower number. */
static EdgePoint
seen_from_lower(const Disk *d, EdgePoint p)
{
	int twin = d->twin[p.side];

	return twin < 0 || p.side < twin ? p : (EdgePoint){ twin, 1 - p.place };
}

static int
along_edges(const void *a, const void *b)
{
	const EdgePoint *p = a, *q = b;

	if (p->side != q->side)
		return p->side < q->side ? -1 : 1;
	return p->place < q->place ? -1 : p->place > q->place;
}

/* Sorts the points and drops those that are not apart.  Returns the number of those left. */
static int
sort_edge_points(const Disk *d, int n, EdgePoint *point)
{
	int i, k = 0;

	for (i = 0; i < n; i++)
		point[i] = seen_from_lower(d, point[i]);
	qsort(point, n, sizeof *point, along_edges);
	for (i = 0; i < n; i++) {
		if (!(point[i].place > 0 && point[i].place < 1))
			continue;
		if (k > 0 && point[k-1].side == point[i].side && point[i].place - point[k-1].place < 1e-9)
			continue;
		point[k++] = point[i];
	}
	return k;
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

/* Room for n more vertices. */
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

/* Splits triangle f at vertex m within it into (a,b,m), which keeps its number, (b,c,m) and (c,a,m). */
static void
split_face(const Splitting *s, int f, int m)
{
	Disk *d = s->d;
	int g[3] = { f, d->m.nf, d->m.nf + 1 }, c[3], k;

	memcpy(c, &d->m.tri[3*(size_t)f], sizeof c);
	d->m.nf += 2;
	move_side(s, 3*f + 1, 3*g[1]);
	move_side(s, 3*f + 2, 3*g[2]);
	for (k = 0; k < 3; k++) {
		int side = 3*g[k], *t = &d->m.tri[side];

		t[0] = c[k];
		t[1] = c[(k+1)%3];
		t[2] = m;
		d->twin[side+1] = 3*g[(k+1)%3] + 2;
		d->twin[side+2] = 3*g[(k+2)%3] + 1;
		s->line[side+1] = s->line[side+2] = -1;
		if (s->inner)
			s->inner[side+1] = s->inner[side+2] = 1;
	}
}

/* Twice the area of the triangle of three points, each with barycentric coordinates in the same
 * triangle, of which the area is 1/2. */
static double
area(const double a[3], const double b[3], const double c[3])
{
	return (b[1] - a[1])*(c[2] - a[2]) - (c[1] - a[1])*(b[2] - a[2]);
}

/* The barycentric coordinates of vertex v of a part of triangle c. */
static void
coordinates(const Subdivision *s, const int c[3], int v, double w[3])
{
	int k;

	for (k = 0; k < 3; k++)
		w[k] = v == c[k];
	if (v != c[0] && v != c[1] && v != c[2])
		memcpy(w, s->w[v - s->given], sizeof s->w[0]);
}

/* The least of the areas of the triangles that w makes with two corners of part t of triangle c: above 0 inside. */
static double
depth(const Subdivision *s, const int c[3], int t, const double w[3])
{
	double x[3][3];
	int k;

	for (k = 0; k < 3; k++)
		coordinates(s, c, s->d.m.tri[3*(size_t)t + k], x[k]);
	return fmin(area(x[0], x[1], w), fmin(area(x[1], x[2], w), area(x[2], x[0], w)));
}

/* Adds n points within one triangle.  Its parts are itself and the triangles from number `first` on. */
static void
add_within(Subdivision *s, const Splitting *p, int n, const SurfacePoint *point)
{
	int c[3], f = point->triangle, first = s->d.m.nf, i, t, in;

	memcpy(c, &s->d.m.tri[3*(size_t)f], sizeof c);
	for (i = 0; i < n; i++) {
		double deepest = depth(s, c, f, point[i].w), here;

		for (in = f, t = first; t < s->d.m.nf; t++) {
			here = depth(s, c, t, point[i].w);
			if (here > deepest) {
				deepest = here;
				in = t;
			}
		}
		if (deepest > 0)
			split_face(p, in, add_vertex(s, c, point[i].w));
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
		h = split_edge(p, h, add_vertex(s, end, (double[]){ 1 - point[i].place, point[i].place, 0 }));
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

/* Points within triangles and points on edges. */
typedef struct Sorted {
	SurfacePoint *within;
	EdgePoint    *on;
	int           nwithin, non;
} Sorted;

static int
by_triangle(const void *a, const void *b)
{
	const SurfacePoint *p = a, *q = b;
	int k;

	if (p->triangle != q->triangle)
		return p->triangle < q->triangle ? -1 : 1;
	for (k = 0; k < 3; k++)
		if (p->w[k] != q->w[k])
			return p->w[k] < q->w[k] ? -1 : 1;
	return 0;
}

static int
sort_points(const Disk *d, int n, const SurfacePoint *point, Sorted *s)
{
	int i, k;

	*s = (Sorted){ malloc(n*sizeof *s->within + 1), malloc(n*sizeof *s->on + 1), 0, 0 };
	if (!s->within || !s->on)
		return MESH_ENOMEM;
	for (i = 0; i < n; i++) {
		for (k = 0; k < 3 && point[i].w[(k+2)%3] != 0; k++)
			;
		if (k == 3)
			s->within[s->nwithin++] = point[i];
		else
			s->on[s->non++] = (EdgePoint){ 3*point[i].triangle + k, point[i].w[(k+1)%3] };
	}
	qsort(s->within, s->nwithin, sizeof *s->within, by_triangle);
	s->non = sort_edge_points(d, s->non, s->on);
	return 0;
}

static void
write_loop(Disk *d, const int *after)
{
	int i;

	for (i = 1; i < d->nb; i++)
		d->loop[i] = after[d->loop[i-1]];
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
		write_loop(&s->d, p.after);
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
subdivision_refine(Subdivision *s, const unsigned char *marked, Disk *before)
{
	Disk finer;
	int (*ends)[2], i, old = s->d.m.nv;

	if (refine_split(&s->d, marked, &finer, &ends))
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
