/* intrinsicmap.c - harmonic functions on the intrinsic Delaunay triangulation. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../intrinsic/crossings.h"
#include "../intrinsic/flips.h"
#include "harmonic.h"
#include "intrinsicmap.h"

enum { STRAIGHTENED = 6 };              /* solves with quadratic elements, at most */
enum { ROUNDS = 40 };                   /* of splitting between two solves */
static const double LEAST = 1e-10;      /* weights below are set to it: rounding, or obtuse angles at the
                                         * boundary that were left */
static const double SHARE = 0.7;        /* of the certificate that the triangles to split hold together */
static const double FULL = 0.9;         /* share of the vertices allowed at which refinement ends: another
                                         * round would add few */
static const double ON_SIDE = 1e-7;     /* barycentric coordinate below which a point is taken to a side */
static const double EQUAL = 1e-6;       /* relative difference of two numbers that differ by rounding only */
static const double FLAT = 1e-14;       /* area, of that of the rectangle, that is 0 up to rounding */

/* Points to add to the mesh. */
typedef struct Points {
	SurfacePoint *point;
	int           n, room;
} Points;

static int
add_point(Points *p, SurfacePoint point)
{
	if (p->n == p->room) {
		int room = 2*p->room + 64;
		SurfacePoint *more = realloc(p->point, room*sizeof *more);

		if (!more)
			return SPD_ENOMEM;
		p->point = more;
		p->room = room;
	}
	p->point[p->n++] = point;
	return 0;
}

/* A point of an edge: one of its ends, or a crossing. */
typedef struct Stop {
	double at;              /* 0..1 along the edge */
	int    vertex;          /* -1: a crossing */
	int    side;            /* of the mesh, that is crossed */
	double place;           /* 0..1 on that side */
} Stop;

/* Stop k of edge e: its start for -1, then its crossings, then its end. */
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

/* Whether triangle f of the mesh has the stop on a side or as a corner; w: the coordinates there. */
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

/* The point between two stops of an edge that follow each other, 0..1 from the first; the edge runs within a triangle of the
 * mesh there. */
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
	return between(mesh, &a, &b, (0.5 - a.at)/(b.at - a.at));
}

/* The two ends of edge e. */
static void
ends(const Intrinsic *t, int e, int end[2])
{
	end[0] = t->from[t->side[e]];
	end[1] = t->from[intrinsic_next(t->side[e])];
}

/* Whether a map would shrink edge e to a point or lay it on a side: a loop, or an inner edge between
 * vertices of one side of the rectangle. */
static int
collapses(const Intrinsic *t, const unsigned char *side, int e)
{
	int end[2];

	ends(t, e, end);
	return t->twin[t->side[e]] >= 0 && (end[0] == end[1] || (side[end[0]] & side[end[1]]));
}

/* The edges at each vertex, as their lower end: those of vertex i are at[first[i]] .. at[first[i+1]-1].
 * first: [nv+2]. */
static void
sort_by_lower_end(const Intrinsic *t, int *first, int *at)
{
	int e, i, end[2];

	memset(first, 0, (t->nv + (size_t)2)*sizeof *first);
	for (e = 0; e < t->ne; e++) {
		ends(t, e, end);
		first[(end[0] < end[1] ? end[0] : end[1]) + 2]++;
	}
	for (i = 0; i < t->nv; i++)
		first[i+2] += first[i+1];
	for (e = 0; e < t->ne; e++) {
		ends(t, e, end);
		at[first[(end[0] < end[1] ? end[0] : end[1]) + 1]++] = e;
	}
}

/* Marks inner edges that have the ends of another edge: a map lays them on each other.
 * last: workspace, [nv], the last edge to a vertex. */
static void
mark_doubled(const Intrinsic *t, const int *first, const int *at, int *last, unsigned char *marked)
{
	int i, k, end[2];

	memset(last, -1, t->nv*sizeof *last);
	for (i = 0; i < t->nv; i++)
		for (k = first[i]; k < first[i+1]; k++) {
			int e = at[k], j, other;

			ends(t, e, end);
			j = end[0] == i ? end[1] : end[0];
			other = last[j];
			last[j] = e;
			if (other < 0)
				continue;
			ends(t, other, end);
			if (end[0] != i && end[1] != i)
				continue;
			marked[e] |= t->twin[t->side[e]] >= 0;
			marked[other] |= t->twin[t->side[other]] >= 0;
		}
}

/* Marks the edges that no map onto the rectangle can keep straight and apart. */
static int
mark_collapsing(const Intrinsic *t, const unsigned char *side, unsigned char *marked)
{
	int *first = malloc((t->nv + (size_t)2)*sizeof *first), *at = malloc(t->ne*sizeof *at);
	int *last = malloc(t->nv*sizeof *last), e, error = SPD_ENOMEM;

	if (first && at && last) {
		for (e = 0; e < t->ne; e++)
			marked[e] = collapses(t, side, e);
		sort_by_lower_end(t, first, at);
		mark_doubled(t, first, at, last, marked);
		error = 0;
	}
	free(first);
	free(at);
	free(last);
	return error;
}

/* Adds the feet of obtuse angles opposite to boundary edges: mirrored there, the triangulation
 * is not Delaunay. */
static int
add_feet(const Intrinsic *t, Points *points)
{
	int e, error = 0;

	for (e = 0; !error && e < t->ne; e++) {
		int h = t->side[e];
		double height, place = intrinsic_foot(t, h, &height)/t->length[e];

		if (t->twin[h] >= 0 || intrinsic_cotangent(t, h) > -1e-6 || !(place > 0.01 && place < 0.99))
			continue;
		error = add_point(points, subdivision_on_side(t->mesh_side[t->along[e]], place));
	}
	return error;
}

/* Adds the middles of the marked edges. */
static int
add_marked(const Intrinsic *t, const Disk *mesh, const unsigned char *marked, Points *points)
{
	Places places;
	int e, error;

	if (!memchr(marked, 1, t->ne))
		return 0;
	error = crossings_places(t, &places) ? SPD_ENOMEM : 0;
	if (error)
		return error;
	for (e = 0; !error && e < t->ne; e++)
		if (marked[e])
			error = add_point(points, middle(t, mesh, &places, e));
	places_free(&places);
	return error;
}

static void
find_corners(IntrinsicMap *m, const int vertex[4])
{
	int i, k;

	for (i = 0; i < m->mesh.d.nb; i++)
		for (k = 0; k < 4; k++)
			if (m->mesh.d.loop[i] == vertex[k])
				m->corner[k] = i;
}

/* The Delaunay triangulation of the mesh as it is, and the points that it still needs. */
static int
triangulate(IntrinsicMap *m, const int vertex[4], int feet, Points *points)
{
	unsigned char *side = malloc(m->mesh.d.m.nv), *marked = NULL;
	int e;

	intrinsic_free(&m->t);
	e = !side || intrinsic_init(&m->t, &m->mesh.d) ? SPD_ENOMEM : 0;
	if (!e) {
		intrinsic_mollify(&m->t);
		e = intrinsic_delaunay(&m->t, m->key) ? SPD_ENOMEM : 0;
	}
	if (!e)
		marked = malloc(m->t.ne);
	if (!e && !marked)
		e = SPD_ENOMEM;
	if (!e) {
		find_corners(m, vertex);
		harmonic_sides(&m->mesh.d, m->corner, side);
		e = mark_collapsing(&m->t, side, marked);
	}
	points->n = 0;
	if (!e)
		e = add_marked(&m->t, &m->mesh.d, marked, points);
	if (!e && feet)
		e = add_feet(&m->t, points);
	free(side);
	free(marked);
	return e;
}

/* The corners in an order that depends on their places alone: from the one farthest from the others, to
 * the farther of its neighbours first. */
static void
order_corners(const double *xyz, const int vertex[4], int order[4])
{
	double far[4], x[3];
	int i, k, first = 0, step;

	for (k = 0; k < 4; k++)
		for (far[k] = 0, i = 0; i < 4; i++) {
			sub3(&xyz[3*(size_t)vertex[i]], &xyz[3*(size_t)vertex[k]], x);
			far[k] += norm3(x);
		}
	for (k = 1; k < 4; k++)
		if (far[k] > far[first]*(1 + EQUAL))
			first = k;
	step = far[(first+3)%4] > far[(first+1)%4]*(1 + EQUAL) ? 3 : 1;
	for (k = 0; k < 4; k++)
		order[k] = vertex[(first + step*k)%4];
}

/* A number at each vertex that depends on the shape alone: distances to the corners.  The corners count a little
 * differently, so that symmetric surfaces have no equal numbers. */
static int
set_keys(IntrinsicMap *m, const int vertex[4])
{
	static const double share[4] = { 1, 1.0103, 1.0237, 1.0391 };
	const double *xyz = m->mesh.d.m.xyz;
	int i, k, nv = m->mesh.d.m.nv, corner[4];
	double x[3];

	order_corners(xyz, vertex, corner);
	free(m->key);
	m->key = malloc(nv*sizeof *m->key);
	for (i = 0; m->key && i < nv; i++)
		for (m->key[i] = 0, k = 0; k < 4; k++) {
			sub3(&xyz[3*(size_t)i], &xyz[3*(size_t)corner[k]], x);
			m->key[i] += share[k]*norm3(x);
		}
	return m->key ? 0 : SPD_ENOMEM;
}

/* Adds the points to the mesh.  Returns the number of new vertices, or SPD_ENOMEM. */
static int
add_points(IntrinsicMap *m, const int vertex[4], const Points *points)
{
	int n = subdivision_add(&m->mesh, points->n, points->point);

	return n < 0 || set_keys(m, vertex) || intrinsic_improve(&m->mesh, m->key) ? SPD_ENOMEM : n;
}

/* Splits the mesh until its Delaunay triangulation can be embedded. */
static int
prepare(IntrinsicMap *m, const int vertex[4], const AdaptOptions *o)
{
	Points points = { NULL, 0, 0 };
	int k, e = 0;

	for (k = 0; !e && k < ROUNDS; k++) {
		e = triangulate(m, vertex, k < ROUNDS/2 && m->mesh.d.m.nv < o->most, &points);
		if (e || points.n == 0 || k + 1 == ROUNDS)
			break;
		e = add_points(m, vertex, &points);
		e = e < 0 ? SPD_ENOMEM : 0;
	}
	free(points.point);
	return e;
}

/* The cotangent matrix of the triangulation. */
typedef struct Matrix {
	Graph   g;
	double *off;
} Matrix;

static void
matrix_free(Matrix *a)
{
	free(a->g.first);
	free(a->g.adj);
	free(a->off);
}

/* Joins entries of a row for the same neighbour; seen: workspace, [n], -1 on entry. */
static void
join_entries(Matrix *a, int *seen)
{
	int i, k, n = 0, begin = 0;

	for (i = 0; i < a->g.n; i++) {
		int end = a->g.first[i+1], start = n;

		for (k = begin; k < end; k++) {
			int j = a->g.adj[k];

			if (seen[j] >= start) {
				a->off[seen[j]] += a->off[k];
				continue;
			}
			seen[j] = n;
			a->g.adj[n] = j;
			a->off[n++] = a->off[k];
		}
		begin = end;
		a->g.first[i+1] = n;
	}
}

static double
weight(const Intrinsic *t, int e)
{
	int h = t->side[e], g = t->twin[h];

	return (intrinsic_cotangent(t, h) + (g >= 0 ? intrinsic_cotangent(t, g) : 0))/2;
}

/* An entry of a symmetric matrix off the diagonal. */
typedef struct Entry {
	int    i, j;
	double x;
} Entry;

/* The matrix of n unknowns with the given entries; those of equal place are added. */
static int
matrix_init(Matrix *a, int n, size_t entries, const Entry *entry)
{
	int *next = malloc(n*sizeof *next), *first, i;
	size_t k;

	*a = (Matrix){ { n, calloc(n + (size_t)1, sizeof(int)), malloc(2*entries*sizeof(int)) },
		malloc(2*entries*sizeof(double)) };
	if (!next || !a->g.first || !a->g.adj || !a->off) {
		free(next);
		matrix_free(a);
		return SPD_ENOMEM;
	}
	first = a->g.first;
	for (k = 0; k < entries; k++) {
		first[entry[k].i + 1]++;
		first[entry[k].j + 1]++;
	}
	for (i = 0; i < n; i++)
		first[i+1] += first[i];
	memcpy(next, first, n*sizeof *next);
	for (k = 0; k < entries; k++) {
		int at = next[entry[k].i]++, to = next[entry[k].j]++;

		a->g.adj[at] = entry[k].j;
		a->g.adj[to] = entry[k].i;
		a->off[at] = a->off[to] = entry[k].x;
	}
	memset(next, -1, n*sizeof *next);
	join_entries(a, next);
	free(next);
	return 0;
}

/* The matrix of linear elements, no weight of which is below LEAST. */
static int
linear_matrix(const Intrinsic *t, Matrix *a)
{
	Entry *entry = malloc(t->ne*sizeof *entry);
	int e, n = 0, error = SPD_ENOMEM, end[2];

	if (entry) {
		for (e = 0; e < t->ne; e++) {
			ends(t, e, end);
			if (end[0] != end[1])
				entry[n++] = (Entry){ end[0], end[1], -fmax(weight(t, e), LEAST) };
		}
		error = matrix_init(a, t->nv, n, entry);
	}
	free(entry);
	return error;
}

/* Unknowns of quadratic elements: the values at the vertices and, after them, at the middles of the edges.
 * At the middle of a straight edge the value is the mean of its ends, and there is no unknown. */
typedef struct Middles {
	int *unknown;           /* [ne] of each edge, or -1: straight */
	int  n;                 /* of all unknowns */
} Middles;

static void
number_middles(const Intrinsic *t, const unsigned char *straight, Middles *m)
{
	int e;

	m->n = t->nv;
	for (e = 0; e < t->ne; e++)
		m->unknown[e] = straight[e] ? -1 : m->n++;
}

typedef struct Entries {
	const Intrinsic *t;
	const Middles   *m;
	Entry           *entry;
	size_t           n;
} Entries;

/* Adds w (x_p - x_q)^2 to the energy; p and q are vertices, or nv + e for the middle of edge e.  With x_p = (x_i + x_j)/2,
 * (x_p - x_q)^2 = (x_i - x_q)^2/2 + (x_j - x_q)^2/2 - (x_i - x_j)^2/4. */
static void
add_difference(Entries *a, int p, int q, double w)
{
	int nv = a->t->nv, end[2], swap;

	if (p == q)
		return;
	if (q >= nv && a->m->unknown[q-nv] < 0)
		swap = p, p = q, q = swap;
	if (p >= nv && a->m->unknown[p-nv] < 0) {
		ends(a->t, p - nv, end);
		add_difference(a, end[0], q, w/2);
		add_difference(a, end[1], q, w/2);
		add_difference(a, end[0], end[1], -w/4);
		return;
	}
	p = p < nv ? p : a->m->unknown[p-nv];
	q = q < nv ? q : a->m->unknown[q-nv];
	a->entry[a->n++] = (Entry){ p, q, -w };
}

enum { MOST_ENTRIES = 7 };      /* of one difference: both ends may be middles of straight edges */

/* The matrix of quadratic elements, (4 C_fine - C_coarse)/3 as in cotangent.h.  A part of a triangle has the angles of
 * the triangle. */
static int
quadratic_matrix(const Intrinsic *t, const Middles *m, Matrix *a)
{
	Entries all = { t, m, malloc(MOST_ENTRIES*3*((size_t)t->ne + t->nf)*sizeof(Entry)), 0 };
	int e, h, error = SPD_ENOMEM, end[2];

	if (all.entry) {
		for (e = 0; e < t->ne; e++) {
			double w = weight(t, e);

			ends(t, e, end);
			add_difference(&all, end[0], t->nv + e, 4*w/3);
			add_difference(&all, end[1], t->nv + e, 4*w/3);
			add_difference(&all, end[0], end[1], -w/3);
		}
		for (h = 0; h < 3*t->nf; h++)
			add_difference(&all, t->nv + t->edge[intrinsic_next(h)], t->nv + t->edge[intrinsic_last(h)],
			    4*intrinsic_cotangent(t, h)/3);
		error = matrix_init(a, m->n, all.n, all.entry);
	}
	free(all.entry);
	return error;
}

/* The sides of the middles of edges, after those of the vertices. */
static void
sides_of_middles(const Intrinsic *t, const Middles *m, unsigned char *side)
{
	int e, end[2];

	for (e = 0; e < t->ne; e++) {
		ends(t, e, end);
		if (m->unknown[e] >= 0)
			side[m->unknown[e]] = t->twin[t->side[e]] < 0 ? side[end[0]] & side[end[1]] : 0;
	}
}

/* From the unknowns to the values at the vertices and all middles; x: [nv + ne]. */
static void
spread_middles(const Intrinsic *t, const Middles *m, double *x)
{
	int e, end[2];

	for (e = t->ne - 1; e >= 0; e--)
		if (m->unknown[e] >= 0)
			x[t->nv + e] = x[m->unknown[e]];
	for (e = 0; e < t->ne; e++)
		if (m->unknown[e] < 0) {
			ends(t, e, end);
			x[t->nv + e] = (x[end[0]] + x[end[1]])/2;
		}
}

/* By the maximum principle only the two sides have the values 0 and 1; rounding may give them to others. */
static void
keep_inside(int n, const unsigned char *side, int held, double *x)
{
	int i;

	for (i = 0; i < n; i++)
		if (!(side[i] & held))
			x[i] = fmin(fmax(x[i], DBL_MIN), 1 - DBL_EPSILON);
}

static int
harmonic_pair(const Matrix *a, const unsigned char *side, double *u, double *v, SpdReport *report)
{
	Harmonic h = { .g = &a->g, .off = a->off, .side = side };
	int *order = malloc(a->g.n*sizeof *order), e;

	h.diagonal = malloc(a->g.n*sizeof *h.diagonal);
	e = !order || !h.diagonal || order_graph(&a->g, order) || chol_init(&h.chol, &a->g, order) ? SPD_ENOMEM : 0;
	report->bytes = chol_bytes(&h.chol);
	if (!e) {
		harmonic_diagonal(&h);
		e = harmonic_solve(&h, SIDE_LEFT, SIDE_RIGHT, u, report);
	}
	if (!e)
		e = harmonic_solve(&h, SIDE_BOTTOM, SIDE_TOP, v, report);
	if (!e) {
		keep_inside(a->g.n, side, SIDE_LEFT | SIDE_RIGHT, u);
		keep_inside(a->g.n, side, SIDE_BOTTOM | SIDE_TOP, v);
	}
	chol_free(&h.chol);
	free(h.diagonal);
	free(order);
	return e;
}

/* The Dirichlet energy of linear elements, of the true weights. */
static double
energy(const Intrinsic *t, const double *x)
{
	double sum = 0;
	int e, end[2];

	for (e = 0; e < t->ne; e++) {
		ends(t, e, end);
		sum += weight(t, e)*(x[end[0]] - x[end[1]])*(x[end[0]] - x[end[1]]);
	}
	return sum;
}

/* The energy of quadratic elements. */
static double
quadratic_energy(const Intrinsic *t, const double *x)
{
	const double *middle = x + t->nv;
	double fine = 0;
	int e, h, end[2];

	for (e = 0; e < t->ne; e++) {
		double a, b;

		ends(t, e, end);
		a = x[end[0]] - middle[e], b = x[end[1]] - middle[e];
		fine += weight(t, e)*(a*a + b*b);
	}
	for (h = 0; h < 3*t->nf; h++) {
		double d = middle[t->edge[intrinsic_next(h)]] - middle[t->edge[intrinsic_last(h)]];

		fine += intrinsic_cotangent(t, h)*d*d;
	}
	return (4*fine - energy(t, x))/3;
}

/* Twice the signed area of triangle f in (u,v). */
static double
image(const IntrinsicMap *m, int f)
{
	const int *c = &m->t.from[3*f];
	const double *u = m->u, *v = m->v;

	return (u[c[1]] - u[c[0]])*(v[c[2]] - v[c[0]]) - (u[c[2]] - u[c[0]])*(v[c[1]] - v[c[0]]);
}

/* Sets T and the certificate from the energies, and v from v1. */
static int
finish(IntrinsicMap *m, double Eu, double Ev)
{
	int i;

	if (!(Eu > 0 && Eu < HUGE_VAL && Ev > 0 && Ev < HUGE_VAL))
		return SPD_EINDEFINITE;
	m->T = sqrt(Eu/Ev);                             /* (6) */
	m->certificate = sqrt(Eu*Ev) - 1;
	for (i = 0; i < m->t.nv; i++)
		m->v[i] *= m->T;                        /* (4) */
	return 0;
}

static int
count_turned(const IntrinsicMap *m)
{
	int f, turned = 0;

	for (f = 0; f < m->t.nf; f++)
		turned += image(m, f) < -FLAT*m->T;
	return turned;
}

/* u and v1 at the vertices, and at the middles if m is not NULL. */
static int
solve_pair(const IntrinsicMap *map, const Middles *m, double *u, double *v, SpdReport *report)
{
	const Intrinsic *t = &map->t;
	unsigned char *side = malloc(m ? m->n : t->nv);
	Matrix a;
	int e = side ? (m ? quadratic_matrix(t, m, &a) : linear_matrix(t, &a)) : SPD_ENOMEM;

	if (!e) {
		harmonic_sides(&map->mesh.d, map->corner, side);
		if (m)
			sides_of_middles(t, m, side);
		e = harmonic_pair(&a, side, u, v, report);
		matrix_free(&a);
	}
	if (!e && m) {
		spread_middles(t, m, u);
		spread_middles(t, m, v);
	}
	free(side);
	return e;
}

static int
solve(IntrinsicMap *m, SpdReport *report)
{
	int e;

	free(m->u);
	free(m->v);
	m->u = malloc(m->t.nv*sizeof *m->u);
	m->v = malloc(m->t.nv*sizeof *m->v);
	e = m->u && m->v ? solve_pair(m, NULL, m->u, m->v, report) : SPD_ENOMEM;
	if (!e)
		e = finish(m, energy(&m->t, m->u), energy(&m->t, m->v));
	if (!e)
		m->turned = count_turned(m);
	return e;
}

/* Makes the edges of turned and flat triangles straight, and those of triangles with a straight edge. */
static void
straighten(const IntrinsicMap *m, unsigned char *straight, unsigned char *before)
{
	const int *edge = m->t.edge;
	int f, k;

	memcpy(before, straight, m->t.ne);
	for (f = 0; f < m->t.nf; f++) {
		const int *e = &edge[3*f];

		for (k = 0; k < 3 && (!(image(m, f) > 0) || before[e[0]] || before[e[1]] || before[e[2]]); k++)
			straight[e[k]] = 1;
	}
}

/* Quadratic elements with more and more straight edges round the triangles that they turn over: some of their weights are negative,
 * where all edges are straight none is. */
static int
solve_quadratic(IntrinsicMap *q, unsigned char *straight, Middles *m, SpdReport *report)
{
	unsigned char *before = malloc(q->t.ne);
	int k, e = before ? 0 : SPD_ENOMEM;

	q->turned = 1;
	for (k = 0; !e && k < STRAIGHTENED && q->turned > 0; k++) {
		number_middles(&q->t, straight, m);
		e = solve_pair(q, m, q->u, q->v, report);
		if (!e)
			e = finish(q, quadratic_energy(&q->t, q->u), quadratic_energy(&q->t, q->v));
		if (!e) {
			q->turned = count_turned(q);
			straighten(q, straight, before);
		}
	}
	free(before);
	return e;
}

/* Improves the map by quadratic elements, unless they turn triangles over. */
static int
improve(IntrinsicMap *map, SpdReport *report)
{
	size_t n = map->t.nv + (size_t)map->t.ne;
	unsigned char *straight = calloc(map->t.ne, 1);
	Middles m = { malloc(map->t.ne*sizeof *m.unknown), 0 };
	IntrinsicMap q = *map;
	int e = SPD_ENOMEM;

	q.u = malloc(n*sizeof *q.u);
	q.v = malloc(n*sizeof *q.v);
	if (straight && m.unknown && q.u && q.v)
		e = solve_quadratic(&q, straight, &m, report);
	free(straight);
	free(m.unknown);
	if (e || q.turned > 0 || !(q.certificate < map->certificate)) {
		free(q.u);
		free(q.v);
		return e == SPD_ENOMEM ? e : 0;
	}
	free(map->u);
	free(map->v);
	*map = q;
	map->quadratic = 1;
	return 0;
}

/* The term of triangle f in the sum for T certificate (adapt.h). */
static double
term(const IntrinsicMap *m, int f)
{
	const Intrinsic *t = &m->t;
	const int *c = &t->from[3*f];
	double l0 = intrinsic_length(t, 3*f), l1 = intrinsic_length(t, 3*f + 1), l2 = intrinsic_length(t, 3*f + 2);
	double ua = m->u[c[1]] - m->u[c[0]], ub = m->u[c[2]] - m->u[c[0]];
	double va = m->v[c[1]] - m->v[c[0]], vb = m->v[c[2]] - m->v[c[0]];
	double gaa = l0*l0, gbb = l2*l2, gab = (gaa + (l2 - l1)*(l2 + l1))/2;

	return ((ub*ub + vb*vb)*gaa - 2*(ua*ub + va*vb)*gab + (ua*ua + va*va)*gbb)/(8*intrinsic_area(l0, l1, l2))
	    - (ua*vb - ub*va)/2;
}

static int
falling(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return x < y ? 1 : x > y ? -1 : 0;
}

/* The term above which the triangles hold SHARE of the certificate, at most `most` of them;
 * sorted: workspace, [nf]. */
static double
threshold(const double *terms, int nf, int most, double *sorted)
{
	double all = 0, sum = 0;
	int k;

	memcpy(sorted, terms, nf*sizeof *sorted);
	qsort(sorted, nf, sizeof *sorted, falling);
	for (k = 0; k < nf; k++)
		all += sorted[k];
	for (k = 0; k < nf && k < most && sum < SHARE*all; k++)
		sum += sorted[k];
	return k > 0 && all > 0 ? sorted[k-1]*(1 - EQUAL) : HUGE_VAL;
}

/* Marks the longest edges of the triangles with the largest terms. */
static int
mark_worst(const IntrinsicMap *m, int most, unsigned char *marked)
{
	const Intrinsic *t = &m->t;
	double *terms = malloc(2*(size_t)t->nf*sizeof *terms), least;
	int f, k;

	if (!terms)
		return SPD_ENOMEM;
	for (f = 0; f < t->nf; f++)
		terms[f] = term(m, f);
	least = threshold(terms, t->nf, most, terms + t->nf);
	memset(marked, 0, t->ne);
	for (f = 0; f < t->nf; f++) {
		double longest = fmax(intrinsic_length(t, 3*f), fmax(intrinsic_length(t, 3*f + 1), intrinsic_length(t, 3*f + 2)));

		for (k = 0; k < 3 && terms[f] >= least; k++)
			if (intrinsic_length(t, 3*f + k) >= longest*(1 - EQUAL))
				marked[t->edge[3*f+k]] = 1;
	}
	free(terms);
	return 0;
}

/* Splits where the certificate is largest.  Returns the number of new vertices, or SPD_ENOMEM. */
static int
split_worst(IntrinsicMap *m, const int vertex[4], int most)
{
	unsigned char *marked = malloc(m->t.ne);
	Points points = { NULL, 0, 0 };
	int n = marked ? mark_worst(m, most, marked) : SPD_ENOMEM;

	if (!n)
		n = add_marked(&m->t, &m->mesh.d, marked, &points);
	if (!n && points.n > 0)
		n = add_points(m, vertex, &points);
	free(marked);
	free(points.point);
	return n < 0 ? SPD_ENOMEM : n;
}

/* Splits and solves until the certificate is small enough. */
static int
refine(IntrinsicMap *m, const int vertex[4], const AdaptOptions *o, SpdReport *report)
{
	int e = 0, n = 1;

	while (!e && n > 0 && m->certificate > o->tolerance && m->t.nv < FULL*o->most) {
		n = split_worst(m, vertex, o->most - m->t.nv);
		e = n < 0 ? SPD_ENOMEM : 0;
		if (n > 0) {
			e = prepare(m, vertex, o);
			if (!e)
				e = solve(m, report);
		}
	}
	return e;
}

int
intrinsic_map(const Disk *d, const int vertex[4], const AdaptOptions *o, IntrinsicMap *m, SpdReport *report)
{
	int e;

	memset(m, 0, sizeof *m);
	memset(report, 0, sizeof *report);
	e = subdivision_init(&m->mesh, d) || set_keys(m, vertex) || prepare(m, vertex, o) ? SPD_ENOMEM : solve(m, report);
	if (!e)
		e = refine(m, vertex, o, report);
	if (!e && o->split > 0 && m->t.nv <= o->most/4)
		e = improve(m, report);
	if (e)
		intrinsic_map_free(m);
	return e;
}

void
intrinsic_map_free(IntrinsicMap *m)
{
	subdivision_free(&m->mesh);
	intrinsic_free(&m->t);
	free(m->u);
	free(m->v);
	free(m->key);
	m->u = m->v = m->key = NULL;
}
