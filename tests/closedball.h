/* closedball.h - closed meshes whose map onto the Riemann sphere is known. */
#ifndef CLOSEDBALL_H
#define CLOSEDBALL_H

#include <math.h>
#include <stdlib.h>

#include "../lib/base/cmplx.h"
#include "../lib/mesh/disk.h"
#include "../lib/synth/rng.h"

/* The point of the sphere that has the stereographic image (x,y,z) (pillowplane.h), of norm 1. */
static inline void
ball_spinor(const double x[3], double complex Z[2])
{
	double a = sqrt((1 + fabs(x[2]))/2);
	double complex b = CMPLX(x[0], x[1])/(2*a);

	Z[0] = x[2] > 0 ? b : a;
	Z[1] = x[2] > 0 ? a : conj(b);
}

static inline void
ball_point(const double complex Z[2], double x[3])
{
	double complex p = 2*Z[0]*conj(Z[1]);

	x[0] = creal(p), x[1] = cimag(p);
	x[2] = creal(Z[1]*conj(Z[1])) - creal(Z[0]*conj(Z[0]));
}

/* The unit sphere: an octahedron each of whose sides is divided into n; vertices moved by up to `noise` steps. */
static inline int
ball_mesh(int n, double noise, Disk *d)
{
	int nf = 8*n*n, t = 0, o, i, j, k, c, e;
	double *xyz = malloc(9*(size_t)nf*sizeof *xyz);
	int *idx = malloc(3*(size_t)nf*sizeof *idx), *first = malloc((nf + 1)*sizeof *first);
	Soup s = { .nv = 3*nf, .nf = nf, .xyz = xyz, .first = first, .idx = idx };
	uint64_t seed = 5;

	for (o = 0; o < 8; o++)
		for (i = 0; i < n; i++)
			for (j = 0; j < 2*(n - i) - 1; j++, t++)
				for (k = 0; k < 3; k++) {
					int down = j%2, a = i + (down ? k != 0 : k == 2), b = j/2 + (down ? k != 1 : k == 1);
					int turned = (o & 1) ^ (o >> 1 & 1) ^ (o >> 2 & 1), at = 3*t + (turned ? k : 2 - k);
					double x[3] = { a, b, n - a - b }, r = sqrt(x[0]*x[0] + x[1]*x[1] + x[2]*x[2]);

					for (c = 0; c < 3; c++)
						xyz[3*at + c] = (o >> c & 1 ? -x[c] : x[c])/r + 0.0;
				}
	for (t = 0; t <= nf; t++)
		first[t] = 3*t;
	for (i = 0; i < 3*nf; i++)
		idx[i] = i;
	e = disk_or_closed(d, &s);
	free(xyz);
	free(idx);
	free(first);
	for (i = 0; !e && i < d->m.nv; i++) {
		double *x = d->m.xyz + 3*(size_t)i, r = 0;

		for (c = 0; c < 3; c++) {
			x[c] += noise*(rng_unit(&seed) - .5)*2/n;
			r += x[c]*x[c];
		}
		for (c = 0; c < 3; c++)
			x[c] /= sqrt(r);
	}
	return e;
}

#endif
