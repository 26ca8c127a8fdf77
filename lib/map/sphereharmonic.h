/* sphereharmonic.h - harmonic functions on a closed mesh that make a map to the sphere. */
#ifndef SPHEREHARMONIC_H
#define SPHEREHARMONIC_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"
#include "../sparse/chol.h"
#include "../sparse/spd.h"

typedef struct SphereHarmonic {
	const Disk     *d;
	Graph           g;
	double         *off;            /* the matrix, as in CholMatrix */
	double         *diagonal, *x;   /* [nv] */
	Chol            chol;
	unsigned char  *held;
	double complex *z;              /* [nv] the map to the plane */
} SphereHarmonic;

/* The elements of the matrix. */
enum {
	SPHEREHARMONIC_LINEAR,
	SPHEREHARMONIC_QUADRATIC,       /* on `coarse`, of which d is the refinement (rectmap.h) */
	SPHEREHARMONIC_INTRINSIC        /* linear, on the intrinsic Delaunay triangulation of d: no negative weights */
};

/* Prepares the matrix on d, which must outlive s; coarse is only read here.  Returns 0 or SPD_ENOMEM; s then holds
 * nothing to free. */
int  sphereharmonic_init(SphereHarmonic *s, const Disk *d, int elements, const Disk *coarse);
void sphereharmonic_free(SphereHarmonic *s);

/* Sets z to a function with a pole in the largest face.  It is centred, so that the mean of the area on the sphere is
 * 0, and seen from outside.  Returns 0, SPD_ENOMEM or SPD_EINDEFINITE. */
int  sphereharmonic_dipole(SphereHarmonic *s, SpdReport *report);

/* Improves z by Schwarz's method: so many times, replaces z by 1/z and makes it harmonic on the three quarters of the
 * vertices where it is smallest.  `times` is even.  Returns as above. */
int  sphereharmonic_alternate(SphereHarmonic *s, int times, SpdReport *report);

#endif
