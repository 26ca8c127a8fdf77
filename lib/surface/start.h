/* start.h - the start of the coarsest grid where none is given.
 *
 * On the rectangle: the surface of the frame method (frame.h), from three rings of the band.
 *
 * On the sock: a spherical cap with the area and the boundary length of the surface, bulging to the side
 * that H says, plus a harmonic field that brings its border to the given one.  If L is the length and A
 * the area, its stereographic radius c has
 *
 *   c^2 = 4 pi A/L^2 - 1,
 *
 * and L^2 >= 4 pi A gives a flat disk.  The unit disk (sockplane.h) is first moved by Moebius maps so
 * that the mean of its circle, weighted by the lengths on the border, is its centre (A. Douady,
 * C. J. Earle 1986).
 *
 * On the pillow: the round sphere (pillowplane.h) with the area of the surface, centred at 0, its normal to the side
 * that H says.  It is far from most surfaces, so those between the two are fitted first (start_between). */
#ifndef START_H
#define START_H

#include "level.h"

enum { START_ENOMEM = -1, START_ENONE = -2 /* the frame method finds no surface */ };

/* How many rings of the border must be given. */
int start_rings(const ChartKind *kind);

/* Sets the inner nodes of l->phi, whose border is given.  finest is the finest grid, on which the rings
 * of `band` [3][nv][nu] are given.  Returns 0, START_ENOMEM or START_ENONE. */
int start_find(Chart finest, double *band, const Level *l);

/* How many surfaces between the start and that of l are to be fitted one after the other; 0 on most charts. */
int start_stages(const ChartKind *kind);

/* Sets lambda2 and l2H to those of the surface at the share t, 0 .. 1, of the way from the start to l:
 * log lambda and lambda H between those of the two.  Returns 0 or START_ENOMEM. */
int start_between(const Level *l, double t, double *lambda2, double *l2H);

/* On the sock: startcap.c; on the pillow: startsphere.c. */
int start_from_cap(Chart finest, double *band, const Level *l);
int start_from_sphere(Chart finest, double *band, const Level *l);
int start_between_sphere(const Level *l, double t, double *lambda2, double *l2H);

#endif
