/* warpturn.h - the rectangle turned by quarters: the four ways to lay one rectangle onto another.
 *
 * After one quarter turn u' = v/T, v' = (1-u)/T, T' = 1/T: the corner (0,0) has become the corner (0,T').
 */
#ifndef WARPTURN_H
#define WARPTURN_H

#include "../base/chart.h"

enum { WARPTURN_WAYS = 4 };

/* The chart g after `turns` quarter turns. */
Chart warpturn_chart(Chart g, int turns);

/* Sets out to f, [g.nv][g.nu], after `turns` quarter turns. */
void warpturn_field(Chart g, int turns, const double *f, double *out);

/* The point (*u,*v) of the chart g, after `turns` quarter turns; and back to g. */
void warpturn_point(Chart g, int turns, double *u, double *v);
void warpturn_back(Chart g, int turns, double *u, double *v);

#endif
