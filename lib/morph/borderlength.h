/* borderlength.h - brings the conformal factor of a blend to the length of its border.
 *
 * The border of a blend is blended in space, where lengths shorten between curves of different direction;
 * lambda is not.  On the border both should say the same.  Let l be the length of the border beside a node
 * and l_k that of surface k, with weight w_k.  Then log lambda gains the harmonic function e with
 *
 *   Delta e = 0,      e = log l - sum w_k log l_k on the border,
 *
 * which leaves lambda^2 K (10) as it is.  e is 0 for a single surface.  doc/mathematics.md 8.1. */
#ifndef BORDERLENGTH_H
#define BORDERLENGTH_H

#include "../grid/border.h"

enum { BORDERLENGTH_ENOMEM = -1 };

/* Sets e, [nv][nu], between -2 and 2, from the borders of `count` surfaces and of their blend, all measured
 * (border_measure), on charts of equal kind and size with at least 3 nodes in each direction; of smaller ones e = 0.
 * The weights sum to 1.  Returns 0 or BORDERLENGTH_ENOMEM. */
int borderlength(int count, const double *w, const Border *const *of, const Border *blend, double *e);

#endif
