/* part.c - splitting a piece of a surface graph in two (vertex separator).
 *
 * Where to part: a and b are two vertices as far from each other as breadth-first
 * searches find, c is far from both, d far from c.  The differences of distances in edges
 *
 *   f1 = dist(., a) - dist(., b),   f2 = dist(., c) - dist(., d)
 *
 * are two coordinates that know the surface from inside: folds do no harm, as they would
 * to cuts by planes.  On a square a..d are its corners, the level lines of f1 and f2
 * its diagonals, those of f1 + f2 and f1 - f2 parallel to its sides.  Of these four the one
 * whose median crosses the fewest edges decides; the vertices near it are a band that
 * parts the rest, and vertexcut.c finds the fewest of them that do.  The parts inherit
 * f1 and f2 until they are AGAIN times smaller.
 */
#include <stdint.h>
#include <string.h>

#include "part.h"
#include "vertexcut.h"

enum {
	BAND = 2,               /* edges that the band reaches on either side, or so */
	AGAIN = 64,
	SAMPLE = 1024,          /* vertices that are enough to tell a level's place and worth.. */
	STRIDE = 16             /* ..or one in so many, of the largest pieces */
};

/* Distances from vertex a in edges to what it reaches among vertices of dist -1.  Returns
 * how many; the last, and farthest, is queue[that - 1]. */
static int
spread(const Graph *g, int a, int *dist, int *queue)
{
	int head, tail = 0, k, j;

	dist[a] = 0;
	queue[tail++] = a;
	for (head = 0; head < tail; head++)
		for (k = g->first[queue[head]]; k < g->first[queue[head]+1]; k++)
			if (dist[j = g->adj[k]] < 0) {
				dist[j] = dist[queue[head]] + 1;
				queue[tail++] = j;
			}
	return tail;
}

/* Components from the first vertex on, until half of the vertices are reached, and where
 * in the queue the last of them begins. */
static int
components(const Graph *g, int *dist, int *queue, int *last)
{
	int tail = 0, v;

	memset(dist, -1, g->n*sizeof *dist);
	for (*last = 0, v = 0; 2*tail < g->n; v++)
		if (dist[v] < 0) {
			*last = tail;
			tail += spread(g, v, dist, queue + tail);
		}
	return tail;
}

/* f[2*i] = dist(i, a) - dist(i, b), b the farthest from a; sum, if not NULL, of the two.
 * work is [2*n].  g is connected. */
static void
coordinate(const Graph *g, int a, int *f, int *sum, int *work)
{
	int *dist = work, *queue = work + g->n, i;

	memset(dist, -1, g->n*sizeof *dist);
	spread(g, a, dist, queue);
	for (i = 0; i < g->n; i++)
		f[2*i] = dist[i];
	a = queue[g->n - 1];
	memset(dist, -1, g->n*sizeof *dist);
	spread(g, a, dist, queue);
	for (i = 0; i < g->n; i++) {
		if (sum)
			sum[i] = f[2*i] + dist[i];
		f[2*i] -= dist[i];
	}
}

static void
coordinates(Piece *p, int far, int *work)
{
	int *sum = work, i, c = 0;

	coordinate(&p->g, far, p->f, sum, work + p->g.n);
	for (i = 1; i < p->g.n; i++)
		if (sum[i] > sum[c])
			c = i;
	coordinate(&p->g, c, p->f + 1, NULL, work);
	p->again = p->g.n/AGAIN;
}

/* f1, f2, f1 + f2 or f1 - f2 of vertex i. */
static inline int
value(const Piece *p, int i, int which)
{
	static const int factor[4][2] = { { 1, 0 }, { 0, 1 }, { 1, 1 }, { 1, -1 } };

	return factor[which][0]*p->f[2*i] + factor[which][1]*p->f[2*i+1];
}

/* The median of a value over every stride-th vertex; count is [4*n].  In a part that
 * hangs together only by what was cut off values may lie farther apart than 4*n:
 * then it is one nearby. */
static int
median(const Piece *p, int which, int stride, int *count)
{
	int i, x, lo = INT32_MAX, hi = INT32_MIN, sum, half = 0, unit;

	for (i = 0; i < p->g.n; i += stride, half++) {
		x = value(p, i, which);
		lo = x < lo ? x : lo;
		hi = x > hi ? x : hi;
	}
	unit = 1 + (int)((hi - lo)/(4*(int64_t)p->g.n));
	memset(count, 0, ((hi - lo)/unit + 1)*sizeof *count);
	for (i = 0; i < p->g.n; i += stride)
		count[(value(p, i, which) - lo)/unit]++;
	for (i = 0, sum = count[0]; 2*sum < half; )
		sum += count[++i];
	return lo + i*unit;
}

/* The worth of parting at a level: how many edges at every stride-th vertex cross it; of
 * levels whose band leaves too little on a side the one that leaves most is the least
 * evil. */
static int
cost(const Piece *p, int which, int level, int width, int stride)
{
	int i, k, x, n = 0, total = 0, left = 0, right = 0;

	for (i = 0; i < p->g.n; i += stride, total++) {
		x = value(p, i, which);
		left += x < level - width;
		right += x > level + width;
		for (k = p->g.first[i]; k < p->g.first[i+1]; k++)
			n += (x <= level) != (value(p, p->g.adj[k], which) <= level);
	}
	left = left < right ? left : right;
	return left < total/8 ? INT32_MAX - left : n;
}

/* Parts p at the best of its levels. */
static void
part_level(const Piece *p, signed char *side, int *work)
{
	static const int widths[4] = { 2*BAND, 2*BAND, 3*BAND, 3*BAND };
	int stride = p->g.n/SAMPLE < STRIDE ? 1 + p->g.n/SAMPLE : STRIDE, i, x, n, level, best = 0, least = INT32_MAX, middle = 0;

	for (i = 0; i < 4; i++) {
		level = median(p, i, stride, work);
		n = cost(p, i, level, widths[i], stride);
		if (i == 0 || n < least)
			least = n, best = i, middle = level;
	}
	for (i = 0; i < p->g.n; i++) {
		x = value(p, i, best);
		side[i] = x < middle - widths[best] ? CUT_LEFT :
		    x > middle + widths[best] ? CUT_RIGHT : CUT_SEPARATOR;
	}
	vertexcut(&p->g, side, work);
}

static void
count_sides(const signed char *side, int n, int count[3])
{
	int i;

	memset(count, 0, 3*sizeof *count);
	for (i = 0; i < n; i++)
		count[(int)side[i]]++;
}

/* What always parts, if badly: the first half of the vertices and the second, those of
 * the first that touch the second between them. */
static void
part_anyhow(const Graph *g, signed char *side)
{
	int i, k;

	for (i = 0; i < g->n; i++)
		side[i] = i < g->n/2 ? CUT_LEFT : CUT_RIGHT;
	for (i = 0; i < g->n/2; i++)
		for (k = g->first[i]; k < g->first[i+1]; k++)
			if (g->adj[k] >= g->n/2)
				side[i] = CUT_SEPARATOR;
}

void
part(Piece *p, signed char *side, int count[3], int *work)
{
	int *queue = work + p->g.n, i, n = p->g.n, reached, last;

	if (n <= p->again) {
		reached = components(&p->g, work, queue, &last);
		if (reached < n || last > 0) {
			memset(side, CUT_RIGHT, n);
			for (i = 0; i < (last > 0 ? last : reached); i++)
				side[queue[i]] = CUT_LEFT;
			count_sides(side, n, count);
			return;
		}
		coordinates(p, queue[n-1], work);
	}
	part_level(p, side, work);
	count_sides(side, n, count);
	if (count[CUT_LEFT] < n/8 || count[CUT_RIGHT] < n/8) {
		part_anyhow(&p->g, side);
		count_sides(side, n, count);
	}
}
