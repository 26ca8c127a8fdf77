/* earclip.c - splits polygons of five corners and more into triangles, by ear clipping. */
#include <math.h>
#include <string.h>

#include "polypriv.h"
#include "../base/vec3.h"

/* Twice the vector area of the polygon, divided by size^2: the sum of the cross products over the
 * triangles 0 i i+1. */
static void
vectorarea(const Polygon *p, double size, double side[3])
{
	double u[3], v[3], n[3];
	int i, k;

	memset(side, 0, 3 * sizeof *side);
	for (i = 1; i + 1 < p->n; i++) {
		for (k = 0; k < 3; k++) {
			u[k] = (polygon_at(p, i)[k] - polygon_at(p, 0)[k]) / size;
			v[k] = (polygon_at(p, i + 1)[k] - polygon_at(p, 0)[k]) / size;
		}
		cross3(u, v, n);
		for (k = 0; k < 3; k++)
			side[k] += n[k];
	}
}

/* Unit vectors e1, e2, perpendicular to each other, with e1 x e2 in the direction of side. */
static void
plane(const double side[3], double e1[3], double e2[3])
{
	double axis[3] = { 0 }, len;
	int k;

	k = fabs(side[0]) < fabs(side[1]) ? 0 : 1;
	axis[fabs(side[2]) < fabs(side[k]) ? 2 : k] = 1;        /* the axis whose angle with side is largest */
	cross3(side, axis, e1);
	len = norm3(e1);
	for (k = 0; k < 3; k++)
		e1[k] /= len;
	cross3(side, e1, e2);
	len = norm3(e2);
	for (k = 0; k < 3; k++)
		e2[k] /= len;
}

/* Projects the corners to the plane perpendicular to the vector area of the polygon, where they run
 * counterclockwise.  Returns 0 if the vector area is 0. */
static int
flatten(Polygon *p)
{
	double side[3], e1[3], e2[3], v[3], size = 0;
	int i, k;

	for (i = 1; i < p->n; i++)
		for (k = 0; k < 3; k++)
			size = fmax(size, fabs(polygon_at(p, i)[k] - polygon_at(p, 0)[k]));
	if (!(size >= POLYGON_TINY && size <= 1/POLYGON_TINY))
		return 0;
	vectorarea(p, size, side);
	if (!(norm3(side) > POLYGON_FLAT))
		return 0;
	plane(side, e1, e2);
	for (i = 0; i < p->n; i++) {
		for (k = 0; k < 3; k++)
			v[k] = (polygon_at(p, i)[k] - polygon_at(p, 0)[k]) / size;
		p->flat[i][0] = dot3(v, e1);
		p->flat[i][1] = dot3(v, e2);
	}
	return 1;
}

/* Twice the signed area of a b c in the plane, divided by its longest edge squared. */
static double
signed_area(const Polygon *p, int a, int b, int c)
{
	const double *A = p->flat[a], *B = p->flat[b], *C = p->flat[c];
	const double ux = B[0] - A[0], uy = B[1] - A[1], vx = C[0] - A[0], vy = C[1] - A[1];
	const double longest2 = fmax(ux*ux + uy*uy, fmax(vx*vx + vy*vy,
	    (vx - ux)*(vx - ux) + (vy - uy)*(vy - uy)));

	return longest2 > 0 ? (ux*vy - uy*vx) / longest2 : 0;
}

/* Whether corner i is an ear: it is convex, its triangle contains no other corner, not even on a
 * side, and the triangle has area in space.  Area is checked in space, too, because the rounding
 * errors in the plane are in proportion to the whole polygon, not to the triangle. */
static int
isear(const Polygon *p, int i)
{
	const int a = p->prev[i], c = p->next[i];
	double n[3];
	int k;

	if (!(signed_area(p, a, i, c) > 2*POLYGON_FLAT))
		return 0;
	for (k = p->next[c]; k != a; k = p->next[k])
		if (signed_area(p, a, i, k) >= -POLYGON_FLAT && signed_area(p, i, c, k) >= -POLYGON_FLAT &&
		    signed_area(p, c, a, k) >= -POLYGON_FLAT)
			return 0;
	polygon_shape(polygon_at(p, a), polygon_at(p, i), polygon_at(p, c), n);
	return norm3(n) > POLYGON_FLAT;
}

/* After each ear the next corner is skipped, which avoids fans and slivers. */
int
polygon_clip(Polygon *p)
{
	int i, left = p->n, misses = 0;

	if (!flatten(p))
		return 0;
	for (i = 0; i < p->n; i++) {
		p->next[i] = (i + 1) % p->n;
		p->prev[i] = (i + p->n - 1) % p->n;
	}
	for (i = 0; left > 2 && misses <= left; i = p->next[i]) {
		if (!isear(p, i)) {
			misses++;
			continue;
		}
		polygon_put(p, p->prev[i], i, p->next[i]);
		p->next[p->prev[i]] = p->next[i];
		p->prev[p->next[i]] = p->prev[i];
		i = p->next[i];
		left--;
		misses = 0;
	}
	return left == 2;
}
