/* cones.h - the two cones of a sock, chosen so that its cells are as equal on the surface as they can be.
 *
 * Given a conformal map of the surface onto the unit disk, the cells of a sock have the areas
 *
 *   a ~ S/(|z - a| |z - b| |1 - conj(a) z| |1 - conj(b) z|)
 *
 * in the chart, for a part of area A on the surface and S in the disk.  The cones minimise
 *
 *   chi^2 = sum A^2/a sum a/(sum A)^2,
 *
 * which is 1 if all cells are equal on the surface.  The sums are over about sixteen thousand parts of equal
 * area, without those that are smallest in the chart for their area, up to 1 % of the surface.  doc/mathematics.md 3.8.
 */
#ifndef CONES_H
#define CONES_H

#include "../base/cmplx.h"
#include "../mesh/mesh.h"

enum { CONES_ENOMEM = -1 };

/* The parts of a surface: area A on the surface, S in the disk, centre z. */
typedef struct Parts {
	int             n;
	double         *A, *S;
	double complex *z;
} Parts;

/* Parts of m, which z maps onto the unit disk.  Returns 0, or CONES_ENOMEM with nothing to free. */
int  parts_init(Parts *p, const Mesh *m, const double complex *z);
void parts_free(Parts *p);

/* chi^2 of a sock with cones a, b; and of the rectangle with these corners on the unit circle. */
double parts_sock(const Parts *p, double complex a, double complex b);
double parts_rectangle(const Parts *p, const double complex corner[4]);

/* Sets cone to the best cones found from several starts, |cone| < 1, for a height of the sock of
 * CONES_LEAST at least. */
#define CONES_LEAST 0.05
void cones_choose(const Parts *p, double complex cone[2]);

#endif
