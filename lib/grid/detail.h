/* detail.h - what a grid does not hold of a mesh: the offset of each vertex from its place on the
 * gridded surface, in a frame that moves, turns and grows with the surface.
 *
 * The place is the surface at the (u,v) of the vertex (gridpoint.h).  The frame there is made from
 * means over a window of the chart round (u,v), the square of half side r (of height 2 r T'/T on a
 * grid of another height T'), cut at the border, at least a cell to each side:
 *
 *   a, b    the means of phi_u and phi_v: their flux through the sides of the window, so that a limb
 *           or a fold inside it has no influence
 *   e1, e2  orthonormal in the plane of a and b, equally far from both directions
 *   n       e1 x e2
 *   s       the root of the mean of lambda^2
 *
 *   vertex = place + s (o[0] e1 + o[1] e2 + o[2] n)
 *
 * o has no unit: it is a distance in the chart.  The window grows with the offset, until the
 * root of its area is DETAIL_REACH times the length of the offset.  So a short offset, detail between
 * the nodes, follows the nearest cells; a limb that the grid has lost follows its root, and all of it
 * in almost the same frame.
 */
#ifndef DETAIL_H
#define DETAIL_H

#include "../base/chart.h"

#define DETAIL_REACH 2          /* the side of the window, over the length of the offset */

enum { DETAIL_ENOMEM = -1 };

enum { DETAIL_SIZE = 4 };       /* numbers of a vertex: o[0] o[1] o[2] r */

typedef struct Detail {
	Chart g;
	const double *const *phi;
	double (*sum)[7];       /* [nv][nu] integrals over [0,u] x [0,v]: of phi_u, phi_v and lambda^2 */
} Detail;

/* phi: x y z, each [g.nv][g.nu], at least 2 x 2; must outlive d.  Returns 0 or DETAIL_ENOMEM. */
int  detail_init(Detail *d, Chart g, const double *const phi[3]);
void detail_free(Detail *d);

/* The offset o of a vertex at x with that (u,v). */
void detail_offset(const Detail *d, double u, double v, const double x[3], double o[DETAIL_SIZE]);

/* The vertex x with that (u,v) and offset; T is the height of the rectangle of detail_offset.  Where
 * the frame does not exist, as on a surface shrunk to a line, any frame is taken. */
void detail_vertex(const Detail *d, double T, double u, double v, const double o[DETAIL_SIZE],
	double x[3]);

#endif
