/* overlayface.c - the face of a triangle of a subdivision, by the supports of its corners.
 *
 * Each corner lies on a vertex, an edge or a face of the given mesh.  The vertices of these,
 * taken together, are the three corners of the face in which the triangle lies. */
#include <stdlib.h>

#include "overlayface.h"
#include "../mesh/supports.h"

static int
has_corner(const Mesh *m, int f, int v)
{
	const int *c = &m->tri[3*(size_t)f];

	return c[0] == v || c[1] == v || c[2] == v;
}

/* The face whose corners are the three vertices of a, or -1 if there is none. */
static int
face_of(const Mesh *m, const Stars *s, const Support *a)
{
	int k, l, few = a->v[0];

	if (a->v[2] < 0)
		return -1;
	for (k = 1; k < 3; k++)
		if (s->first[a->v[k] + 1] - s->first[a->v[k]] < s->first[few + 1] - s->first[few])
			few = a->v[k];
	for (l = s->first[few]; l < s->first[few + 1]; l++) {
		int f = s->side[l]/3;

		if (has_corner(m, f, a->v[0]) && has_corner(m, f, a->v[1]) && has_corner(m, f, a->v[2]))
			return f;
	}
	return -1;
}

int
overlay_faces(const Mesh *m, const Stars *s, const Subdivision *o, int *face)
{
	Support *of = supports(o);
	int t, k;

	if (!of)
		return MESH_ENOMEM;
	for (t = 0; t < o->d.m.nf; t++) {
		Support a = { { -1, -1, -1 }, { 0, 0, 0 } };

		for (k = 0; k < 3; k++)
			support_join(&a, &of[o->d.m.tri[3*(size_t)t + k]]);
		face[t] = face_of(m, s, &a);
	}
	free(of);
	return 0;
}
