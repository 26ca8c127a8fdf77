/* gridmesh.c - a gridded surface as a triangle mesh. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "gridmesh.h"
#include "../mesh/polygon.h"

static double
dist2(const Mesh *m, int p, int q)
{
	const double *a = m->xyz + 3*(size_t)p, *b = m->xyz + 3*(size_t)q;
	double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];

	return x*x + y*y + z*z;
}

/* How many of the two triangles tri[0..2], tri[3..5] have no area. */
static int
flat(const Mesh *m, const int tri[6])
{
	const double *x = m->xyz;

	return !polygon_has_area(x + 3*(size_t)tri[0], x + 3*(size_t)tri[1], x + 3*(size_t)tri[2])
	    + !polygon_has_area(x + 3*(size_t)tri[3], x + 3*(size_t)tri[4], x + 3*(size_t)tri[5]);
}

int
gridmesh_cell(const Mesh *m, int p, int nu, int tri[6])
{
	const int a = p, b = p+1, c = p+1+nu, d = p+nu;
	const int ac[6] = { a, b, c, a, c, d }, bd[6] = { a, b, d, b, c, d };
	const int *shorter = dist2(m, b, d) < dist2(m, a, c) ? bd : ac, *longer = shorter == ac ? bd : ac;
	int none = flat(m, shorter), other = none ? flat(m, longer) : 0;

	memcpy(tri, none > other ? longer : shorter, sizeof ac);
	return none > other ? other : none;
}

int
mesh_from_grid(Mesh *m, int nu, int nv, const double *x, const double *y, const double *z)
{
	int i, j, p;

	memset(m, 0, sizeof *m);
	if (nu > INT_MAX/6/nv)
		return MESH_ENOMEM;
	m->nv = nu*nv;
	m->xyz = malloc((size_t)m->nv*3*sizeof *m->xyz);
	m->tri = malloc((size_t)m->nv*6*sizeof *m->tri);
	if (!m->xyz || !m->tri) {
		mesh_free(m);
		return MESH_ENOMEM;
	}
	for (p = 0; p < m->nv; p++) {
		m->xyz[3*(size_t)p] = x[p];
		m->xyz[3*(size_t)p+1] = y[p];
		m->xyz[3*(size_t)p+2] = z[p];
	}
	for (j = 0; j < nv-1; j++)
		for (i = 0; i < nu-1; i++, m->nf += 2)
			gridmesh_cell(m, j*nu + i, nu, m->tri + 3*(size_t)m->nf);
	return 0;
}
