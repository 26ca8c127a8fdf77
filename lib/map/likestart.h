/* likestart.h - where the fit of spherelike.h begins. */
#ifndef LIKESTART_H
#define LIKESTART_H

#include "../base/procrustes.h"
#include "likegrid.h"

/* A position of B on A: the motion of the points of B, and the map of its sphere. */
typedef struct LikeStart {
	Rigid   r;
	Moebius M;
	double  rms;            /* of b in this position, from the surface at equal places; infinite: there is no map */
} LikeStart;

enum { LIKESTART_COUNT = 25 };

/* Sets s to as many positions of b on a, the best first: as they lie, and with their axes of second moments on each other in
 * each of the 24 ways.  From each the nearest points of a give a map of the spheres, this a better motion, and so on.
 * Returns 0 or LIKEPOINTS_ENOMEM. */
int likestart(const LikeGrid *a, const LikePoints *b, LikeStart s[LIKESTART_COUNT]);

/* The rigid motion of b by least squares onto the points of the surface a where M takes them, `to` [b->n][3].  Returns the
 * root mean square distance after it, infinite if there is none. */
double likestart_motion(const LikeGrid *a, const LikePoints *b, Moebius M, double *to, Rigid *r);

#endif
