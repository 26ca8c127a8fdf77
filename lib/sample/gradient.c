/* gradient.c - neighbourhoods of the vertices, and the limits on the fitted derivatives. */
#include <math.h>
#include <string.h>

#include "polyfit.h"
#include "../mesh/topology.h"
#include "../base/vec3.h"

enum {
	ENOUGH = 15,    /* rings are added until there are more points than this, */
	RINGS  = 6      /* or this many rings */
};

static void
join(Hood *h, int v)
{
	unsigned k = (unsigned)v%(2*POLYFIT_MOST);

	for (; h->slot[k]; k = (k + 1)%(2*POLYFIT_MOST))
		if (h->v[h->slot[k] - 1] == v)
			return;
	if (h->n == POLYFIT_MOST) {
		h->full = 1;
		return;
	}
	h->v[h->n++] = v;
	h->slot[k] = h->n;
}

/* Adds the neighbours of vertex i to h; at a hub only those of s->near.  In each triangle the side
 * opposite to i has two ends, which are neighbours of i.  The first loop adds the first ends.  If the
 * triangles surround i, the second ends are the same vertices as the first ends, so `open`, the sum
 * of the first minus the second vertex numbers, is 0 and all neighbours are there.  Otherwise the
 * second loop adds the second ends. */
static void
join_neighbours(const Mesh *m, const Stars *s, Hood *h, int i)
{
	int l, side;
	unsigned open = 0;

	if (s->hub[i] >= 0) {
		const int *near = &s->near[STARS_FEW*(size_t)s->hub[i]];

		for (l = 0; l < STARS_FEW; l++)
			if (near[l] >= 0)
				join(h, near[l]);
		return;
	}
	for (l = s->first[i]; l < s->first[i + 1]; l++) {
		side = topology_next(s->side[l]);
		join(h, m->tri[side]);
		open += (unsigned)m->tri[side] - (unsigned)m->tri[topology_next(side)];
	}
	for (l = s->first[i]; l < s->first[i + 1] && open; l++)
		join(h, m->tri[topology_next(topology_next(s->side[l]))]);
}

/* The square of the distance of vertex i from h->v[0] in (u,v). */
static double
distance2(const Hood *h, const double *u, const double *v, int i)
{
	double du = u[i] - u[h->v[0]], dv = v[i] - v[h->v[0]];

	return du*du + dv*dv;
}

/* Removes what was added to h after the outermost ring, and sorts that ring by distance. */
static void
undo_growth(Hood *h, const double *u, const double *v, int end)
{
	Hood old = *h;
	int k, l;

	*h = (Hood){ .ring = old.ring };
	for (k = 0; k < end; k++) {
		int i = old.v[k];

		for (l = k; l > old.ring && distance2(&old, u, v, old.v[l-1]) > distance2(&old, u, v, i); l--)
			old.v[l] = old.v[l-1];
		old.v[l] = i;
	}
	for (k = 0; k < end; k++)
		join(h, old.v[k]);
}

/* Like join_neighbours, in an order that does not depend on which end of a side is the first: that
 * which is nearer to h->v[0] in (u,v) comes before the other. */
static void
join_nearer_first(const Mesh *m, const Stars *s, const double *u, const double *v, Hood *h, int i)
{
	int l, side, a, b;

	if (s->hub[i] >= 0) {
		join_neighbours(m, s, h, i);
		return;
	}
	for (l = s->first[i]; l < s->first[i + 1]; l++) {
		side = topology_next(s->side[l]);
		a = m->tri[side], b = m->tri[topology_next(side)];
		if (distance2(h, u, v, b) < distance2(h, u, v, a))
			a = b, b = m->tri[side];
		join(h, a);
		join(h, b);
	}
}

/* Adds a ring to h, or the part for which there is room: which part must not depend on the
 * numbering. */
static void
grow(const Mesh *m, const Stars *s, const double *u, const double *v, Hood *h)
{
	int end = h->n, k;

	for (k = h->ring; k < end; k++)
		join_neighbours(m, s, h, h->v[k]);
	if (h->full) {
		undo_growth(h, u, v, end);
		for (k = h->ring; k < end; k++)
			join_nearer_first(m, s, u, v, h, h->v[k]);
	}
	h->ring = end;
}

/* The square of the longest side of a triangle in R^3. */
static double
longest2(const Mesh *m, const int *tri)
{
	double d[3], l, most = 0;
	int k;

	for (k = 0; k < 3; k++) {
		sub3(&m->xyz[3*tri[k]], &m->xyz[3*tri[(k+1)%3]], d);
		l = dot3(d, d);
		most = l > most ? l : most;
	}
	return most;
}

/* Computes the vectors in the limits of gradient.h for the side from i to j, whose step in (u,v) is
 * e: the step d in R^3, first = phi'(e) - d, and second = phi''(e,e)/8. */
static void
side_terms(const Mesh *m, const double *u, const double *v, const Jet *jet, int i, int j,
	double d[3], double first[3], double second[3])
{
	double du = u[j] - u[i], dv = v[j] - v[i];
	int c;

	sub3(&m->xyz[3*j], &m->xyz[3*i], d);
	for (c = 0; c < 3; c++) {
		first[c] = jet->u[c]*du + jet->v[c]*dv - d[c];
		second[c] = (jet->uu[c]*du*du + 2*jet->uv[c]*du*dv + jet->vv[c]*dv*dv)/8;
	}
}

/* A factor s in 0..1 such that s times the jet at i satisfies the limits of gradient.h along the
 * side i j of a triangle: the largest s for which this follows from the estimate
 * |s phi'(e) - d| <= s |phi'(e) - d| + (1 - s) |d|.  L2 is the square of the longest side of the
 * triangle. */
static double
side_factor(const Mesh *m, const double *u, const double *v, const Jet *jet, int i, int j, double L2)
{
	double d[3], first[3], second[3], bend, turn, L, s = 1;

	side_terms(m, u, v, jet, i, j, d, first, second);
	bend = dot3(first, first);
	turn = dot3(second, second);
	if (bend <= GRADIENT_BEND*GRADIENT_BEND*L2 && turn <= GRADIENT_BEND*GRADIENT_BEND*L2)
		return 1;
	L = sqrt(L2);
	bend = norm3(first);
	turn = norm3(second);
	if (!isfinite(bend) || !isfinite(turn))
		return 0;
	if (!(bend <= GRADIENT_BEND*L))
		s = (GRADIENT_BEND*L - norm3(d))/(bend - norm3(d));
	if (!(turn <= GRADIENT_BEND*L))
		s = fmin(s, GRADIENT_BEND*L/turn);
	return fmax(s, 0);
}

/* Whether the jet at ring[0] satisfies the limits along the sides to ring[1] .. ring[n-1] with L
 * replaced by the length |d| of each side.  As |d| <= L, the true limits then hold, too.  This test
 * is quicker, and jets nearly always pass it. */
static int
clearly_within(const Mesh *m, const double *u, const double *v, const Jet *jet, const int *ring, int n)
{
	double d[3], first[3], second[3], L2;
	int k;

	for (k = 1; k < n; k++) {
		side_terms(m, u, v, jet, ring[0], ring[k], d, first, second);
		L2 = GRADIENT_BEND*GRADIENT_BEND*dot3(d, d);
		if (!(dot3(first, first) <= L2 && dot3(second, second) <= L2))
			return 0;
	}
	return 1;
}

/* The smallest side_factor over the sides at i of all triangles at i; at most 1. */
static double
limiting_factor(const Mesh *m, const Stars *s, const double *u, const double *v, const Jet *jet, int i)
{
	double least = 1, L2;
	int l, k;

	for (l = s->first[i]; l < s->first[i + 1]; l++) {
		const int *tri = &m->tri[s->side[l]/3*3];

		L2 = longest2(m, tri);
		for (k = 0; k < 3; k++)
			if (tri[k] != i)
				least = fmin(least, side_factor(m, u, v, jet, i, tri[k], L2));
	}
	return least;
}

static void
scale(Jet *jet, double s)
{
	int c;

	if (!(s > 0))
		memset(jet, 0, sizeof *jet);
	for (c = 0; c < 3; c++) {
		jet->u[c] *= s, jet->v[c] *= s;
		jet->uu[c] *= s, jet->uv[c] *= s, jet->vv[c] *= s;
	}
}

/* Computes the jet at vertex i.  Returns GRADIENT_LOW, GRADIENT_LIMITED, both or 0. */
static int
fit_vertex(const Mesh *m, const Stars *s, const double *u, const double *v, int i, Jet *jet)
{
	Hood h = { 0 };
	double most = 0;
	int ring, degree, near = 0;     /* near: number of points of h after the first ring */
	Polyfit f;

	join(&h, i);
	for (f.rank = 0, ring = 1; ring <= RINGS && f.rank < POLYFIT_TERMS; ring++) {
		grow(m, s, u, v, &h);
		if (ring == 1)
			near = h.n;
		if (ring < 2 || (h.n <= ENOUGH && ring < RINGS))
			continue;
		polyfit(&f, &h, m, u, v);
	}
	for (degree = 3; degree > 0; degree--) {
		polyfit_jet(&f, degree, jet);
		most = s->hub[i] < 0 && clearly_within(m, u, v, jet, h.v, near) ? 1
		    : limiting_factor(m, s, u, v, jet, i);
		if (most >= 1)
			break;
	}
	if (most < 1)
		scale(jet, most);
	return (f.rank < POLYFIT_TERMS ? GRADIENT_LOW : 0) | (degree < 3 ? GRADIENT_LIMITED : 0);
}

void
gradient_fit(const Stars *s, const Mesh *m, const double *u, const double *v, unsigned char *state,
	Jet *jet)
{
	int i;

#pragma omp parallel for schedule(dynamic, 256)
	for (i = 0; i < m->nv; i++)
		if (state[i] == GRADIENT_WANTED)
			state[i] = GRADIENT_KNOWN | fit_vertex(m, s, u, v, i, &jet[i]);
}
