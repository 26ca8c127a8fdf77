/* relax.c - mean value weights in the plane and on the surface, Gauss-Seidel sweeps. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "relax.h"
#include "../base/vec3.h"

enum { SWEEPS = 16 };                   /* sweeps over a region, divided by the square of its rings:
                                         * information crosses n rings in about n^2 sweeps */
enum { LAST = 20000 };                  /* sweeps once there are 32 rings, or the region cannot grow */
static const double WORK = 1e8;         /* triangles in all sweeps together: a few seconds */
static const double LEAST = 1e-2;       /* smallest weight on the surface / largest at that vertex:
                                         * thin triangles would draw vertices almost to a point */
enum { BACK = 64 };                     /* rounds of partial steps back */
static const double FLOOR = 0.01;       /* after such steps, area / area before them */

/* The two other corners of the triangle of corner h, its next one first. */
static void
others(int h, int *j, int *l)
{
	*j = h - h%3 + (h + 1)%3;
	*l = h - h%3 + (h + 2)%3;
}

/* b - a for corners a and b of a triangle, in its plane or on the surface. */
static void
edge(const Tangle *t, int plane, int a, int b, double x[3])
{
	const int *tri = t->d->m.tri;
	double p[2], q[2];

	if (plane) {
		tangle_image(t, t->place, a, p);
		tangle_image(t, t->place, b, q);
		x[0] = q[0] - p[0];
		x[1] = q[1] - p[1];
		x[2] = 0;
	} else
		sub3(&t->d->m.xyz[3*(size_t)tri[b]], &t->d->m.xyz[3*(size_t)tri[a]], x);
}

/* The mean value weights of vertex i (Floater): for each of its triangles tan(angle/2)/length of
 * both sides.  Taken in the plane, they make i the mean of its neighbours there.  Returns the largest,
 * or HUGE_VAL if they are not all finite. */
static double
mean_value_weights(Tangle *t, int i, int plane)
{
	double a[3], b[3], n[3], tangent, most = 0, sum = 0;
	int s, h, j, l;

	for (s = t->star.first[i]; s < t->star.first[i+1]; s++) {
		double *w = &t->w[2*(size_t)s];

		h = t->star.side[s];
		others(h, &j, &l);
		edge(t, plane, h, j, a);
		edge(t, plane, h, l, b);
		cross3(a, b, n);
		tangent = norm3(n)/(norm3(a)*norm3(b) + dot3(a, b));
		w[0] = tangent/norm3(a);
		w[1] = tangent/norm3(b);
		sum += w[0] + w[1];
		most = fmax(most, fmax(w[0], w[1]));
	}
	return sum > 0 && sum < HUGE_VAL ? most : HUGE_VAL;
}

/* Sets the weights of vertex i, and force (relax.h). */
static void
set_weights(Tangle *t, int i)
{
	double most, a[3], b[3], *force = &t->force[2*(size_t)i];
	int s, h, j, l, c;

	force[0] = force[1] = 0;
	if (tangle_star(t, t->place, i) == 0 && mean_value_weights(t, i, 1) < HUGE_VAL)
		return;
	most = mean_value_weights(t, i, 0);
	for (s = t->star.first[i]; s < t->star.first[i+1]; s++) {
		double *w = &t->w[2*(size_t)s];

		h = t->star.side[s];
		others(h, &j, &l);
		edge(t, 1, h, j, a);
		edge(t, 1, h, l, b);
		for (c = 0; c < 2; c++)
			w[c] = most < HUGE_VAL ? fmax(w[c], LEAST*most) : 1;
		for (c = 0; c < 2; c++)
			force[c] += t->sheet[h].sign*(w[0]*a[c] + w[1]*b[c]);
	}
}

static int
by_key(const void *a, const void *b)
{
	const Mover *x = a, *y = b;

	return x->key < y->key ? -1 : x->key > y->key ? 1 : (x->i > y->i) - (x->i < y->i);
}

/* Adds the vertices that are at most `rings` edges away from bad triangles, except those of the
 * sides.  Returns the number of new ones. */
static int
grow(Tangle *t, int rings)
{
	const Mesh *m = &t->d->m;
	int f, k, n = 0, before = t->n;

	for (f = 0; f < m->nf; f++)
		for (k = 0; tangle_bad(t, t->p, f) && k < 3; k++)
			if (!t->ball[m->tri[3*f+k]]) {
				t->ball[m->tri[3*f+k]] = 1;
				t->queue[n++] = m->tri[3*f+k];
			}
	n = tangle_ball(t, n, rings);
	for (k = 0; k < n; k++)
		if (!t->side[t->queue[k]] && !t->inside[t->queue[k]]) {
			t->inside[t->queue[k]] = 1;
			t->mover[t->n++] = (Mover){ t->key[t->queue[k]], t->queue[k] };
			set_weights(t, t->queue[k]);
		}
	tangle_clear(t, n);
	qsort(t->mover, t->n, sizeof *t->mover, by_key);
	for (t->nt = 0, f = 0; f < m->nf; f++)
		if (t->inside[m->tri[3*f]] | t->inside[m->tri[3*f+1]] | t->inside[m->tri[3*f+2]])
			t->tri[t->nt++] = f;
	return t->n - before;
}

/* One Gauss-Seidel step at vertex i for  sum_j w_ij (e_j - e_i) + force_i = 0. */
static void
step(Tangle *t, int i)
{
	double sum = 0, x = t->force[2*(size_t)i], y = t->force[2*(size_t)i+1], a, b;
	const double *ej, *el;
	int s, h, j, l;

	for (s = t->star.first[i]; s < t->star.first[i+1]; s++) {
		const double *w = &t->w[2*(size_t)s];

		h = t->star.side[s];
		others(h, &j, &l);
		ej = &t->e[2*(size_t)t->d->m.tri[j]], el = &t->e[2*(size_t)t->d->m.tri[l]];
		a = t->sheet[h].sign*t->sheet[j].sign*w[0];     /* e_j turned with its sheet */
		b = t->sheet[h].sign*t->sheet[l].sign*w[1];
		sum += w[0] + w[1];
		x += a*ej[0] + b*el[0];
		y += a*ej[1] + b*el[1];
	}
	t->e[2*(size_t)i] = x/sum;
	t->e[2*(size_t)i+1] = y/sum;
}

/* Sets the places of the region.  Returns the number of bad triangles there. */
static int
set_places(Tangle *t)
{
	int k, c, bad = 0;

	for (k = 0; k < t->n; k++)
		for (c = 0; c < 2; c++) {
			size_t q = 2*(size_t)t->mover[k].i + c;

			t->p[q] = t->place[q] + t->e[q];
		}
	for (k = 0; k < t->nt; k++)
		bad += tangle_bad(t, t->p, t->tri[k]);
	return bad;
}

void
relax(Tangle *t)
{
	int rings, n, k, most, added = 1, bad = 1;
	double work = 0;

	for (rings = 1; bad > 0 && added > 0 && work < WORK; rings *= 2) {
		added = grow(t, rings);
		most = added > 0 && rings < 32 ? SWEEPS*rings*rings : LAST;
		for (n = 1; n <= most && bad > 0 && work < WORK; n++) {
			for (k = 0; k < t->n; k++)
				step(t, t->mover[k].i);
			work += t->nt;
			if (n < 16 || n%16 == 0)
				bad = set_places(t);
		}
	}
}

/* Twice the area of the triangle of the places p, a, b. */
static double
area(const double p[2], const double a[2], const double b[2])
{
	return (a[0] - p[0])*(b[1] - p[1]) - (b[0] - p[0])*(a[1] - p[1]);
}

/* The largest share, at most 1, of the way from p back to the place of vertex i at which every
 * triangle at i still has FLOOR times its area before relax_back. */
static double
way(const Tangle *t, int i)
{
	double least = 1, now, then, room, a[2], b[2], p[2], x[2];
	int s, j, l;

	for (s = t->star.first[i]; s < t->star.first[i+1]; s++) {
		others(t->star.side[s], &j, &l);
		tangle_image(t, t->p, j, a);
		tangle_image(t, t->p, l, b);
		tangle_image(t, t->p, t->star.side[s], p);
		tangle_image(t, t->place, t->star.side[s], x);
		now = area(p, a, b);
		then = area(x, a, b);
		room = now - FLOOR*t->area[t->star.side[s]/3];
		if (then < now)
			least = fmin(least, fmax(room, 0)/(now - then));
	}
	return least;
}

/* Moves vertex i towards its place by a share of the way, if that makes no triangle bad.  Returns
 * whether it is moved. */
static int
move(Tangle *t, int i, double share)
{
	double *p = &t->p[2*(size_t)i], old[2] = { p[0], p[1] };
	const double *x = &t->place[2*(size_t)i];
	int before = tangle_star(t, t->p, i);

	p[0] = share < 1 ? p[0] + share*(x[0] - p[0]) : x[0];
	p[1] = share < 1 ? p[1] + share*(x[1] - p[1]) : x[1];
	if (tangle_star(t, t->p, i) <= before)
		return p[0] != old[0] || p[1] != old[1];
	p[0] = old[0], p[1] = old[1];
	return 0;
}

void
relax_back(Tangle *t)
{
	int round, k, moved;

	for (k = 0; k < t->nt; k++) {
		double a[2], b[2], c[2];

		tangle_image(t, t->p, 3*t->tri[k], a);
		tangle_image(t, t->p, 3*t->tri[k] + 1, b);
		tangle_image(t, t->p, 3*t->tri[k] + 2, c);
		t->area[t->tri[k]] = area(a, b, c);
	}
	for (round = 0; round <= BACK; round++) {
		do
			for (moved = 0, k = 0; k < t->n; k++)
				moved += move(t, t->mover[k].i, 1);
		while (moved > 0);
		for (k = 0; round < BACK && k < t->n; k++)
			move(t, t->mover[k].i, way(t, t->mover[k].i)/2);
	}
}
