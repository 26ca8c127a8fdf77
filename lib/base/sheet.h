/* sheet.h - the images of a point of the sock's chart (chart.h).
 *
 * Continued across the fold and round the period, the chart covers the strip |v| <= T twice: (u,v),
 * (-u,-v) and (u+1,v) are the same point.  The images of (u,v) are (sign u + shift, sign v), one for
 * each Sheet.  The turns by pi about the cones (0,0) and (1/2,0) are { -1, 0 } and { -1, 1 }.
 */
#ifndef SHEET_H
#define SHEET_H

#include <math.h>

typedef struct Sheet {
	signed char sign;       /* 1 or -1 */
	int         shift;
} Sheet;

static inline double
sheet_u(Sheet s, double u)
{
	return s.sign*u + s.shift;
}

static inline double
sheet_v(Sheet s, double v)
{
	return s.sign*v;
}

/* First b, then a. */
static inline Sheet
sheet_compose(Sheet a, Sheet b)
{
	return (Sheet){ a.sign*b.sign, a.sign*b.shift + a.shift };
}

static inline Sheet
sheet_inverse(Sheet a)
{
	return (Sheet){ a.sign, -a.sign*a.shift };
}

/* The sheet of the image of (u,v) that is nearest to the point (x,y). */
static inline Sheet
sheet_nearest(double u, double v, double x, double y)
{
	Sheet same = { 1, (int)floor(x - u + 0.5) }, turned = { -1, (int)floor(x + u + 0.5) };

	return hypot(sheet_u(turned, u) - x, sheet_v(turned, v) - y) <
	    hypot(sheet_u(same, u) - x, sheet_v(same, v) - y) ? turned : same;
}

/* The images of the n corners (u,v) of a polygon, n >= 1, that lie on one sheet: of those nearest to the
 * point of one corner, the images whose perimeter is least.  To a corner at a cone both images of
 * another are equally near, so that corner cannot decide. */
void sheet_polygon(int n, const double *u, const double *v, Sheet *s);

#endif
