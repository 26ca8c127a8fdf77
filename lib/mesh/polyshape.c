/* polyshape.c - the shape of a triangle, for splitting polygons. */
#include <math.h>
#include <string.h>

#include "../base/vec3.h"
#include "polypriv.h"

int
polygon_edges(const double *a, const double *b, const double *c, double u[3], double v[3])
{
	double m = 0;
	int k;

	for (k = 0; k < 3; k++) {
		u[k] = b[k] - a[k];
		v[k] = c[k] - a[k];
		m = larger(m, larger(fabs(u[k]), fabs(v[k])));
	}
	if (!(m >= POLYGON_TINY && m <= 1/POLYGON_TINY))
		return 0;
	for (k = 0; k < 3; k++)
		u[k] /= m, v[k] /= m;
	return 1;
}

void
polygon_shape(const double *a, const double *b, const double *c, double n[3])
{
	double u[3], v[3], w[3], longest2;
	int k;

	memset(n, 0, 3 * sizeof *n);
	if (!polygon_edges(a, b, c, u, v))
		return;
	for (k = 0; k < 3; k++)
		w[k] = v[k] - u[k];
	longest2 = larger(dot3(u, u), larger(dot3(v, v), dot3(w, w)));
	cross3(u, v, n);
	for (k = 0; k < 3; k++)
		n[k] /= 2 * longest2;
}
