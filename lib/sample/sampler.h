/* sampler.h - a mapped mesh as a function of (u,v) on its chart: positions and channels. */
#ifndef SAMPLER_H
#define SAMPLER_H

#include "../mesh/subdivision.h"
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
	Stars   stars;          /* this and all below: for SAMPLER_SMOOTH only */
	Jet    *jet;            /* [nv] jets of the positions, set where state is GRADIENT_KNOWN */
	unsigned char *state;   /* [nv] 0, or a state of gradient.h */
	const Subdivision *overlay;     /* of sampler_overlay, or NULL; all below is for it */
	Locator under;          /* of the triangles of the overlay */
	int    *face;           /* [overlay->d.m.nf] for each triangle of the overlay the triangle
	                         * of l.m in which it lies, or -1 */
	double *smooth;         /* [overlay->d.m.nv] weight of the smooth surface at the vertices,
	                         * linear between them: 1 smooth surface only, 0 flat facets
	                         * only; the vertices of l.m come first */
} Sampler;

/* Prepares to sample d, mapped by u, v onto [0,1] x [0,T].  d, u and v must outlive s.  Returns 0,
 * or SAMPLER_ENOMEM with nothing to free. */
int  sampler_init(Sampler *s, const Disk *d, const double *u, const double *v, double T, int surface);
void sampler_free(Sampler *s);

/* Call this after sampler_init with SAMPLER_SMOOTH if locate_is_flat for some triangles.  There may
 * be such triangles although the map of the surface is one to one, because the straight edges in
 * (u,v) of a thin triangle may be far from the true, curved ones.  Near them the flat facets are
 * sampled in place of the smooth surface; points are then located in a subdivision of the disk in
 * which no triangle is turned over.  The transition is gradual: see Sampler.smooth.
 *
 * o, u, v   in   the subdivision of the disk of sampler_init, and its map; they must outlive s
 * rough     in   NULL, or 1 for other vertices near which the facets are sampled, [nv of the disk]
 *
 * Returns 0 or SAMPLER_ENOMEM; s is to be freed in both cases. */
int  sampler_overlay(Sampler *s, const Subdivision *o, const double *u, const double *v, const unsigned char *rough);

/* Sets phi (11) at n points, such as the nodes (23) of a grid (24).  (x,y) are their coordinates in the chart
 * of the mesh.  All arrays are [n].  The jets needed are computed and kept in s, so this must
 * not be called by several threads at once.  Returns 0 or SAMPLER_ENOMEM. */
int  sampler_points(const Sampler *s, int n, const double *x, const double *y, double *const phi[3]);

/* Samples a channel of the mesh at n points as sampler_points samples positions: linear, or C1
 * and cubic.  Each component f is sampled as the surface (f, a u, a v), where a is the range of f,
 * so that the limits of gradient.h and clough.h prevent overshoots at a jump.
 *
 * c        in   at the vertices of the disk of sampler_init
 * out      out  [c->n], each [n]: component k of the channel in out[k]
 *
 * Returns 0 or SAMPLER_ENOMEM. */
int  sampler_channel(const Sampler *s, const Channel *c, int n, const double *x, const double *y,
	double *const out[]);

#endif
