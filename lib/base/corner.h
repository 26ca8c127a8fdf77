/* corner.h - the surroundings of the corners of a chart, where lambda may go to 0.
 *
 * Where the boundary of a mesh is smooth at a corner of the rectangle, lambda goes to 0 like a power of
 * the distance.  There neither a filter nor a fit is controlled by the data, and cells fold. */
#ifndef CORNER_H
#define CORNER_H

#include "chart.h"

/* 10 cells, or a third of the shorter side if that is less. */
int corner_radius(Chart g);

/* 1 within 0.3 of the radius (3 cells of 10) of a corner between two open sides, 0 beyond the radius,
 * smooth between. */
double corner_share(Chart g, int i, int j);

/* 1 up to 0.3, 0 from 1 on, smooth between. */
double corner_fade(double r);

/* The same as corner_share with another radius, in cells. */
double corner_share_within(Chart g, int radius, int i, int j);

#endif
