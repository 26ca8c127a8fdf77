/* held.c - the vertices that the sides and cones of a chart hold, and their order. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"
#include "held.h"
#include "pocket.h"

static const double APART = 1e-9;       /* distance of vertices of a side that had the same place */

enum { CONE = 16 };                     /* the bit of the first cone; the next one has the next bit */

/* ---- the order along a side ------------------------------------------ */

/* Spreads the m places at x evenly over their interval, made a little longer first, but not as far as
 * the neighbouring places x[-1] and x[m]. */
static void
spread(int m, double *x)
{
	double lo = x[0], hi = x[0], more;
	int k;

	for (k = 1; k < m; k++)
		lo = fmin(lo, x[k]), hi = fmax(hi, x[k]);
	more = fmax((hi - lo)/m, APART);
	lo = fmax(lo - more, (x[-1] + lo)/2);
	hi = fmin(hi + more, (x[m] + hi)/2);
	for (k = 0; k < m; k++)
		x[k] = lo + (hi - lo)*(k + 0.5)/m;
}

/* Makes the places x[0..n] along a side ascending; x[0] and x[n] stay.  Runs of places that are not
 * above all earlier and below all later ones are spread evenly.  below: workspace, [n] */
static void
sort_side(int n, double *x, double *below)
{
	double most = x[0];
	int i, first = 1;

	for (below[n-1] = x[n], i = n - 2; i >= 0; i--)
		below[i] = fmin(x[i+1], below[i+1]);            /* the least place behind i */
	for (i = 1; i <= n; i++)
		if (i == n || (x[i] > most && x[i] < below[i])) {
			if (first < i)
				spread(i - first, &x[first]);
			most = x[i];
			first = i + 1;
		} else
			most = fmax(most, x[i]);
}

/* ---- the rectangle --------------------------------------------------- */

static void
rectangle_hold(const Tangle *t)
{
	harmonic_sides(t->d, t->corner, t->side);
}

static void
rectangle_put(const Tangle *t)
{
	int i;

	for (i = 0; i < t->d->m.nv; i++) {
		double *x = &t->place[2*(size_t)i];
		int side = t->side[i];

		x[0] = side & SIDE_LEFT ? 0 : side & SIDE_RIGHT ? 1 : fmin(fmax(x[0], 0), 1);
		x[1] = side & SIDE_BOTTOM ? 0 : side & SIDE_TOP ? t->T : fmin(fmax(x[1], 0), t->T);
	}
}

static void
rectangle_sort(const Tangle *t, double *x)
{
	const Disk *d = t->d;
	int k, i, n;

	for (k = 0; k < 4; k++) {
		const int back = k >= 2, axis = k%2;

		n = (t->corner[(k+1)%4] - t->corner[k] + d->nb)%d->nb;
		for (i = 0; i <= n; i++)
			x[back ? n - i : i] = t->place[2*(size_t)d->loop[(t->corner[k] + i)%d->nb] + axis];
		sort_side(n, x, x + d->nb + 1);
		for (i = 0; i <= n; i++)
			t->place[2*(size_t)d->loop[(t->corner[k] + i)%d->nb] + axis] = x[back ? n - i : i];
	}
}

static int
rectangle_pockets(const Tangle *t)
{
	return pocket_sides(t->d, t->corner, t->side) ? HELD_ENOMEM : 0;
}

static void
rectangle_wrap(double *u, double *v)
{
	(void)u, (void)v;
}

/* ---- the sock -------------------------------------------------------- */

static void
sock_hold(const Tangle *t)
{
	int i;

	memset(t->side, 0, t->d->m.nv);
	for (i = 0; i < t->d->nb; i++)
		t->side[t->d->loop[i]] = SIDE_TOP;
	for (i = 0; i < t->kind->cones; i++)
		t->side[t->cone[i]] |= CONE << i;
}

static void
sock_put(const Tangle *t)
{
	int i;

	for (i = 0; i < t->d->m.nv; i++) {
		double *x = &t->place[2*(size_t)i];

		x[1] = t->side[i] & SIDE_TOP ? t->T : fmin(x[1], t->T);
	}
	for (i = 0; i < t->kind->cones; i++)
		memcpy(&t->place[2*(size_t)t->cone[i]], t->kind->cone[i], 2*sizeof *t->place);
}

static void
sock_wrap(double *u, double *v)
{
	if (*v < 0)
		*u = -*u, *v = -*v;
	*u -= floor(*u);
	if (*u == 1)                    /* of a tiny negative number */
		*u = 0;
}

/* The loop has the surface on its left, so u falls along it, by 1 in all. */
static void
sock_sort(const Tangle *t, double *x)
{
	const Disk *d = t->d;
	double *given = x + 2*((size_t)d->nb + 1), step, *p;
	int i, n = d->nb;

	x[n] = t->place[2*(size_t)d->loop[0]];
	for (i = 1; i < n; i++) {
		step = t->place[2*(size_t)d->loop[i]] - x[n-i+1];
		x[n-i] = x[n-i+1] + step - floor(step + 0.5);
	}
	x[0] = x[n] - 1;
	memcpy(given, x, (n + 1)*sizeof *x);
	sort_side(n, x, x + n + 1);
	for (i = 1; i < n; i++) {
		p = &t->place[2*(size_t)d->loop[i]];
		if (x[n-i] != given[n-i]) {
			p[0] = x[n-i];
			sock_wrap(&p[0], &p[1]);
		}
	}
}

static int
sock_pockets(const Tangle *t)
{
	return pocket_round(t->d, t->place, t->side) ? HELD_ENOMEM : 0;
}

/* ---- either ---------------------------------------------------------- */

static const struct Functions {
	const ChartKind *kind;
	void (*hold)(const Tangle *t);
	void (*put)(const Tangle *t);
	void (*sort)(const Tangle *t, double *x);
	int  (*pockets)(const Tangle *t);
	void (*wrap)(double *u, double *v);
} functions[] = {
	{ &CHART_RECTANGLE, rectangle_hold, rectangle_put, rectangle_sort, rectangle_pockets, rectangle_wrap },
	{ &CHART_SOCK, sock_hold, sock_put, sock_sort, sock_pockets, sock_wrap },
};

static const struct Functions *
of(const Tangle *t)
{
	const struct Functions *f = functions;

	while (f->kind != t->kind)
		f++;
	return f;
}

void
held_put(const Tangle *t)
{
	of(t)->hold(t);
	of(t)->put(t);
}

int
held_sort(const Tangle *t)
{
	double *x = malloc(3*((size_t)t->d->nb + 1)*sizeof *x);
	int e = of(t)->pockets(t);

	if (!x || e) {
		free(x);
		return HELD_ENOMEM;
	}
	of(t)->put(t);
	of(t)->sort(t, x);
	free(x);
	return 0;
}

void
held_wrap(const Tangle *t, double *u, double *v)
{
	of(t)->wrap(u, v);
}
