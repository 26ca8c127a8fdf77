/* synth_sphere.c - triangulates both halves of a closed surface, with the same points where they meet. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "delaunay.h"
#include "scatter.h"
#include "synth_shapes.h"

enum { PIECES = 4096, RINGS = 64, ROUNDS = 6 };
static const double SPACING = 1.18, PACKING = 0.80;     /* as in synth_mesh.c */

/* A half is a disk of radius 1: `far` round (SYNTH_FAR,0).  The mesh is even if the points are r/scale apart. */
typedef struct Half {
	const Synth *s;
	double r;
	int    far;
} Half;

static double
scale_at(const Half *h, double x, double y)
{
	const SynthKind *k = h->s->kind;

	return (k->scale ? k->scale : k->lambda)(h->s->p, x + (h->far ? SYNTH_FAR : 0), y);
}

static double
dist(const void *data, double x, double y)
{
	return ((const Half *)data)->r/scale_at(data, x, y);
}

static int
inside(const void *data, double x, double y)
{
	(void)data;
	return x*x + y*y <= 1;
}

/* The area, and the largest scale, of both halves. */
static double
measure(const Synth *s, double *top)
{
	double area = 0, r, a, f;
	int far, i, j;

	for (*top = 0, far = 0; far < 2; far++) {
		Half h = { s, 0, far };

		for (i = 0; i < RINGS; i++)
			for (j = 0; j < 4*RINGS; j++) {
				r = (i + 0.5)/RINGS, a = M_PI*j/(2*RINGS);
				f = scale_at(&h, r*cos(a), r*sin(a));
				*top = fmax(*top, f);
				area += f*f*r*M_PI/(2*RINGS*RINGS);
			}
	}
	return area;
}

/* Points evenly spaced on the circle where the halves meet. */
static int
circle(const Half *h, Points *p)
{
	double length[PIECES + 1], a = 2*M_PI/PIECES, t;
	int i, k, n;

	for (length[0] = 0, i = 0; i < PIECES; i++)
		length[i+1] = length[i] + a*scale_at(h, cos((i + 0.5)*a), sin((i + 0.5)*a));
	n = (int)fmax(floor(length[PIECES]/(SPACING*h->r) + 0.5), 4);
	for (i = k = 0; k < n; k++) {
		while (i < PIECES - 1 && length[i+1] < length[PIECES]*k/n)
			i++;
		t = a*(i + (length[PIECES]*k/n - length[i])/(length[i+1] - length[i]));
		if (scatter_add(p, cos(t), sin(t)))
			return SYNTH_ENOMEM;
	}
	return 0;
}

/* Both halves; the first *nb points of both are the circle, which the far one sees mirrored. */
static int
scatter_halves(const Synth *s, double r, double top, uint64_t seed, Points p[2], int *nb)
{
	Half h[2] = { { s, r, 0 }, { s, r, 1 } };
	int far, k;

	p[0].n = p[1].n = 0;
	if (circle(&h[0], &p[0]))
		return SYNTH_ENOMEM;
	*nb = p[0].n;
	for (k = 0; k < *nb; k++)
		if (scatter_add(&p[1], p[0].xy[2*k], -p[0].xy[2*k+1]))
			return SYNTH_ENOMEM;
	for (far = 0; far < 2; far++) {
		ScatterRule rule = { -1, 1, -1, 1, 0.98*r/top, dist, inside, &h[far] };

		if (scatter(&rule, seed + far, &p[far]))
			return SYNTH_ENOMEM;
	}
	return 0;
}

/* The number in the mesh of point k of a half. */
static int
number(const Points p[2], int nb, int far, int k)
{
	return !far || k < nb ? k : p[0].n + k - nb;
}

/* Sets m to both triangulations, and xy to the parameters. */
static int
glue(const Synth *s, const Points p[2], int nb, Mesh *m, double *xy)
{
	int far, k, nf, e;
	double *at;

	m->nv = p[0].n + p[1].n - nb;
	m->xyz = malloc(3*(size_t)m->nv*sizeof *m->xyz);
	m->tri = malloc(6*(size_t)(p[0].n + p[1].n)*sizeof *m->tri);
	if (!m->xyz || !m->tri)
		return SYNTH_ENOMEM;
	for (m->nf = far = 0; far < 2; far++, m->nf += nf) {
		int *tri = m->tri + 3*(size_t)m->nf;

		if ((e = delaunay(p[far].n, p[far].xy, tri, &nf)))
			return e == DELAUNAY_ENOMEM ? SYNTH_ENOMEM : SYNTH_EMESH;
		if (nf != 2*p[far].n - 2 - nb)
			return SYNTH_EMESH;
		for (k = 0; k < 3*nf; k++)
			tri[k] = number(p, nb, far, tri[k]);
		for (k = far ? nb : 0; k < p[far].n; k++) {
			at = xy + 2*(size_t)number(p, nb, far, k);
			at[0] = p[far].xy[2*k] + (far ? SYNTH_FAR : 0);
			at[1] = p[far].xy[2*k+1];
			s->kind->phi(s->p, at[0], at[1], m->xyz + 3*(size_t)number(p, nb, far, k));
		}
	}
	return 0;
}

int
synth_sphere_mesh(const Synth *s, int n, uint64_t seed, Mesh *m, double **xy)
{
	double top, r = sqrt(PACKING*measure(s, &top)/n), *at = NULL;
	Points p[2] = { { 0, 0, NULL }, { 0, 0, NULL } };
	int round, nb, have, e;

	memset(m, 0, sizeof *m);
	for (round = 0; !(e = scatter_halves(s, r, top, seed, p, &nb)) && round < ROUNDS; round++) {
		have = p[0].n + p[1].n - nb;
		if (abs(have - n) <= 0.04*n)
			break;
		r *= sqrt((double)have/n);
	}
	if (!e)
		e = (at = malloc(2*(size_t)(p[0].n + p[1].n)*sizeof *at)) ? glue(s, p, nb, m, at) : SYNTH_ENOMEM;
	free(p[0].xy);
	free(p[1].xy);
	if (e)
		mesh_free(m);
	if (e || !xy)
		free(at);
	else
		*xy = at;
	return e;
}
