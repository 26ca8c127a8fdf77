/* pillowplane.c - the pillow as two socks. */
#include <math.h>

#include "pillowplane.h"

PillowPlane
pillowplane(double T)
{
	return (PillowPlane){ T, sockplane(T/2) };
}

void
pillowplane_z(const PillowPlane *p, double u, double v, double complex Z[2])
{
	int far = v > p->T/2;
	double complex z = sockplane_z(&p->half, u, far ? p->T - v : v);

	Z[0] = far ? 1 : z;
	Z[1] = far ? conj(z) : 1;
}

void
pillowplane_uv(const PillowPlane *p, const double complex Z[2], double *u, double *v)
{
	int far = cabs(Z[0]) > cabs(Z[1]);

	sockplane_uv(&p->half, far ? conj(Z[1]/Z[0]) : Z[0]/Z[1], u, v);
	if (far)
		*v = p->T - *v;
}

double
pillowplane_round(const PillowPlane *p, double u, double v)
{
	return sockplane_round(&p->half, u, fmin(v, p->T - v));
}
