/* likepoints.h - points that stand for a closed surface, with their places on the sphere. */
#ifndef LIKEPOINTS_H
#define LIKEPOINTS_H

#include "../base/moebius.h"
#include "../mesh/mesh.h"

enum { LIKEPOINTS_ENOMEM = -1, LIKEPOINTS_EVALUE = -2 };

typedef struct LikePoints {
	int     n;
	double *x;              /* [n][3] each stands for the same area; (position - mean)/radius */
	Spinor *Z;              /* [n] places, of norm 1 */
	double  mean[3];        /* of the surface, over its area */
	double  radius;         /* root mean square distance from the mean */
	double  axis[3][3];     /* axis[k]: the directions of the second moments, right-handed */
} LikePoints;

/* n points of m, which Z, of norm 1, maps to the sphere.  Returns 0, LIKEPOINTS_ENOMEM, or LIKEPOINTS_EVALUE if the moments
 * are not finite or the radius is 0, with nothing to free. */
int  likepoints_init(LikePoints *p, const Mesh *m, Spinor *Z, int n);
void likepoints_free(LikePoints *p);

#endif
