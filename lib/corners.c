/* corners.c - corners of the quadrilateral. */
#include <stdlib.h>

#include "corners.h"
#include "vec3.h"

static const double REACH = 1.0/40;             /* of the loop, for chords */
static const double APART = 1.0/20;             /* of the loop, between corners */
static const double CLEAR = 50*M_PI/180;        /* least turn of a corner */
static const double NEXT = 0.6;                 /* most turn of the fifth, of the fourth's */

/* The boundary by arc length: s[i] from the start to loop vertex i, s[nb] the whole. */
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

/* The point reached by walking so far along the boundary from loop vertex i, forward
 * (step 1) or back (-1). */
static void
walk(const Disk *d, const double *s, int i, int step, double reach, double x[3])
{
	int next = i, k, c;
	double edge = 0, w;

	for (k = 0; k < d->nb; k++, reach -= edge, i = next) {
		next = (i + step + d->nb)%d->nb;
		edge = step > 0 ? s[i+1] - s[i] : s[next+1] - s[next];
		if (edge > reach)
			break;
	}
	w = edge > 0 ? reach/edge : 0;
	for (c = 0; c < 3; c++)
		x[c] = (1 - w)*d->m.xyz[3*d->loop[i] + c] + w*d->m.xyz[3*d->loop[next] + c];
}

/* Angle by which the boundary turns at loop vertex i, 0 .. pi. */
static double
turn(const Disk *d, const double *s, int i)
{
	double back[3], forth[3], a[3], b[3], c[3];
	const double *x = &d->m.xyz[3*d->loop[i]];

	walk(d, s, i, -1, REACH*s[d->nb], back);
	walk(d, s, i, 1, REACH*s[d->nb], forth);
	sub3(x, back, a);
	sub3(forth, x, b);
	cross3(a, b, c);
	return atan2(norm3(c), dot3(a, b));
}

static double
apart(const double *s, int nb, int i, int j)
{
	double t = fabs(s[i] - s[j]);

	return fmin(t, s[nb] - t)/s[nb];
}

/* The vertex of the largest turn that is farther than APART from the k chosen, or -1. */
static int
sharpest(const double *s, int nb, const double *angle, const int *chosen, int k)
{
	int i, j, best = -1;

	for (i = 0; i < nb; i++) {
		for (j = 0; j < k && apart(s, nb, i, chosen[j]) > APART; j++)
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

/* Four clear corners in the order of the loop: 1, or 0 when there are none. */
static int
clear_corners(const double *s, int nb, const double *angle, int corner[4])
{
	int chosen[5], k;

	for (k = 0; k < 5; k++) {
		chosen[k] = sharpest(s, nb, angle, chosen, k);
		if (k < 4 && (chosen[k] < 0 || angle[chosen[k]] < CLEAR))
			return 0;
	}
	if (chosen[4] >= 0 && angle[chosen[4]] > NEXT*angle[chosen[3]])
		return 0;
	qsort(chosen, 4, sizeof *chosen, ascending);
	for (k = 0; k < 4; k++)
		corner[k] = chosen[k];
	if (apart(s, nb, 0, corner[3]) < apart(s, nb, 0, corner[0])) {
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

int
corners_auto(const Disk *d, int corner[4])
{
	double *s = arc_length(d), *angle = malloc(d->nb*sizeof *angle);
	int i, found = CORNERS_ENOMEM;

	if (s && angle) {
		for (i = 0; i < d->nb; i++)
			angle[i] = turn(d, s, i);
		found = clear_corners(s, d->nb, angle, corner);
		if (!found)
			equal_arcs(s, d->nb, corner);
	}
	free(s);
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
