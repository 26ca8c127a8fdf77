/* warpimages.h - the unit normals of two surfaces as images on one rectangle, and their mismatch
 * under a map f. */
#ifndef WARPIMAGES_H
#define WARPIMAGES_H

#include "../base/chart.h"

enum { WARPIMAGES_ENOMEM = -1 };

/* The surface on a grid of nu x nv nodes.  All arrays are [nv][nu][3] or [nv][nu]. */
typedef struct WarpSurface {
	int     nu, nv;
	double *phi, *normal;
	double *area;           /* |phi_u x phi_v| over its mean */
} WarpSurface;

/* Samples a surface, phi[3] on the rectangle g.  Normals are averaged where g is finer.
 * Returns 0, or WARPIMAGES_ENOMEM with nothing to free. */
int  warpsurface_init(WarpSurface *s, Chart g, const double *const phi[3], int nu, int nv);
void warpsurface_free(WarpSurface *s);

/* y = x, [nv][nu][3], smoothed by a Gaussian whose standard deviation is `share` of each side, mirrored
 * at the sides.  x and y may be the same.  Returns 0 or WARPIMAGES_ENOMEM. */
int warpimages_smooth(int nu, int nv, double share, const double *x, double *y);

/* The values of b[nv][nu][3] at the point (u,v) of [0,1] x [0,1], bilinear; du and dv, unless NULL, its
 * derivatives by u and v. */
void warpimages_at(int nu, int nv, const double *b, double u, double v, double x[3], double du[3], double dv[3]);

/* 1/2 mean |a - b o f|^2 over the nodes; a and b are [nv][nu][3], f is [2][nv][nu], with values in
 * [0,1] x [0,T].  Adds the derivatives by f to g.  row: workspace [nv]. */
double warpimages_mismatch(int nu, int nv, double T, const double *a, const double *b, const double *f, double *g,
	double *row);

#endif
