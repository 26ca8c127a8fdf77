/* intrinsic.c - lengths and angles of an intrinsic triangulation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../mesh/supports.h"
#include "intrinsic.h"

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
	t->dot = malloc(sides*sizeof *t->dot);
	t->mesh_side = malloc(ne*sizeof *t->mesh_side);
	t->mesh_from = malloc(ne*sizeof *t->mesh_from);
	t->along = malloc(ne*sizeof *t->along);
	t->crossing = calloc(ne, sizeof *t->crossing);
	t->crossings = calloc(ne, sizeof *t->crossings);
	return t->from && t->twin && t->edge && t->side && t->length && t->area && t->dot && t->mesh_side
	    && t->mesh_from && t->along && t->crossing && t->crossings ? 0 : INTRINSIC_ENOMEM;
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

void
intrinsic_set_by_lengths(Intrinsic *t, int f)
{
	double l[3];
	int k;

	for (k = 0; k < 3; k++)
		l[k] = intrinsic_length(t, 3*f + k);
	t->area[f] = intrinsic_area(l[0], l[1], l[2]);
	for (k = 0; k < 3; k++) {
		double a = l[k], b = l[(k+2)%3], c = l[(k+1)%3];

		t->dot[3*f+k] = (a*a + (b - c)*(b + c))/2;
	}
}

/* The disk that is measured.  If it is a subdivision, steps between vertices are computed by their
 * supports. */
typedef struct Measured {
	const Disk        *d;
	const Subdivision *s;           /* or NULL */
	const Support     *support;     /* of s */
} Measured;

/* The step in R^3 from vertex i to vertex j of one triangle. */
static void
step(const Measured *m, int i, int j, double x[3])
{
	if (m->s)
		support_step(m->s, m->support, i, j, x);
	else
		sub3(&m->d->m.xyz[3*(size_t)j], &m->d->m.xyz[3*(size_t)i], x);
}

/* Sets the area and the dot products of triangle f, with its sides in units of `longest`, by its two shorter
 * sides x and y: the rounding errors are then smallest. */
static void
set_by_steps(Intrinsic *t, const Measured *m, int f, double longest)
{
	double l[3], x[3], y[3], n[3], xy;
	const int *corner = &t->from[3*f];
	int k, at, next, last;

	for (k = 0; k < 3; k++)
		l[k] = intrinsic_length(t, 3*f + k);
	at = l[0] >= l[1] && l[0] >= l[2] ? 2 : l[1] >= l[2] ? 0 : 1;
	next = (at+1)%3, last = (at+2)%3;
	step(m, corner[at], corner[next], x);
	step(m, corner[at], corner[last], y);
	for (k = 0; k < 3; k++)
		x[k] /= longest, y[k] /= longest;
	cross3(x, y, n);
	t->area[f] = hypot(hypot(n[0], n[1]), n[2])/2;
	t->dot[3*f+at] = xy = dot3(x, y);
	t->dot[3*f+next] = dot3(x, x) - xy;
	t->dot[3*f+last] = dot3(y, y) - xy;
}

/* Whether a side of triangle f was lengthened to INTRINSIC_FINEST. */
static int
is_finest(const Intrinsic *t, int f)
{
	int k;

	for (k = 0; k < 3 && intrinsic_length(t, 3*f + k) > INTRINSIC_FINEST; k++)
		;
	return k < 3;
}

/* Sets the lengths, areas and dot products, in the metric (3) of the mesh, in units of the longest edge. */
static void
measure(Intrinsic *t, const Measured *m)
{
	double longest = 0;
	int e, f;

	for (e = 0; e < t->ne; e++) {
		int h = t->side[e];
		double x[3];

		step(m, t->from[intrinsic_next(h)], t->from[h], x);
		t->length[e] = hypot(hypot(x[0], x[1]), x[2]);
		longest = fmax(longest, t->length[e]);
	}
	for (e = 0; e < t->ne; e++)
		t->length[e] = fmax(t->length[e]/longest, INTRINSIC_FINEST);
	for (f = 0; f < t->nf; f++)
		if (is_finest(t, f))
			intrinsic_set_by_lengths(t, f);
		else
			set_by_steps(t, m, f, longest);
}

static int
init(Intrinsic *t, const Measured *m)
{
	const Disk *d = m->d;
	size_t sides = 3*(size_t)d->m.nf;

	*t = (Intrinsic){ .nv = d->m.nv, .nf = d->m.nf, .ne = (sides + d->nb)/2 };
	if (allocate(t)) {
		intrinsic_free(t);
		return INTRINSIC_ENOMEM;
	}
	memcpy(t->from, d->m.tri, sides*sizeof *t->from);
	memcpy(t->twin, d->twin, sides*sizeof *t->twin);
	number_edges(t);
	measure(t, m);
	return 0;
}

int
intrinsic_init(Intrinsic *t, const Disk *d)
{
	return init(t, &(Measured){ d, NULL, NULL });
}

int
intrinsic_init_subdivision(Intrinsic *t, const Subdivision *s)
{
	Support *support = supports(s);
	int e = support ? init(t, &(Measured){ &s->d, s, support }) : INTRINSIC_ENOMEM;

	if (!support)
		*t = (Intrinsic){ 0 };
	free(support);
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
	free(t->dot);
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
	*above = 2*t->dot[intrinsic_last(h)];
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
	double length = intrinsic_length(t, side);

	*height = 2*t->area[side/3]/length;
	return t->dot[side]/length;
}
