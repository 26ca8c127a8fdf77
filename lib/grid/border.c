/* border.c - the boundary curve of a grid. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "border.h"
#include "../base/vec3.h"

int
border_count(Chart g)
{
	return g.kind->folded ? g.nu : 2*(g.nu - 1) + 2*(g.nv - 1);
}

int
border_number(Chart g, int i, int j)
{
	if (g.kind->folded)
		return j == g.nv - 1 ? g.nu - 1 - i : -1;
	return i == 0 || j == 0 || i == g.nu - 1 || j == g.nv - 1 ? border_index(g.nu, g.nv, i, j) : -1;
}

int
border_init(Border *b, Chart g)
{
	int n = border_count(g);

	*b = (Border){ g, n, malloc(3*(size_t)n*sizeof(double)), malloc((n + 1)*sizeof(double)) };
	if (b->x && b->s)
		return 0;
	border_free(b);
	return BORDER_ENOMEM;
}

void
border_free(Border *b)
{
	free(b->x);
	free(b->s);
	memset(b, 0, sizeof *b);
}

int
border_measure(Border *b)
{
	const double *p, *q;
	int k;

	b->s[0] = 0;
	for (k = 0; k < b->n; k++) {
		p = b->x + 3*k;
		q = b->x + 3*((k + 1)%b->n);
		b->s[k+1] = b->s[k] + hypot(hypot(q[0] - p[0], q[1] - p[1]), q[2] - p[2]);
	}
	return b->s[b->n] > 0 && b->s[b->n] < HUGE_VAL ? 0 : BORDER_ELENGTH;
}

void
border_node(int nu, int nv, int k, int *i, int *j)
{
	int a = nu - 1, b = nv - 1;

	if (k < a)
		*i = k, *j = 0;
	else if (k < a + b)
		*i = a, *j = k - a;
	else if (k < 2*a + b)
		*i = 2*a + b - k, *j = b;
	else
		*i = 0, *j = 2*a + 2*b - k;
}

int
border_index(int nu, int nv, int i, int j)
{
	int a = nu - 1, b = nv - 1;

	if (j == 0)
		return i;
	if (i == a)
		return a + j;
	if (j == b)
		return 2*a + b - i;
	return 2*a + 2*b - j;
}

/* Returns the first node of a side of a rectangle; *edges is how many edges the side has. */
static int
side(const Border *b, int number, int *edges)
{
	*edges = number%2 ? b->g.nv - 1 : b->g.nu - 1;
	return number/2*(b->n/2) + number%2*(b->g.nu - 1);
}

double
border_place(const Border *b, int k)
{
	int number, first, edges;

	if (b->g.kind->folded)
		return 4.0*k/b->n;
	for (number = 3; number > 0 && side(b, number, &edges) > k; number--)
		;
	first = side(b, number, &edges);
	return number + (double)(k - first)/edges;
}

int
border_edge(const Border *b, double r, double *w)
{
	int number = r < 3 ? (int)r : 3, edges, first = side(b, number, &edges), k;

	if (b->g.kind->folded) {
		k = (int)fmin(floor(r/4*b->n), b->n - 1);
		*w = fmin(r/4*b->n - k, 1);
		return k;
	}
	k = (int)fmin(floor((r - number)*edges), edges - 1);
	*w = fmin((r - number)*edges - k, 1);
	return first + k;
}

void
border_at(const Border *b, double r, double x[3])
{
	double w;
	int k = border_edge(b, r, &w), c;
	const double *p = b->x + 3*k, *q = b->x + 3*((k + 1)%b->n);

	for (c = 0; c < 3; c++)
		x[c] = (1 - w)*p[c] + w*q[c];
}

double
border_arc(const Border *b, double r)
{
	double w;
	int k = border_edge(b, r, &w);

	return (1 - w)*b->s[k] + w*b->s[k+1];
}

/* The w in 0 .. 1 for which p + w (q - p) is the point of the edge pq nearest to x.  length is
 * |q - p|. */
static double
nearest_share(const double p[3], const double q[3], const double x[3], double length)
{
	double e[3], d[3], w = 0;
	int c;

	if (!(length > 0))
		return 0;
	for (c = 0; c < 3; c++) {
		e[c] = (q[c] - p[c])/length;
		d[c] = (x[c] - p[c])/length;
	}
	w = dot3(e, d);
	return w > 0 ? fmin(w, 1) : 0;
}

double
border_nearest(const Border *b, const double x[3], double *d)
{
	double place = 0, w, r;
	const double *p, *q;
	int k;

	*d = HUGE_VAL;
	for (k = 0; k < b->n; k++) {
		p = b->x + 3*k;
		q = b->x + 3*((k + 1)%b->n);
		w = nearest_share(p, q, x, b->s[k+1] - b->s[k]);
		r = hypot(hypot(p[0] + w*(q[0] - p[0]) - x[0], p[1] + w*(q[1] - p[1]) - x[1]),
		    p[2] + w*(q[2] - p[2]) - x[2]);
		if (r < *d) {
			*d = r;
			place = (1 - w)*border_place(b, k) + w*border_place(b, k + 1);
		}
	}
	return place < 4 ? place : 0;
}
