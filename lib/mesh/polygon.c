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

int
polygon_has_area(const double *a, const double *b, const double *c)
{
	double n[3];

	polygon_shape(a, b, c, n);
	return norm3(n) > POLYGON_FLAT;
}

static int
triangle(Polygon *p)
{
	polygon_put(p, 0, 1, 2);
	return polygon_has_area(polygon_at(p, 0), polygon_at(p, 1), polygon_at(p, 2));
}

/* The smaller of the shapes of triangles i i+1 i+2 and i i+2 i+3, measured along the normal of the
 * quad. */
static double
smaller_shape(const Polygon *p, int i, const double side[3])
{
	double m[3], n[3];

	polygon_shape(polygon_at(p, i), polygon_at(p, i + 1), polygon_at(p, (i + 2) % 4), m);
	polygon_shape(polygon_at(p, i), polygon_at(p, (i + 2) % 4), polygon_at(p, (i + 3) % 4), n);
	return fmin(dot3(m, side), dot3(n, side));
}

/* Splits by the diagonal for which the smaller of the two shapes is larger.  In a flat quad the
 * cross product of the diagonals is normal to the triangles of both splits. */
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

/* Checks the number of corners of face f, and that none is repeated.  Returns 0, or MESH_EFACE with
 * the reason in err. */
static int
check_corners(const Soup *s, int f, int *mark, char *err)
{
	int n = s->first[f+1] - s->first[f], v;

	if (n < 3 || n > MAXCORNERS)
		return mesh_fail(err, MESH_EFACE, n < 3 ? "face %d has only %d corners" :
		    "face %d has %d corners, more than %d", f, n, MAXCORNERS);
	if ((v = repeated_vertex(s, f, mark)) >= 0)
		return mesh_fail(err, MESH_EFACE, "face %d has vertex %d twice", f, v);
	return 0;
}

/* A soup being split.  Faces that cannot be split are left out if `some` is set;
 * otherwise the first of them ends the work. */
typedef struct Splitting {
	const Soup *s;
	int   some, out;
	char *skip;             /* [nf] left out */
	char *err;              /* [MESH_ERRLEN] the first fault */
} Splitting;

/* Records that face f has the error e.  Returns e, or 0 if the face is left out. */
static int
leave_out(Splitting *w, int f, int e, const char *reason)
{
	if (w->out++ == 0)
		memcpy(w->err, reason, MESH_ERRLEN);
	w->skip[f] = 1;
	return w->some ? 0 : e;
}

/* Checks the corners of all faces.  Counts the triangles that the faces will give; most: out, the
 * largest number of corners of a face, at least 4.  Returns 0 or the error. */
static int
count_triangles(Splitting *w, int *mark, size_t *ntri, int *most)
{
	char reason[MESH_ERRLEN];
	int f, n, e;

	*ntri = 0;
	*most = 4;
	memset(mark, -1, (size_t)w->s->nv * sizeof *mark);
	for (f = 0; f < w->s->nf; f++) {
		if ((e = check_corners(w->s, f, mark, reason)) != 0) {
			if ((e = leave_out(w, f, e, reason)) != 0)
				return e;
			continue;
		}
		n = w->s->first[f+1] - w->s->first[f];
		*ntri += (size_t)n - 2;
		*most = n > *most ? n : *most;
	}
	if (*ntri > INT_MAX / 3)
		return mesh_fail(w->err, MESH_ENOMEM, "no memory for %zu triangles", *ntri);
	return 0;
}

static int
split_face(const Soup *s, int f, Polygon *p, char *err)
{
	int *start = p->tri, ok;

	p->v = s->idx + s->first[f];
	p->n = s->first[f+1] - s->first[f];
	ok = p->n == 3 ? triangle(p) : p->n == 4 ? quad(p) : polygon_clip(p);
	if (ok)
		return 0;
	p->tri = start;
	return mesh_fail(err, MESH_EFACE, p->n == 3 ? "face %d has no area" :
	    "face %d, of %d corners, cannot be split into triangles of some area", f, p->n);
}

static int
split_all(Splitting *w, Polygon *p)
{
	char reason[MESH_ERRLEN];
	int f, e;

	p->xyz = w->s->xyz;
	for (f = 0; f < w->s->nf; f++)
		if (!w->skip[f] && (e = split_face(w->s, f, p, reason)) != 0 &&
		    (e = leave_out(w, f, e, reason)) != 0)
			return e;
	return 0;
}

static int
split(Splitting *w, int **tri, int *ntri)
{
	Polygon p = { 0 };
	int *mark, *out = NULL, most, e = MESH_ENOMEM;
	size_t n;

	mark = mesh_alloc(w->err, (size_t)w->s->nv, sizeof *mark);
	w->skip = mesh_alloc(w->err, (size_t)w->s->nf, 1);
	if (mark && w->skip) {
		memset(w->skip, 0, (size_t)w->s->nf);
		e = count_triangles(w, mark, &n, &most);
	}
	if (e == 0) {
		p.tri = out = mesh_alloc(w->err, n, 3 * sizeof *out);
		p.flat = mesh_alloc(w->err, (size_t)most, sizeof *p.flat);
		p.next = mesh_alloc(w->err, (size_t)most, sizeof *p.next);
		p.prev = mesh_alloc(w->err, (size_t)most, sizeof *p.prev);
		e = out && p.flat && p.next && p.prev ? split_all(w, &p) : MESH_ENOMEM;
	}
	free(mark);
	free(w->skip);
	free(p.flat);
	free(p.next);
	free(p.prev);
	if (e) {
		free(out);
		return e;
	}
	*tri = out;
	*ntri = (int)((p.tri - out)/3);
	return 0;
}

int
polygon_split(const Soup *s, int **tri, int *ntri, char err[MESH_ERRLEN])
{
	Splitting w = { .s = s, .err = err };

	return split(&w, tri, ntri);
}

int
polygon_split_some(const Soup *s, int **tri, int *ntri, int *out, char err[MESH_ERRLEN])
{
	Splitting w = { .s = s, .some = 1, .err = err };
	int e = split(&w, tri, ntri);

	*out = w.out;
	return e;
}
