/* intrinsicmap.c - splits edges where the terms of the certificate are largest, and solves
 * again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../intrinsic/edgepoints.h"
#include "intrinsicmap.h"
#include "worst.h"

static const double FULL = 0.9;         /* refinement ends at this share of the allowed vertices:
                                         * another round could add only few */
static const double EQUAL = 1e-6;       /* relative difference of two numbers that differ by
                                         * rounding only */

/* The term of triangle f (worst.h). */
static double
term(const IntrinsicMap *m, int f)
{
	const Intrinsic *t = &m->s.t;
	double l0 = intrinsic_length(t, 3*f), l2 = intrinsic_length(t, 3*f + 2);

	return worst_term(&t->from[3*f], m->u, m->v, l0*l0, t->dot[3*f], l2*l2, t->area[f]);
}

/* Marks the longest edge of each triangle that has one of the largest terms (worst.h); if several
 * edges are longest up to rounding, all of them. */
static int
mark_worst(const IntrinsicMap *m, int most, unsigned char *marked)
{
	const Intrinsic *t = &m->s.t;
	double *terms = malloc(2*(size_t)t->nf*sizeof *terms), least;
	int f, k;

	if (!terms)
		return SPD_ENOMEM;
	for (f = 0; f < t->nf; f++)
		terms[f] = term(m, f);
	least = worst_terms(terms, t->nf, most, terms + t->nf);
	memset(marked, 0, t->ne);
	for (f = 0; f < t->nf; f++) {
		double l0 = intrinsic_length(t, 3*f), l1 = intrinsic_length(t, 3*f + 1);
		double longest = fmax(l0, fmax(l1, intrinsic_length(t, 3*f + 2)));

		for (k = 0; k < 3 && terms[f] >= least && longest > INTRINSIC_SHORTEST; k++)
			if (intrinsic_length(t, 3*f + k) >= longest*(1 - EQUAL))
				marked[t->edge[3*f+k]] = 1;
	}
	free(terms);
	return 0;
}

/* Splits the edges that mark_worst marks.  Returns the number of new vertices, or SPD_ENOMEM. */
static int
split_worst(IntrinsicMap *m, int most)
{
	unsigned char *marked = malloc(m->s.t.ne);
	EdgePoints points = { NULL, 0, 0 };
	int n = marked ? mark_worst(m, most, marked) : SPD_ENOMEM;

	if (!n)
		n = edgepoints_middles(&m->s.t, &m->s.mesh.d, marked, &points);
	if (!n && points.n > 0)
		n = embed_add(&m->s, &points);
	free(marked);
	free(points.point);
	return n < 0 ? SPD_ENOMEM : n;
}

/* Whether there are about as many vertices as allowed, or as many crossings, which become vertices
 * of the overlay. */
static int
is_full(const Intrinsic *t, int most)
{
	size_t crossings = 0;
	int e;

	for (e = 0; e < t->ne; e++)
		crossings += t->crossings[e];
	return t->nv >= FULL*most || crossings >= INTRINSICMAP_CROSSINGS*(size_t)most;
}

/* Splits and solves until the certificate is small enough, or no more vertices may be added. */
static int
refine(IntrinsicMap *m, const AdaptOptions *o, SpdReport *report)
{
	int e = 0, n = 1;

	while (!e && n > 0 && m->certificate > o->tolerance && !is_full(&m->s.t, o->most)) {
		n = split_worst(m, o->most - m->s.t.nv);
		e = n < 0 ? SPD_ENOMEM : 0;
		if (n > 0) {
			e = embed(&m->s, o->most) ? SPD_ENOMEM : 0;
			if (!e)
				e = intrinsic_solve(m, report);
		}
	}
	return e;
}

int
intrinsic_map(const Disk *d, const int vertex[4], const AdaptOptions *o, IntrinsicMap *m,
	SpdReport *report)
{
	int e;

	memset(m, 0, sizeof *m);
	memset(report, 0, sizeof *report);
	e = embed_init(&m->s, d, vertex) || embed(&m->s, o->most) ? SPD_ENOMEM : intrinsic_solve(m, report);
	if (!e)
		e = refine(m, o, report);
	if (!e)
		m->full = is_full(&m->s.t, o->most);
	if (!e && o->split > 0 && m->s.t.nv <= o->most/4)
		e = intrinsic_solve_quadratic(m, report);
	if (e)
		intrinsic_map_free(m);
	return e;
}

void
intrinsic_map_free(IntrinsicMap *m)
{
	embed_free(&m->s);
	free(m->u);
	free(m->v);
	m->u = m->v = NULL;
}
