/* weld.c - groups vertices of the boundary that lie at one place. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "../mesh/nearpoints.h"
#include "join.h"
#include "weld.h"

/* Marks the vertices on edges of one face; n counts them. */
static int
mark_boundary(const Sheet *s, unsigned char *on, int *n)
{
	Sheet other = *s;
	int many, at[2], e, i;

	other.twin = NULL;
	*n = 0;
	memset(on, 0, (size_t)s->nv);
	if ((e = sheet_join(&other, &many, at, NULL)) == 0)
		for (i = 0; i < 3*s->nf; i++)
			if (other.twin[i] < 0)
				on[s->tri[i]] = on[sheet_to(s, i)] = 1;
	for (i = 0; i < s->nv; i++)
		*n += on[i];
	free(other.twin);
	return e;
}

/* The vertices on edges of one face.  Returns NULL if memory runs out. */
static int *
boundary_list(const Sheet *s, int *n)
{
	unsigned char *on = mesh_alloc(s->err, (size_t)s->nv, 1);
	int *list = NULL, v, i = 0;

	if (on && !mark_boundary(s, on, n) && (list = mesh_alloc(s->err, (size_t)*n, sizeof *list)) != NULL)
		for (v = 0; v < s->nv; v++)
			if (on[v])
				list[i++] = v;
	free(on);
	return list;
}

static void
unite(int v, int w, double distance, void *to)
{
	(void)distance;
	sheet_unite(to, v, w);
}

int
weld_boundary(const Sheet *s, double distance, int *to)
{
	int *list, n, v, e, merged = 0;

	for (v = 0; v < s->nv; v++)
		to[v] = v;
	if (!(list = boundary_list(s, &n)))
		return MESH_ENOMEM;
	e = nearpoints(s->xyz, list, n, distance, unite, to);
	free(list);
	if (e)
		return mesh_fail(s->err, MESH_ENOMEM, "no memory to compare %d vertices", n);
	for (v = 0; v < s->nv; v++)
		merged += (to[v] = sheet_root(to, v)) != v;
	return merged;
}

/* The search for the least distance above a bound. */
typedef struct Near {
	const Sheet *s;
	int   *first, *corner;  /* the corners at each vertex */
	double above, least;
} Near;

/* Whether v and w are corners of one face. */
static int
share_face(const Near *near, int v, int w)
{
	int i, k;

	for (i = near->first[v]; i < near->first[v+1]; i++)
		for (k = 0; k < 3; k++)
			if (near->s->tri[near->corner[i] - near->corner[i]%3 + k] == w)
				return 1;
	return 0;
}

static void
take_least(int v, int w, double distance, void *to)
{
	Near *near = to;

	if (distance > near->above && (near->least < 0 || distance < near->least) && !share_face(near, v, w))
		near->least = distance;
}

int
weld_nearest(const Sheet *s, double distance, double most, double *least)
{
	Near near = { .s = s, .above = distance, .least = -1 };
	int n, *list = boundary_list(s, &n), e = MESH_ENOMEM;

	if (list && !sheet_corners(s->tri, 3*s->nf, s->nv, &near.first, &near.corner, s->err))
		e = nearpoints(s->xyz, list, n, most, take_least, &near) ?
		    mesh_fail(s->err, MESH_ENOMEM, "no memory to compare %d vertices", n) : 0;
	free(list);
	free(near.first);
	free(near.corner);
	*least = near.least;
	return e;
}
