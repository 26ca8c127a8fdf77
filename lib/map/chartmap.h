/* chartmap.h - where the points of a chart lie on the rectangle of a mapped mesh.
 *
 * A mesh is mapped onto a rectangle [0,1] x [0,T] first, whatever the chart of its grid.  A node of the
 * grid has a place: coordinates (x,y) that are smooth functions on the surface, up to its boundary, and
 * from which the point of the rectangle follows.
 *
 *   rectangle  the place is the point of the rectangle itself
 *   sock       the place is a point of the unit disk.  The rectangle is mapped onto it by elliptic
 *              functions, and so is the sock (../base/sockplane.h); any two inner points of the disk are
 *              its cones.  doc/mathematics.md 3.8
 */
#ifndef CHARTMAP_H
#define CHARTMAP_H

#include "../base/chart.h"
#include "../base/sockplane.h"

typedef struct ChartMap {
	const ChartKind *kind;
	double         T;               /* height of the rectangle of the mesh */
	double         chart_T;         /* height of the chart */
	SockPlane      half;            /* of the rectangle: the upper half of the sock of height T/4 */
	SockPlane      sock;
	double complex a, turn;         /* a cone, and the factor that makes the other real */
} ChartMap;

/* The point of the unit disk at (x,y) of a rectangle of height T >= .01. */
double complex chartmap_disk(double T, double x, double y);

/* A rectangle of height T, which is its own chart; and the sock with cones at a, b of the unit disk,
 * 0 < |a - b|.  The ends of a long rectangle crowd together on the disk: for T = 20 or 1/20 they keep four
 * digits, between 1/4 and 4 all but a few units of rounding. */
ChartMap chartmap_rectangle(double T);
ChartMap chartmap_sock(double T, double complex a, double complex b);

/* The place of the point (u,v) of the chart. */
void chartmap_place(const ChartMap *m, double u, double v, double *x, double *y);

/* Moves a place that is off by a rounding error, or by interpolation, to the nearest one.
 *
 * sides  in  the sides of the chart on which the node lies, SIDE_BOTTOM .. (harmonic.h), 0 inside.  On a
 *            rectangle its place is put exactly there: near a corner into which a dead end of the surface
 *            is squeezed, the rounding error of a coordinate reaches far into the dead end.  On a sock the
 *            place is put on the boundary if sides is not 0. */
void chartmap_clamp(const ChartMap *m, int sides, double *x, double *y);

/* The point (x,y) of the rectangle at a place, and the point (u,v) of the chart at a point of the
 * rectangle. */
void chartmap_point(const ChartMap *m, double place_x, double place_y, double *x, double *y);
void chartmap_uv(const ChartMap *m, double x, double y, double *u, double *v);

#endif
