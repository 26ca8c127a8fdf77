/* blend.h - linear interpolation of fields, equations (20)-(22). */
#ifndef BLEND_H
#define BLEND_H

#include <stddef.h>

/* f = (1-t) a + t b, n numbers; a itself at t = 0 and b at t = 1, bit for bit. */
void blend(size_t n, double t, const double *a, const double *b, double *f);

#endif
