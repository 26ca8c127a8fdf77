/* choosechart.h - the chart of a grid: its kind, its cones, and the map of the rectangle onto it. */
#ifndef CHOOSECHART_H
#define CHOOSECHART_H

#include "chartmap.h"
#include "conformal.h"

/* A disk on the rectangle [0,1] x [0,T]. */
typedef struct Rectangle {
	double        T;
	const double *u, *v;    /* [nv] */
} Rectangle;

/* Finds the cones, and makes the map of the chart.  corner: indices into the loop of d.
 *
 * kind  in/out  of the chart; becomes the sock if that is clearly better and o->choose is set
 * c     out     cone, chi2
 *
 * Returns 0, SPD_ENOMEM or CONFORMAL_ECONES. */
int choosechart(const Disk *d, const int corner[4], const Rectangle *r, const ConformalOptions *o,
	const ChartKind **kind, ChartMap *map, Conformal *c);

#endif
