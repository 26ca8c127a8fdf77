/* mollify.c - lengthens the shortest edges of flat triangles. */
#include <math.h>
#include <stdlib.h>

#include "mollify.h"

static const double THIN = 1e-13;       /* two sides together exceed the third by at least this
                                         * times the shortest */
enum { PASSES = 100 };                  /* rounds of mollification, at most */
static const double EQUAL = 1e-6;       /* relative difference of two lengths that differ by rounding
                                         * only */

/* Sets *low to the length of the shortest edge of triangle f.  Returns the length by which this edge
 * must grow; at most 0 if it is long enough. */
static double
shortfall(const Intrinsic *t, int f, double *low)
{
	double sum = 0, high = 0;
	int k;

	*low = HUGE_VAL;
	for (k = 0; k < 3; k++) {
		double l = intrinsic_length(t, 3*f + k);

		sum += l;
		high = fmax(high, l);
		*low = fmin(*low, l);
	}
	return THIN**low - (sum - 2*high);
}

/* The triangles to look at and the edges to lengthen, each at most once. */
typedef struct Mollifier {
	int           *face, faces, *edge, edges;
	unsigned char *on;      /* [nf] 1 if the triangle is in face */
	double        *more;    /* [ne] the length to be added to each edge, 0 if it is not in edge */
} Mollifier;

static void
look_at(Mollifier *m, int side)
{
	if (side < 0 || m->on[side/3])
		return;
	m->on[side/3] = 1;
	m->face[m->faces++] = side/3;
}

/* Lists the shortest edge of each listed triangle in which it is too short; if several edges are
 * shortest up to rounding, all of them. */
static void
find_short_edges(const Intrinsic *t, Mollifier *m)
{
	int i, k;

	for (m->edges = 0, i = 0; i < m->faces; i++) {
		int f = m->face[i];
		double low, need = shortfall(t, f, &low);

		m->on[f] = 0;
		for (k = 0; k < 3 && need > 0; k++) {
			int e = t->edge[3*f+k];

			if (t->length[e] > low*(1 + EQUAL))
				continue;
			if (m->more[e] == 0)
				m->edge[m->edges++] = e;
			m->more[e] = fmax(m->more[e], need);
		}
	}
}

/* Lengthens the listed edges, and lists the triangles at them. */
static void
lengthen(Intrinsic *t, Mollifier *m)
{
	int i;

	for (m->faces = 0, i = 0; i < m->edges; i++) {
		int e = m->edge[i];

		t->length[e] += m->more[e]*(1 + THIN);
		m->more[e] = 0;
		look_at(m, t->side[e]);
		look_at(m, t->twin[t->side[e]]);
	}
	for (i = 0; i < m->faces; i++)
		intrinsic_set_by_lengths(t, m->face[i]);
}

int
intrinsic_mollify(Intrinsic *t)
{
	Mollifier m = { malloc(t->nf*sizeof *m.face), 0, malloc(t->ne*sizeof *m.edge), 0, calloc(t->nf, 1),
		calloc(t->ne, sizeof *m.more) };
	int k, f, e = INTRINSIC_ENOMEM;

	if (m.face && m.edge && m.on && m.more) {
		for (f = 0; f < t->nf; f++)
			look_at(&m, 3*f);
		for (k = 0; k < PASSES && m.faces > 0; k++) {
			find_short_edges(t, &m);
			lengthen(t, &m);
		}
		e = 0;
	}
	free(m.face);
	free(m.edge);
	free(m.on);
	free(m.more);
	return e;
}
