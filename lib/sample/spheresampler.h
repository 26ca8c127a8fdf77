/* spheresampler.h - a closed mesh that is mapped onto the Riemann sphere as a function of the points there.
 *
 * A point is Z[0] : Z[1], of norm 1.  The half |z| < 1, z = Z[0]/Z[1], is sampled over the plane of z, the other one
 * over that of 1/z, each by a sampler (sampler.h) of the faces that lie within |z| or |1/z| < SPHERESAMPLER_REACH.  Both are
 * C1 and go through the vertices; round |z| = 1 one passes into the other, and the mean is C1.
 *
 * Where a face is turned over in the plane of its half, or has a side longer than 45 degrees on the sphere, the
 * facets of the finer mesh of the map are sampled (sampler_overlay).
 */
#ifndef SPHERESAMPLER_H
#define SPHERESAMPLER_H

#include "../base/cmplx.h"
#include "sampler.h"

#define SPHERESAMPLER_REACH 4.0

enum {
	SPHERESAMPLER_ENOMEM = -1,
	SPHERESAMPLER_ECOARSE = -2      /* a face of the finer mesh has a side longer than 45 degrees, or a half
	                                 * of the sphere has no faces */
};

typedef struct SphereHalf {
	Disk        part;               /* the faces of the given mesh within reach; shares its vertices */
	Subdivision fine;               /* those of the finer mesh; shares all but faces and twins */
	double     *u, *v;              /* [fine.d.m.nv] places of the vertices, in [0,1] x [0,1] */
	unsigned char *rough;           /* [part.m.nv] */
	Sampler     s;
} SphereHalf;

typedef struct SphereSampler {
	SphereHalf half[2];
	int overlaid;                   /* faces of the given mesh near which facets are sampled */
} SphereSampler;

/* Prepares to sample d, which Z maps onto the sphere.
 *
 * d        the given mesh, closed
 * mesh     a subdivision of it
 * Z        [mesh->d.m.nv] places of the vertices of mesh, of which those of d come first
 * surface  SAMPLER_FACETS (of mesh) or SAMPLER_SMOOTH (of d)
 *
 * d and mesh must outlive s.  Returns 0, or SPHERESAMPLER_ENOMEM or SPHERESAMPLER_ECOARSE with nothing to free. */
int  spheresampler_init(SphereSampler *s, const Disk *d, const Subdivision *mesh, double complex (*Z)[2], int surface);
void spheresampler_free(SphereSampler *s);

/* The positions phi, each [n], at n points.  Not to be called by several threads at once; the result does not depend
 * on the number of threads.  Returns 0 or SPHERESAMPLER_ENOMEM. */
int  spheresampler_points(const SphereSampler *s, int n, double complex (*at)[2], double *const phi[3]);

/* The numbers f, given at the vertices of the sampled mesh (d, or mesh for SAMPLER_FACETS), at n points. */
int  spheresampler_field(const SphereSampler *s, const double *f, int n, double complex (*at)[2], double *to);

#endif
