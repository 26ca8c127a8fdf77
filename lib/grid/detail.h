/* detail.h - the part of a mesh that a grid does not hold: the offset of each vertex from its place
 * on the gridded surface, in a frame that moves, turns and grows with the surface.
 *
 * The place of a vertex is the point of the gridded surface at its (u,v) (gridpoint.h).  The frame
 * there is made from means over a window of the chart round (u,v).  The window is a square of half
 * side r, at least one cell, cut off at the border.  On another grid, of height T' instead of T,
 * its half height is r T'/T:
 *
 *   a, b    the means of phi_u and phi_v; they depend on phi at the sides of the window only, so a
 *           limb or a fold inside it has no influence
 *   e1, e2  orthonormal in the plane of a and b; e1 is as far from a as e2 is from b
 *   n       e1 x e2
 *   s       the square root of the mean of lambda^2
 *
 *   vertex = place + s (o[0] e1 + o[1] e2 + o[2] n)
 *
 * o has no unit: it is a length in the chart.  The longer the offset, the larger the window: the
 * square root of its area on the surface is DETAIL_REACH times the length of the offset.  So a
 * short offset (detail between the nodes) follows the nearest cells.  A limb that the grid has lost
 * follows the surface round its root, and all its vertices have almost the same frame.
 */
#ifndef DETAIL_H
#define DETAIL_H

#include "../base/chart.h"

#define DETAIL_REACH 2          /* side of the window / length of the offset, on the surface */

enum { DETAIL_ENOMEM = -1 };

enum { DETAIL_SIZE = 4 };       /* numbers of a vertex: o[0] o[1] o[2] r */

typedef struct Detail {
	Chart g;
	const double *const *phi;
	double (*sum)[7];       /* [nv][nu] integrals of phi_u, phi_v, lambda^2 over [0,u] x [0,v] */
} Detail;

/* phi: x y z, each [g.nv][g.nu], at least 2 x 2; must outlive d.  Returns 0 or DETAIL_ENOMEM. */
int  detail_init(Detail *d, Chart g, const double *const phi[3]);
void detail_free(Detail *d);

/* The offset o of a vertex at position x whose place in the chart is (u,v). */
void detail_offset(const Detail *d, double u, double v, const double x[3], double o[DETAIL_SIZE]);

/* The position x of the vertex with place (u,v) and offset o.  T is the height of the rectangle for
 * which detail_offset computed o.  Where the surface defines no frame (it has shrunk to a line,
 * say), some orthonormal frame is taken. */
void detail_vertex(const Detail *d, double T, double u, double v, const double o[DETAIL_SIZE],
	double x[3]);

#endif
