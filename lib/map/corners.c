/* corners.c - finds the corners by the turning angles of the boundary. */
#include <stdlib.h>

#include "corners.h"
#include "../base/vec3.h"

static const double REACH = 1.0/40;             /* first reach (corners.h) / length of the loop */
static const double SHORT = 1.5;                /* shortest reach, in mean edge lengths */
static const double CLEAR = 50*M_PI/180;        /* least turning angle of a corner */
static const double NEXT = 0.6;                 /* largest ratio of the fifth turn to the fourth */

/* Arc length along the boundary: s[i] at loop vertex i, measured from the start of the loop; s[nb] is
 * the length of the loop. */
static double *
arc_length(const Disk *d)
{
	double *s = malloc((d->nb + 1)*sizeof *s), e[3];
	int i;

	if (!s)
		return NULL;
	s[0] = 0;
	for (i = 0; i < d->nb; i++) {
		sub3(&d->m.xyz[3*d->loop[(i + 1)%d->nb]], &d->m.xyz[3*d->loop[i]], e);
		s[i+1] = s[i] + norm3(e);
	}
	return s;
}

static void
scaled_sub3(const double a[3], const double b[3], double scale, double c[3])
{
	int k;

	sub3(a, b, c);
	for (k = 0; k < 3; k++)
		c[k] *= scale;
}

/* Adds the normal of face t, times twice its area in units of unit^2, to n at its corners. */
static void
add_normal(const Mesh *m, const int *t, double unit, double *n)
{
	double a[3], b[3], c[3];
	int i, k;

	scaled_sub3(&m->xyz[3*t[1]], &m->xyz[3*t[0]], 1/unit, a);
	scaled_sub3(&m->xyz[3*t[2]], &m->xyz[3*t[0]], 1/unit, b);
	cross3(a, b, c);
	for (i = 0; i < 3; i++)
		for (k = 0; k < 3; k++)
			n[3*t[i] + k] += c[k];
}

/* At each vertex of the loop, the sum of the normals of its faces, weighted by area: [nv][3].  The
 * unit of length is the length of the loop, here and in turn(), so that no product overflows. */
static double *
boundary_normals(const Disk *d, double unit)
{
	double *n = calloc(d->m.nv, 3*sizeof *n);
	char *outer = calloc(d->m.nv, 1);
	int f, i;

	for (i = 0; outer && i < d->nb; i++)
		outer[d->loop[i]] = 1;
	for (f = 0; n && outer && f < d->m.nf; f++) {
		const int *t = &d->m.tri[3*f];

		if (outer[t[0]] | outer[t[1]] | outer[t[2]])
			add_normal(&d->m, t, unit, n);
	}
	if (!outer) {
		free(n);
		n = NULL;
	}
	free(outer);
	return n;
}

/* The point x of the boundary at arc length a; -L < a < 2L, where L is the length of the loop. */
static void
point(const Disk *d, const double *s, double a, double x[3])
{
	int lo = 0, hi = d->nb, mid, c;
	const double *p, *q;
	double w;

	a += a < 0 ? s[d->nb] : a > s[d->nb] ? -s[d->nb] : 0;
	while (hi - lo > 1)
		if (s[mid = (lo + hi)/2] <= a)
			lo = mid;
		else
			hi = mid;
	p = &d->m.xyz[3*d->loop[lo]];
	q = &d->m.xyz[3*d->loop[hi%d->nb]];
	w = s[hi] > s[lo] ? (a - s[lo])/(s[hi] - s[lo]) : 0;
	for (c = 0; c < 3; c++)
		x[c] = (1 - w)*p[c] + w*q[c];
}

/* The turn of the boundary at loop vertex i (corners.h), -pi .. pi.  reach is in units of the
 * length of the loop; n is the normal there, of any length. */
static double
turn(const Disk *d, const double *s, int i, double reach, const double n[3])
{
	double back[3], forth[3], a[3], b[3], c[3];
	const double *x = &d->m.xyz[3*d->loop[i]];

	point(d, s, s[i] - reach*s[d->nb], back);
	point(d, s, s[i] + reach*s[d->nb], forth);
	scaled_sub3(x, back, 1/s[d->nb], a);
	scaled_sub3(forth, x, 1/s[d->nb], b);
	cross3(a, b, c);
	return copysign(atan2(norm3(c), dot3(a, b)), dot3(c, n));
}

/* Distance along the loop from vertex i to arc length a, by the shorter of the two ways, divided by
 * the length of the loop. */
static double
loop_distance(const double *s, int nb, int i, double a)
{
	double t = fabs(s[i] - a);

	return fmin(t, s[nb] - t)/s[nb];
}

/* Of the loop vertices farther than `far` from all k chosen ones, the one with the largest turn; or
 * -1. */
static int
sharpest(const double *s, int nb, const double *angle, double far, const int *chosen, int k)
{
	int i, j, best = -1;

	for (i = 0; i < nb; i++) {
		for (j = 0; j < k && loop_distance(s, nb, i, s[chosen[j]]) > far; j++)
			;
		if (j == k && (best < 0 || angle[i] > angle[best]))
			best = i;
	}
	return best;
}

static int
ascending(const void *a, const void *b)
{
	int x = *(const int *)a, y = *(const int *)b;

	return (x > y) - (x < y);
}

/* Finds four clear corners, in the order of the loop.  Returns 1, or 0 if there are fewer. */
static int
clear_corners(const double *s, int nb, const double *angle, double far, int corner[4])
{
	int chosen[5], k;

	for (k = 0; k < 5; k++) {
		chosen[k] = sharpest(s, nb, angle, far, chosen, k);
		if (k < 4 && (chosen[k] < 0 || angle[chosen[k]] < CLEAR))
			return 0;
	}
	if (chosen[4] >= 0 && angle[chosen[4]] > NEXT*angle[chosen[3]])
		return 0;
	qsort(chosen, 4, sizeof *chosen, ascending);
	for (k = 0; k < 4; k++)
		corner[k] = chosen[k];
	if (loop_distance(s, nb, 0, s[corner[3]]) < loop_distance(s, nb, 0, s[corner[0]])) {
		for (k = 3; k > 0; k--)
			corner[k] = chosen[k-1];
		corner[0] = chosen[3];
	}
	return 1;
}

static void
equal_arcs(const double *s, int nb, int corner[4])
{
	int k, i = 0;

	for (k = 0; k < 4; k++) {
		double t = k*s[nb]/4;

		i = k ? corner[k-1] + 1 : 0;
		while (i + 1 < nb - (3 - k) && fabs(s[i+1] - t) < fabs(s[i] - t))
			i++;
		corner[k] = i;
	}
}

/* Finds four clear corners, at the first reach that has them.  Returns 1, or 0 if none has. */
static int
by_shape(const Disk *d, const double *s, const double *n, double *angle, int corner[4])
{
	double reach;
	int i, found = 0;

	for (reach = REACH; !found && (reach == REACH || reach*d->nb >= SHORT); reach *= M_SQRT1_2) {
		for (i = 0; i < d->nb; i++)
			angle[i] = turn(d, s, i, reach, &n[3*d->loop[i]]);
		found = clear_corners(s, d->nb, angle, 2*reach, corner);
	}
	return found;
}

int
corners_auto(const Disk *d, int corner[4])
{
	double *s = arc_length(d), *n = s ? boundary_normals(d, s[d->nb]) : NULL;
	double *angle = malloc(d->nb*sizeof *angle);
	int found = CORNERS_ENOMEM;

	if (d->nb < 4) {
		found = CORNERS_EFEW;
	} else if (s && n && angle) {
		found = by_shape(d, s, n, angle, corner);
		if (!found)
			equal_arcs(s, d->nb, corner);
	}
	free(s);
	free(n);
	free(angle);
	return found;
}

int
corners_given(const Disk *d, const int vertex[4], int corner[4], int *at)
{
	int i, k, turns = 0;

	for (k = 0; k < 4; k++) {
		for (i = 0; i < d->nb && d->loop[i] != vertex[k]; i++)
			;
		if (i == d->nb) {
			*at = vertex[k];
			return CORNERS_EINNER;
		}
		corner[k] = i;
	}
	for (k = 0; k < 4; k++)
		turns += corner[(k+1)%4] <= corner[k];
	return turns == 1 ? 0 : CORNERS_EORDER;
}

/* The loop vertex nearest to arc length a. */
static int
at_length(const double *s, int nb, double a)
{
	int i, best = 0;

	for (i = 1; i < nb; i++)
		if (loop_distance(s, nb, i, a) < loop_distance(s, nb, best, a))
			best = i;
	return best;
}

int
corners_at(const Disk *d, const double place[4], int corner[4])
{
	double *s = arc_length(d);
	int k, i, last = -1, first = 0;

	if (d->nb < 4 || !s) {
		free(s);
		return d->nb < 4 ? CORNERS_EFEW : CORNERS_ENOMEM;
	}
	for (k = 0; k < 4; k++) {
		i = at_length(s, d->nb, place[k]*s[d->nb]);
		first = k ? first : i;
		i = (i - first + d->nb)%d->nb;          /* steps from the first */
		i = i > last ? i : last + 1;
		last = i < d->nb - (3 - k) ? i : d->nb - (4 - k);
		corner[k] = (first + last)%d->nb;
	}
	free(s);
	return 0;
}

int
corners_nearest(const Disk *d, const double x[3])
{
	double best = HUGE_VAL, r;
	int i, v, vertex = d->loop[0];

	for (i = 0; i < d->nb; i++) {
		const double *y = &d->m.xyz[3*(v = d->loop[i])];

		r = hypot(hypot(y[0] - x[0], y[1] - x[1]), y[2] - x[2]);
		if (r < best || (r == best && v < vertex))
			best = r, vertex = v;
	}
	return vertex;
}
