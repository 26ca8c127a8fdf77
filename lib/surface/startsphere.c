/* startsphere.c - the start on the pillow: a round sphere, and what lies between it and the surface. */
#include <float.h>
#include <math.h>
#include <stdlib.h>

#include "../base/pillowplane.h"
#include "start.h"

/* The radius of the sphere; negative if its normal points in. */
static double
radius_of(const Level *l)
{
	size_t n = level_nodes(l->g), p;
	double area = 0, bent = 0;

	for (p = 0; p < n; p++) {
		area += l->lambda2[p]*chart_h(l->g)*chart_k(l->g);
		bent += l->l2H[p];
	}
	return copysign(sqrt(area/(4*M_PI)), -bent);
}

int
start_from_sphere(Chart finest, double *band, const Level *l)
{
	PillowPlane plane = pillowplane(l->g.T);
	size_t n = level_nodes(l->g), p;
	double radius = radius_of(l), norm;
	double complex Z[2], xy;

	(void)finest;
	(void)band;
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

int
start_between_sphere(const Level *l, double t, double *lambda2, double *l2H)
{
	size_t n = level_nodes(l->g), p;
	double *round = malloc(n*sizeof *round), radius = radius_of(l), lambda, sphere;

	if (!round)
		return START_ENOMEM;
	chart_round(l->g, round);
	for (p = 0; p < n; p++) {
		sphere = fabs(radius)*round[p];
		lambda = pow(sphere, 1 - t)*pow(l->lambda2[p], t/2);
		lambda2[p] = lambda*lambda;
		l2H[p] = lambda*((1 - t)*sphere*(-1/radius) + t*l->l2H[p]/sqrt(fmax(l->lambda2[p], DBL_MIN)));
	}
	free(round);
	return 0;
}
