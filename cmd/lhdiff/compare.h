/* compare.h - the values that lhdiff computes, as in its usage text. */
#ifndef CMD_COMPARE_H
#define CMD_COMPARE_H

#include "../../lib/mesh/mesh.h"

enum {
	COMPARE_AREA_A, COMPARE_AREA_B,
	COMPARE_MAX, COMPARE_MEAN, COMPARE_MAX_REL, COMPARE_MEAN_REL,
	COMPARE_HAUSDORFF, COMPARE_ERROR, COMPARE_HAUSDORFF_REL,
	COMPARE_CROSS_A, COMPARE_CROSS_B,
	COMPARE_N
};

typedef struct Compare {
	double error;           /* of the Hausdorff distance, over the square root of the area of a */
	int    far, cross;      /* whether to compute Hausdorff distances, self-intersections */
} Compare;

/* One of the two surfaces, and the values that depend on it alone. */
typedef struct Side {
	Mesh   m;
	double area, crossings;         /* crossings is -1 if not computed or not defined */
} Side;

/* Compute area and crossings of side s, or die; place names it in messages. */
void compare_side(const Compare *c, const char *place, Side *s);

/* Compare b with a, or die.  A value is -1 if it was not requested or is not defined. */
void compare(const Compare *c, const Side *a, const Side *b, double value[COMPARE_N]);

#endif
