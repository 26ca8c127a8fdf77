/* tangle.c - which triangles are turned over; balls of vertices. */
#include <math.h>

#include "tangle.h"

/* The relative error of each of the two products of an area: three roundings, of two differences and
 * of the product itself, and one of the difference of the products. */
static const double ROUNDING = 4.5e-16;

static int
equal(const double a[2], const double b[2])
{
	return a[0] == b[0] && a[1] == b[1];
}

int
tangle_bad(const Tangle *t, const double *p, int f)
{
	const int *k = &t->d->m.tri[3*(size_t)f];
	double a[2], b[2], c[2], x, y;

	tangle_image(t, p, 3*f, a);
	tangle_image(t, p, 3*f + 1, b);
	tangle_image(t, p, 3*f + 2, c);
	x = (b[0] - a[0])*(c[1] - a[1]);
	y = (c[0] - a[0])*(b[1] - a[1]);
	return !(x - y > ROUNDING*(fabs(x) + fabs(y))) && !(t->side[k[0]] & t->side[k[1]] & t->side[k[2]])
	    && !equal(a, b) && !equal(b, c) && !equal(c, a);
}

int
tangle_star(const Tangle *t, const double *p, int i)
{
	int s, n = 0;

	for (s = t->star.first[i]; s < t->star.first[i+1]; s++)
		n += tangle_bad(t, p, t->star.side[s]/3);
	return n;
}

int
tangle_count(const Tangle *t)
{
	int f, n = 0;

	for (f = 0; f < t->d->m.nf; f++)
		n += tangle_bad(t, t->p, f);
	return n;
}

int
tangle_ball(Tangle *t, int n, int rings)
{
	int r, q = 0, end, s, k, i;

	for (q = 0; q < n; q++)
		t->ball[t->queue[q]] = 1;
	for (q = 0, r = 0; r < rings; r++)
		for (end = n; q < end; q++)
			for (s = t->star.first[t->queue[q]]; s < t->star.first[t->queue[q]+1]; s++)
				for (k = 0; k < 3; k++) {
					i = t->d->m.tri[t->star.side[s]/3*3 + k];
					if (!t->ball[i]) {
						t->ball[i] = 1;
						t->queue[n++] = i;
					}
				}
	return n;
}

void
tangle_clear(Tangle *t, int n)
{
	while (n > 0)
		t->ball[t->queue[--n]] = 0;
}
