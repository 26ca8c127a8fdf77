/* area.h - areas and lengths in a sheet.  Private to lib/mend. */
#ifndef AREA_H
#define AREA_H

#include "../base/vec3.h"
#include "sheet.h"

static inline double
sheet_area(const Sheet *s, int f)
{
	const int *t = s->tri + 3*(size_t)f;
	double u[3], v[3], n[3];

	sub3(sheet_at(s, t[1]), sheet_at(s, t[0]), u);
	sub3(sheet_at(s, t[2]), sheet_at(s, t[0]), v);
	cross3(u, v, n);
	return norm3(n)/2;
}

static inline double
sheet_length(const Sheet *s, int side)
{
	double u[3];

	sub3(sheet_at(s, sheet_to(s, side)), sheet_at(s, s->tri[side]), u);
	return norm3(u);
}

#endif
