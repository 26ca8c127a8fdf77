/* closedmesh.h - closed surfaces for tests: an octahedron that is split again and again, on surfaces of revolution. */
#ifndef CLOSEDMESH_H
#define CLOSEDMESH_H

#include <math.h>

#include "../lib/mesh/disk.h"

/* A number of a fixed sequence, in -1 .. 1. */
static inline double
closed_random(uint64_t *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return (double)(*state >> 11)/(1ull << 52) - 1;
}

static inline void
closed_to_sphere(double *x)
{
	double r = sqrt(x[0]*x[0] + x[1]*x[1] + x[2]*x[2]);
	int c;

	for (c = 0; c < 3; c++)
		x[c] /= r;
}

/* The number of the midpoint of vertices a, b.  edge: those that are known, [*edges][3]. */
static inline int
closed_middle(Mesh *m, int (*edge)[3], int *edges, int *first, int a, int b)
{
	int lo = a < b ? a : b, hi = a < b ? b : a, k, c;

	for (k = first[lo]; k >= 0; k = edge[k][2])
		if (edge[k][0] == hi)
			return edge[k][1];
	edge[*edges][0] = hi;
	edge[*edges][1] = m->nv;
	edge[*edges][2] = first[lo];
	first[lo] = (*edges)++;
	for (c = 0; c < 3; c++)
		m->xyz[3*m->nv + c] = m->xyz[3*a + c] + m->xyz[3*b + c];
	closed_to_sphere(&m->xyz[3*m->nv]);
	return m->nv++;
}

static inline void
closed_split(Mesh *m)
{
	int (*edge)[3] = malloc(3*m->nf*sizeof *edge), *first = malloc(m->nv*sizeof *first), *tri = m->tri, edges = 0, t, k;

	assert_non_null(edge);
	assert_non_null(first);
	for (t = 0; t < m->nv; t++)
		first[t] = -1;
	m->xyz = realloc(m->xyz, (2*m->nv + 2*m->nf)*3*sizeof *m->xyz);
	m->tri = malloc(12*m->nf*sizeof *m->tri);
	assert_non_null(m->xyz);
	assert_non_null(m->tri);
	for (t = 0; t < m->nf; t++) {
		int *c = &tri[3*t], e[3], *to = &m->tri[12*t];

		for (k = 0; k < 3; k++)
			e[k] = closed_middle(m, edge, &edges, first, c[k], c[(k+1)%3]);
		for (k = 0; k < 3; k++) {
			to[3*k] = c[k];
			to[3*k+1] = e[k];
			to[3*k+2] = e[(k+2)%3];
			to[9+k] = e[k];
		}
	}
	m->nf *= 4;
	free(tri);
	free(edge);
	free(first);
}

/* The unit sphere: an octahedron split so many times, with its vertices moved by up to `jitter` of an edge. */
static inline Mesh
closed_sphere(int splits, double jitter)
{
	static const double corner[18] = { 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1, 0, 0, 0, 1, 0, 0, -1 };
	static const int face[24] = { 0, 2, 4, 2, 1, 4, 1, 3, 4, 3, 0, 4, 2, 0, 5, 1, 2, 5, 3, 1, 5, 0, 3, 5 };
	Mesh m = { 6, 8, malloc(sizeof corner), malloc(sizeof face) };
	uint64_t state = 1;
	int k;

	assert_non_null(m.xyz);
	assert_non_null(m.tri);
	memcpy(m.xyz, corner, sizeof corner);
	memcpy(m.tri, face, sizeof face);
	for (k = 0; k < splits; k++)
		closed_split(&m);
	for (k = 0; k < 3*m.nv; k++)
		m.xyz[k] += jitter*ldexp(1.5, -splits)*closed_random(&state);
	for (k = 0; k < m.nv; k++)
		closed_to_sphere(&m.xyz[3*k]);
	return m;
}

/* What disk_or_closed makes of m; returns its result. */
static inline int
closed_disk(const Mesh *m, Disk *d)
{
	Soup s = { .nv = m->nv, .nf = m->nf, .xyz = m->xyz, .idx = m->tri };
	int i, e;

	s.first = malloc((m->nf + 1)*sizeof *s.first);
	assert_non_null(s.first);
	for (i = 0; i <= m->nf; i++)
		s.first[i] = 3*i;
	e = disk_or_closed(d, &s);
	free(s.first);
	return e;
}

#endif
