/* field.h - sums and updates of long arrays, on all threads.  Results are equal to the last bit
 * for any number of threads: blocks of fixed length are summed first, then their sums. */
#ifndef FIELD_H
#define FIELD_H

#include <stddef.h>

/* <a, b> */
double field_dot(size_t n, const double *a, const double *b);

/* y += a x */
void field_add(size_t n, double a, const double *x, double *y);

/* y = x + a y */
void field_turn(size_t n, const double *x, double a, double *y);

/* y = a x; x and y are the same array or do not overlap. */
void field_scale(size_t n, double a, const double *x, double *y);

#endif
