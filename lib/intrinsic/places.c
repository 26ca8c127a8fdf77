/* places.c - the places of crossings, by unfolding triangles into the plane. */
#include <math.h>
#include <stdlib.h>

#include "../base/cmplx.h"
#include "crossings.h"
#include "places.h"

/* One crossing of a mesh edge: the side through which the mesh edge leaves a triangle, and the
 * positions of the end and the start of that side in the plane of the Strand. */
typedef struct Step {
	Crossing     at;
	double complex end, start;
} Step;

/* A mesh edge and the triangles that it crosses, unfolded into the plane of complex numbers.  The
 * mesh edge starts at 0. */
typedef struct Strand {
	Step          *step;
	int            n, room;
	double complex last;    /* position of the vertex at which it ends */
} Strand;

static int
add_step(Strand *s, Step step)
{
	if (s->n == s->room) {
		int room = 2*s->room + 64;
		Step *more = realloc(s->step, room*sizeof *more);

		if (!more)
			return INTRINSIC_ENOMEM;
		s->step = more;
		s->room = room;
	}
	s->step[s->n++] = step;
	return 0;
}

/* Position of the corner opposite to a side that runs from p to q.  The corner lies left of the
 * side. */
static double complex
opposite_corner(const Intrinsic *t, int side, double complex p, double complex q)
{
	double y, x = intrinsic_foot(t, side, &y);
	double d = cabs(q - p);

	return d > 0 ? p + (q - p)/d*CMPLX(x, y) : p;
}

/* Follows the mesh edge that starts at the corner opposite to side h and crosses h at crossing
 * p. */
static int
unfold(const Intrinsic *t, int h, int p, Strand *s)
{
	double complex corner, start = intrinsic_length(t, intrinsic_last(h));
	double complex end = opposite_corner(t, intrinsic_last(h), 0, start);
	Crossing a = { h, p };

	s->n = 0;
	for (;;) {
		if (add_step(s, (Step){ a, end, start }))
			return INTRINSIC_ENOMEM;
		a = crossings_across(t, a);
		corner = opposite_corner(t, a.side, end, start);
		h = a.side;
		a = crossings_follow(t, a.side, a.at);
		if (a.at < 0) {
			s->last = corner;
			return 0;
		}
		if (a.side == intrinsic_next(h))
			end = corner;
		else
			start = corner;
	}
}

static double
clamp(double x, double low, double high)
{
	return !(x > low) ? low : x < high ? x : high;
}

/* Sets the places of the crossings of a strand.  Its mesh edge is the straight line from 0 to
 * s->last. */
static void
place_strand(const Intrinsic *t, const Strand *s, Places *p)
{
	double complex along = conj(s->last)/(cabs(s->last)*cabs(s->last));
	double reached = 0;
	int k;

	for (k = 0; k < s->n; k++) {
		const Step *step = &s->step[k];
		int side = step->at.side, e = t->edge[side], at = step->at.at;
		double a = cimag(along*step->start), b = cimag(along*step->end);
		double x = clamp(a != b ? a/(a - b) : 0.5, 0, 1);

		reached = clamp(creal(along*(step->start + x*(step->end - step->start))), reached, 1);
		if (t->side[e] != side) {
			at = t->crossings[e] - 1 - at;
			x = 1 - x;
		}
		p->on_mesh[p->first[e] + at] = reached;
		p->on_edge[p->first[e] + at] = x;
	}
}

static int
place_all(const Intrinsic *t, Strand *s, Places *p)
{
	int h, at;

	for (h = 0; h < 3*t->nf; h++)
		for (at = 0; at < crossings_on(t, h); at++) {
			int from_start = t->from[intrinsic_last(h)] == t->mesh_from[crossings_mesh_edge(t, h, at)];

			if (crossings_follow(t, h, at).at >= 0 || !from_start)
				continue;
			if (unfold(t, h, at, s))
				return INTRINSIC_ENOMEM;
			place_strand(t, s, p);
		}
	return 0;
}

/* Makes the places on each edge ascending.  The order of crossings is known, but rounding may
 * exchange the places of crossings that are close to each other. */
static void
keep_order(const Intrinsic *t, Places *p)
{
	size_t k;
	int e;

	for (e = 0; e < t->ne; e++)
		for (k = p->first[e] + 1; k < p->first[e+1]; k++)
			p->on_edge[k] = fmax(p->on_edge[k], p->on_edge[k-1]);
}

int
places_init(const Intrinsic *t, Places *p)
{
	Strand s = { NULL, 0, 0, 0 };
	size_t all;
	int e, error = INTRINSIC_ENOMEM;

	*p = (Places){ .first = malloc((t->ne + (size_t)1)*sizeof *p->first) };
	if (p->first) {
		for (p->first[0] = 0, e = 0; e < t->ne; e++)
			p->first[e+1] = p->first[e] + t->crossings[e];
		all = p->first[t->ne];
		p->on_mesh = calloc(all + 1, sizeof *p->on_mesh);
		p->on_edge = calloc(all + 1, sizeof *p->on_edge);
		if (p->on_mesh && p->on_edge)
			error = place_all(t, &s, p);
	}
	free(s.step);
	if (error)
		places_free(p);
	else
		keep_order(t, p);
	return error;
}

void
places_free(Places *p)
{
	free(p->first);
	free(p->on_mesh);
	free(p->on_edge);
	*p = (Places){ 0 };
}
