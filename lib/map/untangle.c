/* untangle.c - local relaxation of turned triangles. */
#include <stdlib.h>
#include <string.h>

#include "harmonic.h"
#include "rectmap.h"
#include "untangle.h"
#include "../base/vec3.h"

enum { RINGS = 8, SWEEPS = 30 };
enum { HOLD_U = SIDE_LEFT | SIDE_RIGHT, HOLD_V = SIDE_BOTTOM | SIDE_TOP };

typedef struct Tangle {
	const Disk    *d;
	double        *u, *v;
	unsigned char *hold;    /* [nv] the sides of each vertex, which fix u or v */
	unsigned char *moving;  /* [nv] */
	double        *sum;     /* [nv][3] sums of weights, of weighted u, of weighted v */
} Tangle;

static int
is_turned(const Tangle *t, int f)
{
	const int *c = &t->d->m.tri[3*f];

	return (t->u[c[1]] - t->u[c[0]])*(t->v[c[2]] - t->v[c[0]])
	    < (t->u[c[2]] - t->u[c[0]])*(t->v[c[1]] - t->v[c[0]]);
}

/* Marks the vertices of turned triangles as moving; with widen, also every vertex that shares a
 * triangle with a moving one. */
static int
mark_moving(Tangle *t, int widen)
{
	unsigned char *old = malloc(t->d->m.nv);
	int f, k;

	if (!old)
		return UNTANGLE_ENOMEM;
	memcpy(old, t->moving, t->d->m.nv);
	for (f = 0; f < t->d->m.nf; f++) {
		const int *c = &t->d->m.tri[3*f];

		if (is_turned(t, f) || (widen && (old[c[0]] | old[c[1]] | old[c[2]])))
			for (k = 0; k < 3; k++)
				t->moving[c[k]] = 1;
	}
	free(old);
	return 0;
}

/* tan(angle/2) at corner k of triangle f. */
static double
half_tangent(const Mesh *m, int f, int k)
{
	const int *c = &m->tri[3*f];
	double a[3], b[3], n[3];

	sub3(&m->xyz[3*c[(k+1)%3]], &m->xyz[3*c[k]], a);
	sub3(&m->xyz[3*c[(k+2)%3]], &m->xyz[3*c[k]], b);
	cross3(a, b, n);
	return norm3(n)/(norm3(a)*norm3(b) + dot3(a, b));
}

/* Adds the terms of triangle f to the sums of its corner k.  They are half of the mean value
 * weights of the two other corners; the neighbouring triangles add the other halves. */
static void
add_weights(const Tangle *t, int f, int k)
{
	const Mesh *m = &t->d->m;
	const int *c = &m->tri[3*f];
	double tangent = half_tangent(m, f, k), e[3], w, *sum = &t->sum[3*c[k]];
	int i, q;

	for (i = 1; i < 3; i++) {
		q = c[(k+i)%3];
		sub3(&m->xyz[3*q], &m->xyz[3*c[k]], e);
		w = tangent/norm3(e);
		sum[0] += w;
		sum[1] += w*t->u[q];
		sum[2] += w*t->v[q];
	}
}

/* One Jacobi sweep: all moving vertices at once. */
static void
relax(const Tangle *t)
{
	const Mesh *m = &t->d->m;
	int f, k, i;

	memset(t->sum, 0, 3*(size_t)m->nv*sizeof *t->sum);
	for (f = 0; f < m->nf; f++)
		for (k = 0; k < 3; k++)
			if (t->moving[m->tri[3*f+k]])
				add_weights(t, f, k);
	for (i = 0; i < m->nv; i++) {
		const double *sum = &t->sum[3*i];

		if (!t->moving[i] || !(sum[0] > 0 && sum[0] < HUGE_VAL))
			continue;
		if (!(t->hold[i] & HOLD_U))
			t->u[i] = sum[1]/sum[0];
		if (!(t->hold[i] & HOLD_V))
			t->v[i] = sum[2]/sum[0];
	}
}

/* The best (u,v) so far. */
typedef struct Best {
	double *u, *v;
	int     turned;
} Best;

static void
keep_if_better(const Tangle *t, Best *best)
{
	int turned = rectmap_flipped(&t->d->m, t->u, t->v);

	if (turned >= best->turned)
		return;
	best->turned = turned;
	memcpy(best->u, t->u, t->d->m.nv*sizeof *best->u);
	memcpy(best->v, t->v, t->d->m.nv*sizeof *best->v);
}

static int
run(Tangle *t, const int corner[4], Best *best)
{
	int ring, sweep, e = 0;

	harmonic_sides(t->d, corner, t->hold);
	for (ring = 0; ring < RINGS && best->turned > 0 && !e; ring++) {
		e = mark_moving(t, ring > 0);
		for (sweep = 0; sweep < SWEEPS && best->turned > 0 && !e; sweep++) {
			relax(t);
			keep_if_better(t, best);
		}
	}
	return e;
}

int
untangle(const Disk *d, const int corner[4], double *u, double *v, int *turned)
{
	size_t nv = d->m.nv;
	double *room = malloc(2*nv*sizeof *room);
	Tangle t = { d, u, v, calloc(nv, 1), calloc(nv, 1), malloc(3*nv*sizeof *t.sum) };
	Best best = { room, room + nv, 0 };
	int e = UNTANGLE_ENOMEM;

	best.turned = rectmap_flipped(&d->m, u, v);
	if (room && t.hold && t.moving && t.sum) {
		memcpy(best.u, u, nv*sizeof *u);
		memcpy(best.v, v, nv*sizeof *v);
		e = run(&t, corner, &best);
		memcpy(u, best.u, nv*sizeof *u);
		memcpy(v, best.v, nv*sizeof *v);
	}
	*turned = best.turned;
	free(room);
	free(t.hold);
	free(t.moving);
	free(t.sum);
	return e;
}
