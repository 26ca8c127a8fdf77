/* sampler.h - a mapped mesh as a function of (u,v) on its chart: positions and channels. */
#ifndef SAMPLER_H
#define SAMPLER_H

#include "../base/chart.h"
#include "clough.h"
#include "locate.h"

enum {
	SAMPLER_FACETS,         /* linear on every triangle: the polyhedron itself */
	SAMPLER_SMOOTH          /* C1 and cubic (clough.h): goes through the vertices */
};

enum { SAMPLER_ENOMEM = -1 };

typedef struct Sampler {
	Locator l;
	int     surface;
	Stars   stars;          /* this and the rest for SAMPLER_SMOOTH only */
	Jet    *jet;            /* [nv] of the positions, where state is GRADIENT_KNOWN */
	unsigned char *state;   /* [nv] 0, or a state of gradient.h */
} Sampler;

/* d mapped by u, v onto [0,1] x [0,T]; all three must outlive s.  Returns 0 or
 * SAMPLER_ENOMEM. */
int  sampler_init(Sampler *s, const Disk *d, const double *u, const double *v, double T, int surface);
void sampler_free(Sampler *s);

/* phi (11) at every node of g (24); (x,y) is the place of each node (23) in the chart of the
 * mesh; all [nv][nu].  Computes the jets that it needs and keeps them in s, so it must not run
 * in several threads at once.  Returns 0 or SAMPLER_ENOMEM. */
int  sampler_grid(const Sampler *s, Chart g, const double *x, const double *y, double *const phi[3]);

/* A channel of the mesh at the same nodes, interpolated in the same way: linear, or C1 and cubic.
 * out[k] is component k of its c->n.  Each component f is sampled as the surface (f, a u, a v),
 * a the range of f, so that the limits of gradient.h and clough.h prevent overshooting at a jump.
 *
 * c        in   at the vertices of the disk of sampler_init
 * out      out  [c->n], each [nv][nu] */
int  sampler_channel(const Sampler *s, const Channel *c, Chart g, const double *x, const double *y,
	double *const out[]);

#endif
