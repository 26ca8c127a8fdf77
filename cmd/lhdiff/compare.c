/* compare.c - the values that lhdiff computes. */
#include <float.h>
#include <math.h>

#include "../../lib/mesh/distance.h"
#include "../shared/cmd.h"
#include "compare.h"

/* The area of m.  Dies unless it is positive and so small that products of areas and lengths do not
 * overflow. */
static double
area(const char *place, const Mesh *m)
{
	double a = mesh_area(m);

	if (!(a > 0))
		die("%s: surface has no area", place);
	if (!(a < sqrt(DBL_MAX)))
		die("%s: area %g is too large to compare", place, a);
	return a;
}

static double
crossings(const char *place, const Mesh *m)
{
	long pairs = 0;

	cmd_progress("%s: self-intersections of %d faces", place, m->nf);
	switch (distance_crossings(m, &pairs)) {
	case 0: break;
	case DISTANCE_ENOMEM: die("no memory for the self-intersections");
	case DISTANCE_EEDGE:
		note("%s: not a manifold: self-intersections are not counted", place);
		return -1;
	default: die("%s: self-intersections cannot be found", place);
	}
	return (double)pairs;
}

void
compare_side(const Compare *c, const char *place, Side *s)
{
	s->area = area(place, &s->m);
	s->crossings = c->cross ? crossings(place, &s->m) : -1;
}

static double
hausdorff(const Mesh *a, const Mesh *b, double error)
{
	double d;

	cmd_progress("Hausdorff distance of %d and %d faces", a->nf, b->nf);
	switch (distance_hausdorff(a, b, error, &d)) {
	case 0: return d;
	case DISTANCE_ENOMEM: die("no memory for the Hausdorff distance");
	case DISTANCE_EAREA: die("all faces of a surface have zero area");
	default: die("the Hausdorff distance cannot be computed to %g", error);
	}
}

void
compare(const Compare *c, const Side *a, const Side *b, double value[COMPARE_N])
{
	double unit = sqrt(a->area);
	int i;

	for (i = 0; i < COMPARE_N; i++)
		value[i] = -1;
	value[COMPARE_AREA_A] = a->area;
	value[COMPARE_AREA_B] = b->area;
	if (a->m.nv == b->m.nv) {
		distance_vertices(&a->m, &b->m, &value[COMPARE_MAX], &value[COMPARE_MEAN]);
		value[COMPARE_MAX_REL] = value[COMPARE_MAX]/unit;
		value[COMPARE_MEAN_REL] = value[COMPARE_MEAN]/unit;
	}
	if (c->far) {
		value[COMPARE_ERROR] = c->error*unit;
		value[COMPARE_HAUSDORFF] = hausdorff(&a->m, &b->m, value[COMPARE_ERROR]);
		value[COMPARE_HAUSDORFF_REL] = value[COMPARE_HAUSDORFF]/unit;
	}
	value[COMPARE_CROSS_A] = a->crossings;
	value[COMPARE_CROSS_B] = b->crossings;
}
