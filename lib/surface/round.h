/* round.h - the round surface of a chart, which is 0 where every lambda on the chart is 0.
 *
 * At a cone lambda goes to 0 like the distance, whatever the surface, and says nothing of it.  So
 * whatever depends on the size or on the slope of lambda uses lambda/lambda0 (chart.h). */
#ifndef ROUND_H
#define ROUND_H

#include "../base/chart.h"

enum { ROUND_ENOMEM = -1 };

/* Sets *r to lambda0^2 at the nodes over its mean, [nv][nu], to be freed; to NULL where lambda0 = 1 (the
 * rectangle), or if there is no memory.  Returns 0 or ROUND_ENOMEM. */
int round2(Chart g, double **r);

#endif
