/* blend.h - linear interpolation of fields, equations (20)-(22). */
#ifndef BLEND_H
#define BLEND_H

#include <stddef.h>

/* f = (1-t) a + t b for arrays of n numbers.  At t = 0 f is a copy of a, at t = 1 of b. */
void blend(size_t n, double t, const double *a, const double *b, double *f);

#endif
