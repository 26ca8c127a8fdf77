/* sphere.h - the conformal map of a closed surface of genus 0 onto the Riemann sphere.
 *
 * A point of the sphere is z = Z[0] : Z[1], |Z[0]|^2 + |Z[1]|^2 = 1.  Seen from outside it is the stereographic image
 * of pillowplane.h, so that faces that are anticlockwise on the surface are so in the plane of z.
 *
 * The map begins with a pole in the largest face: x and y are the functions whose Laplacian is a dipole
 * there (S. Haker et al., IEEE TVCG 6 (2000) 181).  Then, in turn, z is made harmonic on three quarters of the
 * vertices with the values on the last quarter, round z = infinity, given, and 1/z likewise with those round
 * z = 0 given: Schwarz's alternating method.  The last rounds use quadratic elements.  doc/mathematics.md 3.9.
 */
#ifndef SPHERE_H
#define SPHERE_H

#include "../base/moebius.h"
#include "../mesh/subdivision.h"
#include "../sparse/spd.h"
#include "adapt.h"

typedef struct SphereMap {
	Subdivision mesh;       /* the triangulation of the last solve */
	Spinor     *Z;          /* [mesh.d.m.nv] */
	double      certificate;        /* of linear elements: the mean of 2 |mu|^2 over the surface, mu the Beltrami
	                         * coefficient of the faces.  It is about the Dirichlet energy over the area
	                         * of the image, minus 1, if all parts of the surface are scaled to their area;
	                         * on the sphere limbs are so small that they would not count */
	double      mu;         /* the mean of |mu| over the surface */
	int         turned;     /* faces of mesh that are turned over on the sphere */
	int         quadratic;  /* 1 if the last solve was with quadratic elements */
} SphereMap;

/* Maps the closed surface d (disk_or_closed).  Splits faces as adapt_map does: options->tolerance is the largest
 * certificate.  Returns 0, SPD_ENOMEM, SPD_ELARGE or SPD_EINDEFINITE; on an error m holds nothing to free. */
int  sphere_map(const Disk *d, const AdaptOptions *options, SphereMap *m, SpdReport *report);
void sphere_free(SphereMap *m);

#endif
