/* blend.h - weighted sums of fields, equations (20)-(22). */
#ifndef BLEND_H
#define BLEND_H

#include <stddef.h>

/* f = sum of w[k] of[k], for `count` arrays of n numbers.  With the weights (1-t, t) this is (1-t) a + t b.
 * If one weight is 1 and all others are 0, f is a copy of that array. */
void blend(size_t n, int count, const double *w, const double *const *of, double *f);

/* The index of the weight that is 1, if all others are 0; else -1. */
int blend_single(int count, const double *w);

#endif
