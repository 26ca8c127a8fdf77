/* borderpart.h - the part of a field that its values on the border determine: the harmonic function
 * with these values. */
#ifndef BORDERPART_H
#define BORDERPART_H

#include "../base/chart.h"

enum { BORDERPART_ENOMEM = -1 };

/* Sets h[c] to f[c] on the border of the rectangle g and inside to the solution of Delta h = 0, by
 * five points, for `count` fields [nv][nu], at most 3.  g has at least 3 nodes in each direction.
 * Returns 0 or BORDERPART_ENOMEM. */
int border_part(Chart g, int count, const double *const f[], double *const h[]);

#endif
