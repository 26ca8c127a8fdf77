/* collapse.c - moves vertices to one place. */
#include <math.h>
#include <string.h>

#include "collapse.h"

static const double FARTHEST = 1e-6;    /* of the width of the rectangle: a hundredth of a pixel of a
                                         * texture of 10 000 pixels */

static double
apart(const Tangle *t, int i, int j)
{
	const double *x = &t->p[2*(size_t)i], *y = &t->p[2*(size_t)j];

	return hypot(x[0] - y[0], x[1] - y[1]);
}

/* Puts the ends of the shortest edge of triangle f into queue.  Returns its length. */
static double
shortest_edge(Tangle *t, int f)
{
	const int *c = &t->d->m.tri[3*(size_t)f];
	int k, least = 0;

	for (k = 1; k < 3; k++)
		if (apart(t, c[k], c[(k+1)%3]) < apart(t, c[least], c[(least+1)%3]))
			least = k;
	t->queue[0] = c[least];
	t->queue[1] = c[(least+1)%3];
	return apart(t, t->queue[0], t->queue[1]);
}

/* Adds to queue[0..1] all vertices at most `distance` away from queue[0] that are connected to these
 * two through such vertices.  Returns the length of the queue. */
static int
cluster(Tangle *t, double distance)
{
	int n = 2, q, s, k, i;

	t->ball[t->queue[0]] = t->ball[t->queue[1]] = 1;
	for (q = 0; q < n; q++)
		for (s = t->star.first[t->queue[q]]; s < t->star.first[t->queue[q]+1]; s++)
			for (k = 0; k < 3; k++) {
				i = t->d->m.tri[t->star.side[s]/3*3 + k];
				if (!t->ball[i] && apart(t, i, t->queue[0]) <= distance) {
					t->ball[i] = 1;
					t->queue[n++] = i;
				}
			}
	tangle_clear(t, n);
	return n;
}

/* The vertex of queue[0..n-1] to whose place all others are moved: one that lies on every side of the
 * rectangle that any of them lies on; -1 if there is none. */
static int
centre(const Tangle *t, int n)
{
	int k, sides = 0;

	for (k = 0; k < n; k++)
		sides |= t->side[t->queue[k]];
	for (k = 0; k < n; k++)
		if (t->side[t->queue[k]] == sides)
			return t->queue[k];
	return -1;
}

/* Whether a triangle at queue[0..n-1] is bad with the places p. */
static int
any_bad(const Tangle *t, const double *p, int n)
{
	int k;

	for (k = 0; k < n; k++)
		if (tangle_star(t, p, t->queue[k]) > 0)
			return 1;
	return 0;
}

/* Moves queue[0..n-1] to one place.  Returns 1 if then no triangle at these vertices is bad; otherwise
 * restores their places and returns 0. */
static int
collapse_cluster(Tangle *t, int n)
{
	int k, done, i = centre(t, n);

	if (i < 0)
		return 0;
	for (k = 0; k < n; k++)
		memcpy(&t->e[2*(size_t)t->queue[k]], &t->p[2*(size_t)t->queue[k]], 2*sizeof *t->e);
	for (k = 0; k < n; k++)
		memcpy(&t->p[2*(size_t)t->queue[k]], &t->e[2*(size_t)i], 2*sizeof *t->p);
	done = !any_bad(t, t->p, n);
	for (k = 0; !done && k < n; k++)
		memcpy(&t->p[2*(size_t)t->queue[k]], &t->e[2*(size_t)t->queue[k]], 2*sizeof *t->p);
	return done;
}

void
collapse(Tangle *t)
{
	double distance;
	int f, done;

	for (f = 0; f < t->d->m.nf; f++) {
		if (!tangle_bad(t, t->p, f))
			continue;
		distance = shortest_edge(t, f);
		for (done = 0; !done && distance <= FARTHEST/2; distance *= 2)
			done = collapse_cluster(t, cluster(t, distance));
	}
}
