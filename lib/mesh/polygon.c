/* polygon.c - splits the polygons of a soup into triangles. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "polygon.h"
#include "polypriv.h"
#include "../base/vec3.h"

enum { MAXCORNERS = 10000 };            /* the time of ear clipping grows with their square */

static int
triangle(Polygon *p)
{
	double n[3];

	polygon_shape(polygon_at(p, 0), polygon_at(p, 1), polygon_at(p, 2), n);
	polygon_put(p, 0, 1, 2);
	return norm3(n) > POLYGON_FLAT;
}

/* The smaller of the shapes of triangles i i+1 i+2 and i i+2 i+3, measured along the normal of the quad. */
static double
smaller_shape(const Polygon *p, int i, const double side[3])
{
	double m[3], n[3];

	polygon_shape(polygon_at(p, i), polygon_at(p, i + 1), polygon_at(p, (i + 2) % 4), m);
	polygon_shape(polygon_at(p, i), polygon_at(p, (i + 2) % 4), polygon_at(p, (i + 3) % 4), n);
	return fmin(dot3(m, side), dot3(n, side));
}

/* Splits by the diagonal for which the smaller of the two shapes is larger.  The cross product of the diagonals
 * is the normal of both splits of a flat quad. */
static int
quad(Polygon *p)
{
	double u[3], v[3], side[3], w[3], ac, bd, len;
	int k;

	if (!polygon_edges(polygon_at(p, 0), polygon_at(p, 2), polygon_at(p, 1), u, w) ||
	    !polygon_edges(polygon_at(p, 1), polygon_at(p, 3), polygon_at(p, 0), v, w))
		return 0;
	cross3(u, v, side);
	len = norm3(side);
	if (!(len > POLYGON_FLAT))
		return 0;
	for (k = 0; k < 3; k++)
		side[k] /= len;
	ac = smaller_shape(p, 0, side);
	bd = smaller_shape(p, 1, side);
	if (bd > ac) {
		polygon_put(p, 1, 2, 3);
		polygon_put(p, 1, 3, 0);
	} else {
		polygon_put(p, 0, 1, 2);
		polygon_put(p, 0, 2, 3);
	}
	return larger(ac, bd) > POLYGON_FLAT;
}

/* A vertex that occurs twice in face f, or -1; mark[v] is the last face that had v. */
static int
repeated_vertex(const Soup *s, int f, int *mark)
{
	int i;

	for (i = s->first[f]; i < s->first[f+1]; i++) {
		if (mark[s->idx[i]] == f)
			return s->idx[i];
		mark[s->idx[i]] = f;
	}
	return -1;
}

/* Counts the triangles after splitting, and the corners of the largest face. */
static int
count_triangles(const Soup *s, int *mark, size_t *ntri, int *most, char *err)
{
	int f, n, v;

	*ntri = 0;
	*most = 4;
	memset(mark, -1, (size_t)s->nv * sizeof *mark);
	for (f = 0; f < s->nf; f++) {
		n = s->first[f+1] - s->first[f];
		if (n < 3 || n > MAXCORNERS)
			return mesh_fail(err, MESH_EFACE, n < 3 ? "face %d has only %d corners" :
			    "face %d has %d corners, more than %d", f, n, MAXCORNERS);
		if ((v = repeated_vertex(s, f, mark)) >= 0)
			return mesh_fail(err, MESH_EFACE, "face %d has vertex %d twice", f, v);
		*ntri += (size_t)n - 2;
		*most = n > *most ? n : *most;
	}
	if (*ntri > INT_MAX / 3)
		return mesh_fail(err, MESH_ENOMEM, "no memory for %zu triangles", *ntri);
	return 0;
}

static int
splitall(const Soup *s, Polygon *p, char *err)
{
	int f, ok;

	p->xyz = s->xyz;
	for (f = 0; f < s->nf; f++) {
		p->v = s->idx + s->first[f];
		p->n = s->first[f+1] - s->first[f];
		ok = p->n == 3 ? triangle(p) : p->n == 4 ? quad(p) : polygon_clip(p);
		if (!ok)
			return mesh_fail(err, MESH_EFACE, p->n == 3 ? "face %d has no area" :
			    "face %d, of %d corners, cannot be split into triangles of some area",
			    f, p->n);
	}
	return 0;
}

int
polygon_split(const Soup *s, int **tri, int *ntri, char err[MESH_ERRLEN])
{
	Polygon p = { 0 };
	int *mark, *out = NULL, most, e = MESH_ENOMEM;
	size_t n;

	mark = mesh_alloc(err, (size_t)s->nv, sizeof *mark);
	if (!mark)
		return MESH_ENOMEM;
	if ((e = count_triangles(s, mark, &n, &most, err)) == 0) {
		p.tri = out = mesh_alloc(err, n, 3 * sizeof *out);
		p.flat = mesh_alloc(err, (size_t)most, sizeof *p.flat);
		p.next = mesh_alloc(err, (size_t)most, sizeof *p.next);
		p.prev = mesh_alloc(err, (size_t)most, sizeof *p.prev);
		e = out && p.flat && p.next && p.prev ? splitall(s, &p, err) : MESH_ENOMEM;
		*ntri = (int)n;
	}
	free(mark);
	free(p.flat);
	free(p.next);
	free(p.prev);
	if (e)
		free(out);
	else
		*tri = out;
	return e;
}
