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

/* Splits the cell a b c d into tri.  Returns how many of its triangles have no area. */
static int
split(const Mesh *m, int a, int b, int c, int d, int tri[6])
{
	const int ac[6] = { a, b, c, a, c, d }, bd[6] = { a, b, d, b, c, d };
	const int *shorter = dist2(m, b, d) < dist2(m, a, c) ? bd : ac, *longer = shorter == ac ? bd : ac;
	int none = flat(m, shorter), other = none ? flat(m, longer) : 0;

	memcpy(tri, none > other ? longer : shorter, sizeof ac);
	return none > other ? other : none;
}

int
gridmesh_cell(const Mesh *m, Chart g, int n, int tri[6])
{
	int corner[4];

	g.kind->cell(g, n, corner);
	return split(m, corner[0], corner[1], corner[2], corner[3], tri);
}

int
mesh_from_grid(Mesh *m, Chart g, const double *const phi[3])
{
	int c, n, p;

	memset(m, 0, sizeof *m);
	if (g.nu > INT_MAX/6/g.nv)
		return MESH_ENOMEM;
	m->nv = g.nu*g.nv;
	m->xyz = malloc((size_t)m->nv*3*sizeof *m->xyz);
	m->tri = malloc((size_t)m->nv*6*sizeof *m->tri);
	if (!m->xyz || !m->tri) {
		mesh_free(m);
		return MESH_ENOMEM;
	}
	for (p = 0; p < m->nv; p++)
		for (c = 0; c < 3; c++)
			m->xyz[3*(size_t)p+c] = phi[c][p];
	for (n = g.kind->cells(g); m->nf < 2*n; m->nf += 2)
		gridmesh_cell(m, g, m->nf/2, m->tri + 3*(size_t)m->nf);
	return 0;
}
