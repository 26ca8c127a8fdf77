/* nearpoints.h - pairs of points within a distance, found by sorting the points into cells that wide. */
#ifndef NEARPOINTS_H
#define NEARPOINTS_H

enum { NEARPOINTS_ENOMEM = -1 };

typedef void NearMeet(int v, int w, double distance, void *to);

/* Calls meet once for each pair of the n points list[0..n-1] of xyz that are at most `distance` apart.
 * With distance 0, of the points at one position only neighbours in the order of their numbers are
 * paired.  The order of the calls depends on the points alone.  A distance below 1e-18 of the largest
 * coordinate, far below its rounding, counts as 0.  Returns 0 or NEARPOINTS_ENOMEM. */
int nearpoints(const double *xyz, const int *list, int n, double distance, NearMeet *meet, void *to);

#endif
