/* split.c - splits a piece of a surface graph in two by a small vertex separator.
 *
 * Let a and b be two vertices far apart, found by breadth-first searches, c a vertex far from
 * both, and d a vertex far from c.  With distances in edges,
 *
 *   f1 = dist(., a) - dist(., b),   f2 = dist(., c) - dist(., d)
 *
 * are two intrinsic coordinates of the surface; unlike cuts by planes, they are not disturbed by
 * folds.  On a square, a..d are the corners, the level lines of f1 and f2 run along the diagonals,
 * and those of f1 + f2 and f1 - f2 along the sides.  Of these four functions, the one whose median
 * level crosses the fewest edges is used.  The vertices near that level form a band that separates
 * the rest, and vertexcut.c finds the smallest separator within the band.  The two parts keep f1
 * and f2 until they are AGAIN times smaller, or have no small separator; distances kept longer
 * describe the parts of combs, spirals and rough surfaces badly.
 */
#include <math.h>
#include <stdint.h>
#include <string.h>

#include "split.h"
#include "vertexcut.h"

enum {
	BAND = 2,               /* about how many edges the band reaches to either side */
	AGAIN = 4,
	LARGE = 3,              /* a separator of up to LARGE sqrt(n) vertices is small */
	HUB = 24,               /* a hub is a vertex with more than HUB neighbours.. */
	HUB_SHARE = 4,          /* ..and more than sqrt(n)/HUB_SHARE */
	SAMPLE = 1024,          /* this many vertices suffice to find a level and its cost.. */
	STRIDE = 16             /* ..but at least one in STRIDE is used */
};

/* Sets dist to the distance in edges from vertex a, for all vertices reached from a through
 * vertices whose dist is -1.  Returns the number m of vertices reached; queue[m-1] is one of the
 * farthest. */
static int
breadth_first(const Graph *g, int a, int *dist, int *queue)
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

/* Searches component after component, from the first vertex on, until half of the vertices are
 * reached.  Returns the number reached; *last is where the last component begins in the queue. */
static int
components(const Graph *g, int *dist, int *queue, int *last)
{
	int tail = 0, v;

	memset(dist, -1, g->n*sizeof *dist);
	for (*last = 0, v = 0; 2*tail < g->n; v++)
		if (dist[v] < 0) {
			*last = tail;
			tail += breadth_first(g, v, dist, queue + tail);
		}
	return tail;
}

/* f[2*i] = dist(i, a) - dist(i, b), where b is a vertex farthest from a.  sum[i] is the sum of the
 * two distances; sum may be NULL.  work is [2*n].  g is connected. */
static void
coordinate(const Graph *g, int a, int *f, int *sum, int *work)
{
	int *dist = work, *queue = work + g->n, i;

	memset(dist, -1, g->n*sizeof *dist);
	breadth_first(g, a, dist, queue);
	for (i = 0; i < g->n; i++)
		f[2*i] = dist[i];
	a = queue[g->n - 1];
	memset(dist, -1, g->n*sizeof *dist);
	breadth_first(g, a, dist, queue);
	for (i = 0; i < g->n; i++) {
		if (sum)
			sum[i] = f[2*i] + dist[i];
		f[2*i] -= dist[i];
	}
}

/* Sets the coordinates f1 and f2 of p.  `far` is the vertex a. */
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

/* The median of value(p, i, which) over every stride-th vertex i; count is [4*n+1].  The result is
 * approximate if the values differ by more than 4*n, as they may in a piece that was connected only
 * through vertices removed since. */
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

/* The cost of splitting at a level: the number of edges, at every stride-th vertex, that cross it.
 * If the band leaves less than an eighth of the vertices on a side, the cost is higher than any
 * such number, and highest where it leaves least. */
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

/* Splits p at the cheapest of the four median levels. */
static void
split_at_level(const Piece *p, signed char *side, int *work)
{
	static const int widths[4] = { 2*BAND, 2*BAND, 3*BAND, 3*BAND };
	int stride = p->g.n/SAMPLE < STRIDE ? 1 + p->g.n/SAMPLE : STRIDE, i, x, n, level, best = 0,
		least = INT32_MAX, middle = 0;

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

/* Takes the hubs as the separator, and all other vertices as the left side; the right side is empty.
 * With hubs, f1 and f2 would be constant on large parts, because shortest paths lead through a hub.
 * Returns 0 if there is no hub, or if there are too many. */
static int
split_off_hubs(const Graph *g, signed char *side, int count[3])
{
	double most = fmax(HUB, sqrt(g->n)/HUB_SHARE);
	int i;

	for (i = 0; i < g->n; i++)
		side[i] = g->first[i+1] - g->first[i] > most ? CUT_SEPARATOR : CUT_LEFT;
	count_sides(side, g->n, count);
	return count[CUT_SEPARATOR] > 0 && count[CUT_SEPARATOR] <= sqrt(g->n);
}

/* If the graph has several components, puts whole components on each side, without a separator, and
 * returns 1.  If it has one, returns 0, and *far is a vertex far from vertex 0. */
static int
split_components(const Graph *g, signed char *side, int count[3], int *far, int *work)
{
	int *queue = work + g->n, i, n = g->n, last, reached = components(g, work, queue, &last);
	int left = last > 0 ? last : reached;

	*far = queue[reached-1];
	if (left == n)
		return 0;
	memset(side, CUT_RIGHT, n);
	for (i = 0; i < left; i++)
		side[queue[i]] = CUT_LEFT;
	count_sides(side, n, count);
	return 1;
}

/* Splits at a level of the present coordinates.  Returns 0 if the separator is not small, or if a
 * side has less than an eighth of the vertices. */
static int
split_by_coordinates(const Piece *p, signed char *side, int count[3], int *work)
{
	int n = p->g.n;

	split_at_level(p, side, work);
	count_sides(side, n, count);
	return count[CUT_LEFT] >= n/8 && count[CUT_RIGHT] >= n/8 && count[CUT_SEPARATOR] <= LARGE*sqrt(n);
}

int
split(Piece *p, signed char *side, int count[3], int *work)
{
	int n = p->g.n, far;

	if (n > p->again && split_by_coordinates(p, side, count, work))
		return 1;
	p->again = n;
	if (split_components(&p->g, side, count, &far, work) || split_off_hubs(&p->g, side, count))
		return 1;
	coordinates(p, far, work);
	return split_by_coordinates(p, side, count, work);
}
