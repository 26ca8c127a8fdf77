/* startsphere.c - the start on the pillow: a round sphere. */
#include <math.h>

#include "../base/pillowplane.h"
#include "start.h"

int
start_from_sphere(Chart finest, double *band, const Level *l)
{
	PillowPlane plane = pillowplane(l->g.T);
	size_t n = level_nodes(l->g), p;
	double area = 0, bent = 0, radius, norm;
	double complex Z[2], xy;

	(void)finest;
	(void)band;
	for (p = 0; p < n; p++) {
		area += l->lambda2[p]*chart_h(l->g)*chart_k(l->g);
		bent += l->l2H[p];
	}
	radius = copysign(sqrt(area/(4*M_PI)), -bent);
	for (p = 0; p < n; p++) {
		pillowplane_z(&plane, chart_u(l->g, p%l->g.nu), chart_v(l->g, p/l->g.nu), Z);
		norm = creal(Z[0]*conj(Z[0])) + creal(Z[1]*conj(Z[1]));
		xy = 2*Z[0]*conj(Z[1])/norm;
		l->phi[p] = radius*creal(xy);
		l->phi[n+p] = radius*cimag(xy);
		l->phi[2*n+p] = radius*(creal(Z[1]*conj(Z[1])) - creal(Z[0]*conj(Z[0])))/norm;
	}
	return 0;
}
