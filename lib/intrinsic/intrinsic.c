/* intrinsic.c - lengths and angles of an intrinsic triangulation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "intrinsic.h"

static const double THIN = 1e-13;       /* two sides together exceed the third by at least this
                                         * times the shortest */
enum { PASSES = 100 };                  /* rounds of mollification, at most */
static const double EQUAL = 1e-6;       /* relative difference of two lengths that differ by rounding
                                         * only */
static const double STEEPEST = 1e10;    /* largest cotangent: beside a larger one, the others in its
                                         * row of the matrix would vanish in rounding */

static int
allocate(Intrinsic *t)
{
	size_t sides = 3*(size_t)t->nf, ne = t->ne;

	t->from = malloc(sides*sizeof *t->from);
	t->twin = malloc(sides*sizeof *t->twin);
	t->edge = malloc(sides*sizeof *t->edge);
	t->side = malloc(ne*sizeof *t->side);
	t->length = malloc(ne*sizeof *t->length);
	t->area = malloc(t->nf*sizeof *t->area);
	t->mesh_side = malloc(ne*sizeof *t->mesh_side);
	t->mesh_from = malloc(ne*sizeof *t->mesh_from);
	t->along = malloc(ne*sizeof *t->along);
	t->crossing = calloc(ne, sizeof *t->crossing);
	t->crossings = calloc(ne, sizeof *t->crossings);
	return t->from && t->twin && t->edge && t->side && t->length && t->area && t->mesh_side && t->mesh_from
	    && t->along && t->crossing && t->crossings ? 0 : INTRINSIC_ENOMEM;
}

/* Numbers the edges in increasing order of their lower-numbered sides. */
static void
number_edges(Intrinsic *t)
{
	int h, e = 0;

	for (h = 0; h < 3*t->nf; h++) {
		if (t->twin[h] >= 0 && t->twin[h] < h) {
			t->edge[h] = t->edge[t->twin[h]];
			continue;
		}
		t->side[e] = t->mesh_side[e] = h;
		t->mesh_from[e] = t->from[h];
		t->along[e] = e;
		t->edge[h] = e++;
	}
}

/* The area of triangle f by its lengths. */
static double
area_by_lengths(const Intrinsic *t, int f)
{
	return intrinsic_area(intrinsic_length(t, 3*f), intrinsic_length(t, 3*f + 1), intrinsic_length(t, 3*f + 2));
}

/* The area of triangle f, with its sides in units of `longest`, as the cross product of its two shorter sides:
 * the rounding errors are then smallest. */
static double
area_by_places(const Intrinsic *t, const Mesh *m, int f, double longest)
{
	double l[3], x[3], y[3], n[3];
	const double *corner[3];
	int k, at;

	for (k = 0; k < 3; k++) {
		l[k] = intrinsic_length(t, 3*f + k);
		corner[k] = &m->xyz[3*(size_t)t->from[3*f + k]];
	}
	at = l[0] >= l[1] && l[0] >= l[2] ? 2 : l[1] >= l[2] ? 0 : 1;
	sub3(corner[(at+1)%3], corner[at], x);
	sub3(corner[(at+2)%3], corner[at], y);
	for (k = 0; k < 3; k++)
		x[k] /= longest, y[k] /= longest;
	cross3(x, y, n);
	return hypot(hypot(n[0], n[1]), n[2])/2;
}

/* Sets the lengths and areas, in the metric (3) of the mesh, in units of the longest edge. */
static void
measure(Intrinsic *t, const Mesh *m)
{
	double longest = 0;
	int e, f;

	for (e = 0; e < t->ne; e++) {
		int h = t->side[e];
		double x[3];

		sub3(&m->xyz[3*(size_t)t->from[h]], &m->xyz[3*(size_t)t->from[intrinsic_next(h)]], x);
		t->length[e] = hypot(hypot(x[0], x[1]), x[2]);
		longest = fmax(longest, t->length[e]);
	}
	for (e = 0; e < t->ne; e++)
		t->length[e] = fmax(t->length[e]/longest, INTRINSIC_FINEST);
	for (f = 0; f < t->nf; f++)
		t->area[f] = area_by_places(t, m, f, longest);
}

int
intrinsic_init(Intrinsic *t, const Disk *d)
{
	size_t sides = 3*(size_t)d->m.nf;

	*t = (Intrinsic){ .nv = d->m.nv, .nf = d->m.nf, .ne = (sides + d->nb)/2 };
	if (allocate(t)) {
		intrinsic_free(t);
		return INTRINSIC_ENOMEM;
	}
	memcpy(t->from, d->m.tri, sides*sizeof *t->from);
	memcpy(t->twin, d->twin, sides*sizeof *t->twin);
	number_edges(t);
	measure(t, &d->m);
	return 0;
}

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
		t->area[m->face[i]] = area_by_lengths(t, m->face[i]);
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

void
intrinsic_free(Intrinsic *t)
{
	int e;

	for (e = 0; t->crossing && e < t->ne; e++)
		free(t->crossing[e]);
	free(t->from);
	free(t->twin);
	free(t->edge);
	free(t->side);
	free(t->length);
	free(t->area);
	free(t->mesh_side);
	free(t->mesh_from);
	free(t->along);
	free(t->crossing);
	free(t->crossings);
	*t = (Intrinsic){ 0 };
}

double
intrinsic_area(double a, double b, double c)
{
	double s;

	if (a < b)
		s = a, a = b, b = s;
	if (a < c)
		s = a, a = c, c = s;
	if (b < c)
		s = b, b = c, c = s;
	s = (a + (b + c))*(c - (a - b))*(c + (a - b))*(a + (b - c));
	return s > 0 ? sqrt(s)/4 : 0;
}

void
intrinsic_cotangent_parts(const Intrinsic *t, int h, double *above, double *below)
{
	double c = intrinsic_length(t, h);
	double a = intrinsic_length(t, intrinsic_next(h)), b = intrinsic_length(t, intrinsic_last(h));

	*above = a*a + (b - c)*(b + c);
	*below = 4*t->area[h/3];
}

double
intrinsic_cotangent(const Intrinsic *t, int side)
{
	double above, below;

	intrinsic_cotangent_parts(t, side, &above, &below);
	if (fabs(above) < STEEPEST*below)
		return above/below;
	return above < 0 ? -STEEPEST : STEEPEST;
}

double
intrinsic_foot(const Intrinsic *t, int side, double *height)
{
	double c = intrinsic_length(t, side);
	double a = intrinsic_length(t, intrinsic_next(side)), b = intrinsic_length(t, intrinsic_last(side));

	*height = 2*t->area[side/3]/c;
	return (b*b + (c - a)*(c + a))/(2*c);
}
