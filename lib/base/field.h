/* field.h - sums and updates of long arrays, on all threads.  Results have the same bits for any
 * number of threads: sums are formed block by block, and the blocks depend on n only. */
#ifndef FIELD_H
#define FIELD_H

#include <stddef.h>

/* <a, b> */
double field_dot(size_t n, const double *a, const double *b);

/* y += a x */
void field_add(size_t n, double a, const double *x, double *y);

/* y = x + a y */
void field_xpay(size_t n, const double *x, double a, double *y);

/* y = a x; x and y may be the same array, but must not overlap otherwise. */
void field_scale(size_t n, double a, const double *x, double *y);

#endif
