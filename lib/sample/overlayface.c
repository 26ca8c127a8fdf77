/* overlayface.c - the face of a triangle of a subdivision, by the supports of its corners.
 *
 * Each corner lies on a vertex, an edge or a face of the given mesh.  The vertices of these,
 * taken together, are the three corners of the face in which the triangle lies. */
#include <stdlib.h>

#include "overlayface.h"

/* The vertex, edge or face of the given mesh on which a vertex of the subdivision lies, as one, two
 * or three vertices; unused entries are -1. */
typedef struct Support {
	int v[3];
} Support;

static void
add(Support *s, int v)
{
	int k;

	for (k = 0; k < 3 && v >= 0 && s->v[k] != v; k++)
		if (s->v[k] < 0) {
			s->v[k] = v;
			return;
		}
}

static void
add_all(Support *s, const Support *more)
{
	int k;

	for (k = 0; k < 3; k++)
		add(s, more->v[k]);
}

/* The support of every vertex of o, [o->d.m.nv], to be freed; NULL if memory runs out. */
static Support *
supports(const Subdivision *o)
{
	Support *s = malloc(o->d.m.nv*sizeof *s);
	int i, k;

	for (i = 0; s && i < o->d.m.nv; i++) {
		s[i] = (Support){ { i < o->given ? i : -1, -1, -1 } };
		for (k = 0; k < 3 && i >= o->given; k++)
			if (o->w[i - o->given][k] != 0)
				add_all(&s[i], &s[o->corner[i - o->given][k]]);
	}
	return s;
}

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
		Support a = { { -1, -1, -1 } };

		for (k = 0; k < 3; k++)
			add_all(&a, &of[o->d.m.tri[3*(size_t)t + k]]);
		face[t] = face_of(m, s, &a);
	}
	free(of);
	return 0;
}
