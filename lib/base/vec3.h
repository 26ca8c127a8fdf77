/* vec3.h - vectors of three numbers, and the larger of two numbers. */
#ifndef VEC3_H
#define VEC3_H

#include <math.h>

static inline double
dot3(const double a[3], const double b[3])
{
	return a[0]*b[0] + a[1]*b[1] + a[2]*b[2];
}

static inline void
cross3(const double a[3], const double b[3], double c[3])
{
	c[0] = a[1]*b[2] - a[2]*b[1];
	c[1] = a[2]*b[0] - a[0]*b[2];
	c[2] = a[0]*b[1] - a[1]*b[0];
}

static inline void
sub3(const double a[3], const double b[3], double c[3])
{
	c[0] = a[0] - b[0];
	c[1] = a[1] - b[1];
	c[2] = a[2] - b[2];
}

static inline double
norm3(const double a[3])
{
	return sqrt(dot3(a, a));
}

/* As fmax(a, b), but without a call of the library.  a must not be NaN. */
static inline double
larger(double a, double b)
{
	return b > a ? b : a;
}

#endif
