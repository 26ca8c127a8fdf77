/* compare.h - the numbers of lhdiff; its usage text says what they are. */
#ifndef CMD_COMPARE_H
#define CMD_COMPARE_H

#include "../lib/mesh.h"

enum {
	COMPARE_AREA_A, COMPARE_AREA_B,
	COMPARE_MAX, COMPARE_MEAN, COMPARE_MAX_REL, COMPARE_MEAN_REL,
	COMPARE_HAUSDORFF, COMPARE_ERROR, COMPARE_HAUSDORFF_REL,
	COMPARE_CROSS_A, COMPARE_CROSS_B,
	COMPARE_N
};

/* Compare b with a, the surfaces of the files path[0] and path[1], or die.
 *
 * error  over the square root of the area of a
 * far    whether to find the Hausdorff distance
 * cross  whether to find self-intersections
 * value  out; -1 what was not asked for or cannot be said */
void compare(const char *const path[2], const Mesh *a, const Mesh *b, double error, int far, int cross,
	double value[COMPARE_N]);

/* Write the values that are not -1, as lines or one JSON object. */
void compare_print(const double value[COMPARE_N], int json);

#endif
