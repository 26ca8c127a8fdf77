/* subdivision.h - points added to a disk as vertices; the surface stays the same. */
#ifndef SUBDIVISION_H
#define SUBDIVISION_H

#include "mesh.h"

/* A point of a disk. */
typedef struct SurfacePoint {
	int    triangle;
	double w[3];            /* barycentric coordinates; on a side of the triangle one is 0 */
} SurfacePoint;

/* A disk made of another one by adding points.  Its first vertices are those of the given disk;
 * each of the others lies in a flat triangle of three vertices of lower number. */
typedef struct Subdivision {
	Disk    d;
	int     given;          /* number of vertices of the given disk */
	int   (*corner)[3];     /* [d.m.nv - given] the triangle that each new vertex lies in */
	double (*w)[3];         /* [d.m.nv - given] its barycentric coordinates there */
	unsigned char *inner;   /* [3*d.m.nf] 1: the side lies within a face of the given disk */
} Subdivision;

/* Sets s to a copy of d, without new vertices.  Channels, note and err are not copied.
 * Returns 0, or MESH_ENOMEM with nothing in s to free. */
int  subdivision_init(Subdivision *s, const Disk *d);
void subdivision_free(Subdivision *s);

/* The point at `place`, 0..1 from the start of a side.  Side 3*t + k of triangle t runs from corner
 * k to the next. */
SurfacePoint subdivision_on_side(int side, double place);

/* Adds the points to s as vertices: first those within triangles, then those on edges.  A point
 * within a triangle splits it into three; a point on an edge splits each triangle at that edge into
 * two.  The new triangles may be arbitrarily thin.  Points at a vertex are not added.  Of points on
 * an edge that are equal up to 1e-9 of the edge, or within a triangle up to 1e-9 of its parts, one is added.
 *
 * n, point  in   points of s->d
 *
 * Returns the number of new vertices, or MESH_ENOMEM, after which s is only to be freed. */
int  subdivision_add(Subdivision *s, int n, const SurfacePoint *point);

/* Splits faces as refine_split does.  inner becomes NULL.
 *
 * marked, key  in   as for refine_split
 * before       out  the disk as it was, to be freed; or NULL
 *
 * Returns 0, or MESH_ENOMEM, after which s is only to be freed. */
int  subdivision_refine(Subdivision *s, const unsigned char *marked, const double *key, Disk *before);

/* Extends numbers at the vertices of the given disk linearly to all vertices.
 *
 * n      numbers per vertex
 * f      in    [given][n]; may be the start of all
 * all    out   [d.m.nv][n] */
void subdivision_extend(const Subdivision *s, int n, const double *f, double *all);

#endif
