/* corner.c - the surroundings of the corners of a chart. */
#include <math.h>

#include "corner.h"

static const double NEAR = 0.3;
enum { RADIUS = 10 };

int
corner_radius(Chart g)
{
	int third = ((g.nu < g.nv ? g.nu : g.nv) - 1)/3;

	return third < RADIUS ? third : RADIUS;
}

/* Steps from node i of n to the nearer open side; HUGE_VAL if both are joined. */
static double
steps(const int joined[2], int n, int i)
{
	double low = joined[0] ? HUGE_VAL : i, high = joined[1] ? HUGE_VAL : n - 1 - i;

	return low < high ? low : high;
}

double
corner_fade(double r)
{
	double x = (r - NEAR)/(1 - NEAR);

	return x <= 0 ? 1 : x < 1 ? 1 - x*x*(3 - 2*x) : 0;
}

double
corner_share_within(Chart g, int radius, int i, int j)
{
	return corner_fade(hypot(steps(g.kind->joined[0], g.nu, i), steps(g.kind->joined[1], g.nv, j))/radius);
}

double
corner_share(Chart g, int i, int j)
{
	return corner_share_within(g, corner_radius(g), i, j);
}
