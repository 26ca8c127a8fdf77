/* sampler.h - a mapped mesh as a function phi(u,v) on its chart. */
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
	Stars   stars;          /* this and the rest of SAMPLER_SMOOTH */
	Jet    *jet;            /* [nv] where want says that they are known */
	unsigned char *want;    /* [nv] gradient.h */
} Sampler;

/* d mapped by u, v onto [0,1] x [0,T]; all three must outlive s.  Returns 0 or
 * SAMPLER_ENOMEM. */
int  sampler_init(Sampler *s, const Disk *d, const double *u, const double *v, double T, int surface);
void sampler_free(Sampler *s);

/* phi at every node of g, (x,y) its place in the chart of the mesh; all [nv][nu].  Finds
 * the jets that it needs, and keeps them: not from several threads at once.  Returns 0 or
 * SAMPLER_ENOMEM. */
int  sampler_grid(const Sampler *s, Chart g, const double *x, const double *y, double *const phi[3]);

#endif
