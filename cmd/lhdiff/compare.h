/* compare.h - the numbers of lhdiff; its usage text says what they are. */
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
	double error;           /* over the square root of the area of a */
	int    far, cross;      /* whether to find the Hausdorff distance, self-intersections */
} Compare;

/* One of the two surfaces, and what is known of it alone. */
typedef struct Side {
	Mesh   m;
	double area, crossings;         /* -1 crossings: not asked for */
} Side;

/* Measure side s, called place in messages, or die. */
void compare_side(const Compare *c, const char *place, Side *s);

/* Compare b with a, or die; -1 is the value of what was not asked for or cannot be said. */
void compare(const Compare *c, const Side *a, const Side *b, double value[COMPARE_N]);

#endif
