/* intrinsic.h - an intrinsic triangulation of a disk: its edges are straight lines within the
 * surface, known by their lengths and the areas and dot products of the triangles (doc/mathematics.md 3.6).
 *
 * Its connectivity changes only by flips, so it has the vertices of the mesh, and as many edges and
 * triangles as the mesh.
 */
#ifndef INTRINSIC_H
#define INTRINSIC_H

#include "../mesh/subdivision.h"

enum { INTRINSIC_ENOMEM = -1 };

/* Lengths in units of the longest edge.  Shorter edges than FINEST get the length FINEST, because
 * their true length is lost in the rounding of coordinates.  Edges up to the length SHORTEST are
 * not split. */
#define INTRINSIC_FINEST   1e-10
#define INTRINSIC_SHORTEST 1e-9

/* Side 3*t + k of triangle t runs from its corner k to the next.  Edge e has the direction of
 * side[e]. */
typedef struct Intrinsic {
	int     nv, nf, ne;
	int    *from;           /* [3*nf] the vertex at which a side starts */
	int    *twin;           /* [3*nf] the side across, -1 on the boundary */
	int    *edge;           /* [3*nf] the edge of a side */
	int    *side;           /* [ne] the side that gives an edge its direction */
	double *length;         /* [ne] in units of the longest edge of the mesh */
	double *area;           /* [nf] in the square of that unit; lengths alone tell little of the height of
	                         * a flat triangle, */
	double *dot;            /* [3*nf] nor of the angles at a short side: dot product of side 3*t + k with the
	                         * step from its start to the third corner */
	int    *mesh_side;      /* [ne] one side of each mesh edge, numbered as in the disk */
	int    *mesh_from;      /* [ne] the vertex at which that side starts */
	int    *along;          /* [ne] the mesh edge that coincides with this edge, or -1 */
	int   **crossing;       /* [ne] mesh edges that cross this edge, in order from its start;
	                         * NULL if crossings are not recorded */
	int    *crossings;      /* [ne] how many mesh edges cross each edge */
} Intrinsic;

/* The triangulation of the mesh itself.  Lengths are in units of the longest edge.
 *
 * Returns 0 or INTRINSIC_ENOMEM; t then holds nothing to free. */
int  intrinsic_init(Intrinsic *t, const Disk *d);

/* The same for the disk of a subdivision.  Lengths near vertices of the given disk have the relative
 * errors of the barycentric coordinates, also where they are far shorter than the coordinates in
 * R^3. */
int  intrinsic_init_subdivision(Intrinsic *t, const Subdivision *s);
void intrinsic_free(Intrinsic *t);

static inline int
intrinsic_next(int side)
{
	return side%3 == 2 ? side - 2 : side + 1;
}

static inline int
intrinsic_last(int side)
{
	return side%3 == 0 ? side + 2 : side - 1;
}

/* The two ends of edge e. */
static inline void
intrinsic_ends(const Intrinsic *t, int e, int end[2])
{
	end[0] = t->from[t->side[e]];
	end[1] = t->from[intrinsic_next(t->side[e])];
}

static inline double
intrinsic_length(const Intrinsic *t, int side)
{
	return t->length[t->edge[side]];
}

/* The area of the triangle with sides a, b, c; accurate for thin ones (Kahan). */
double intrinsic_area(double a, double b, double c);

/* The cotangent of the angle opposite to a side as the quotient above/below.  below is 0 in a flat
 * triangle. */
void intrinsic_cotangent_parts(const Intrinsic *t, int side, double *above, double *below);

/* The cotangent of the angle opposite to a side; at most 1e10 in modulus. */
double intrinsic_cotangent(const Intrinsic *t, int side);

/* Sets the area and the dot products of triangle f by its lengths. */
void intrinsic_set_by_lengths(Intrinsic *t, int f);

/* Computes the foot of the perpendicular from the corner opposite to a side.  Returns the signed
 * distance of the foot from the start of the side.  The foot lies outside the side if an angle at
 * the side is obtuse.  *height is the length of the perpendicular. */
double intrinsic_foot(const Intrinsic *t, int side, double *height);

#endif
