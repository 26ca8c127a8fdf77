/* detail.h - the part of a mesh that a grid does not hold: the offset of each vertex from its place
 * on the gridded surface, in a frame that moves, turns and grows with the surface.
 *
 * The place of a vertex is the point of the gridded surface at its (u,v) (gridpoint.h).  The frame
 * there is made from means over a window of the chart round (u,v).  The window is a square of half
 * side r, extended to at least one cell on each side of (u,v) and cut off at the border.  On another
 * grid, of height T' instead of T, its half height is r T'/T.  The frame is
 *
 *   a, b    the means of phi_u and phi_v; they depend on phi at the sides of the window only, so a
 *           limb or a fold inside it has no influence
 *   e1, e2  orthonormal in the plane of a and b; the angle between e1 and a equals that between
 *           e2 and b
 *   n       e1 x e2
 *   s       the square root of the mean of lambda^2, the scale
 *
 * and the offset o of the vertex is defined by
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

#define DETAIL_REACH 2          /* side of the window divided by length of the offset, on the surface */

enum { DETAIL_ENOMEM = -1 };

enum { DETAIL_SIZE = 4 };       /* numbers stored for a vertex: o[0] o[1] o[2] r */

typedef struct Detail {
	Chart g;
	const double *const *phi;
	double (*sum)[7];       /* [nv][nu] integrals of phi_u, phi_v, lambda^2 over [0,u] x [0,v] */
} Detail;

/* Prepares d for the grid phi: x y z, each [g.nv][g.nu], at least 2 x 2; phi must outlive d.  Returns
 * 0, or DETAIL_ENOMEM with nothing to free. */
int  detail_init(Detail *d, Chart g, const double *const phi[3]);
void detail_free(Detail *d);

/* Computes the offset o, with r, of the vertex at position x whose place in the chart is (u,v). */
void detail_offset(const Detail *d, double u, double v, const double x[3], double o[DETAIL_SIZE]);

/* Computes the position x of the vertex with place (u,v) and offset o.  T is the height of the
 * rectangle for which detail_offset computed o.  Where the surface defines no frame, for example
 * because it has shrunk to a line, an arbitrary orthonormal frame is used. */
void detail_vertex(const Detail *d, double T, double u, double v, const double o[DETAIL_SIZE],
	double x[3]);

#endif
