/* cotapply.h - computes y = C x with the cotangent matrix C, triangle by triangle, as a reference
 * for tests. */
#ifndef COTAPPLY_H
#define COTAPPLY_H

#include <string.h>

#include "../lib/base/vec3.h"
#include "../lib/mesh/mesh.h"

static inline void
cotangent_apply(const Mesh *m, const double *x, double *y)
{
	double a[3], b[3], n[3], flow;
	int t, k;

	memset(y, 0, m->nv*sizeof *y);
	for (t = 0; t < m->nf; t++) {
		const int *c = &m->tri[3*(size_t)t];

		for (k = 0; k < 3; k++) {
			int o = c[k], i = c[(k+1)%3], j = c[(k+2)%3];

			sub3(&m->xyz[3*(size_t)i], &m->xyz[3*(size_t)o], a);
			sub3(&m->xyz[3*(size_t)j], &m->xyz[3*(size_t)o], b);
			cross3(a, b, n);
			flow = dot3(a, b)/(2*norm3(n))*(x[i] - x[j]);
			y[i] += flow;
			y[j] -= flow;
		}
	}
}

#endif
