/* compare.c - the numbers of lhdiff. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "../lib/distance.h"
#include "cmd.h"
#include "compare.h"

static const char *const name[] = { "area_a", "area_b", "max", "mean", "max_rel", "mean_rel",
	"hausdorff", "hausdorff_error", "hausdorff_rel", "self_intersections_a",
	"self_intersections_b" };

/* Squares and products of such areas and lengths stay finite. */
static double
area(const char *path, const Mesh *m)
{
	double a = mesh_area(m);

	if (!(a > 0))
		die("%s: surface has no area", cmd_name_of(path));
	if (!(a < sqrt(DBL_MAX)))
		die("%s: area %g is too large to compare", cmd_name_of(path), a);
	return a;
}

static void
hausdorff(const Mesh *a, const Mesh *b, double value[COMPARE_N])
{
	cmd_progress("Hausdorff distance of %d and %d faces", a->nf, b->nf);
	switch (distance_hausdorff(a, b, value[COMPARE_ERROR], &value[COMPARE_HAUSDORFF])) {
	case 0: break;
	case DISTANCE_ENOMEM: die("no memory for the Hausdorff distance");
	case DISTANCE_EAREA: die("no face has an area");
	default: die("the Hausdorff distance cannot be computed to %g", value[COMPARE_ERROR]);
	}
}

static double
crossings(const char *path, const Mesh *m)
{
	long pairs = 0;

	cmd_progress("self-intersections of %d faces", m->nf);
	switch (distance_crossings(m, &pairs)) {
	case 0: break;
	case DISTANCE_ENOMEM: die("no memory for the self-intersections");
	case DISTANCE_EEDGE: die("%s: not manifold without its faces of no area", cmd_name_of(path));
	default: die("%s: self-intersections cannot be found", cmd_name_of(path));
	}
	return (double)pairs;
}

void
compare(const char *const path[2], const Mesh *a, const Mesh *b, double error, int far, int cross,
	double value[COMPARE_N])
{
	double unit;
	int i;

	for (i = 0; i < COMPARE_N; i++)
		value[i] = -1;
	value[COMPARE_AREA_A] = area(path[0], a);
	value[COMPARE_AREA_B] = area(path[1], b);
	unit = sqrt(value[COMPARE_AREA_A]);
	if (a->nv == b->nv) {
		distance_vertices(a, b, &value[COMPARE_MAX], &value[COMPARE_MEAN]);
		value[COMPARE_MAX_REL] = value[COMPARE_MAX]/unit;
		value[COMPARE_MEAN_REL] = value[COMPARE_MEAN]/unit;
	} else
		note("%d and %d vertices: no max and mean", a->nv, b->nv);
	if (far) {
		value[COMPARE_ERROR] = error*unit;
		hausdorff(a, b, value);
		value[COMPARE_HAUSDORFF_REL] = value[COMPARE_HAUSDORFF]/unit;
	}
	if (cross) {
		value[COMPARE_CROSS_A] = crossings(path[0], a);
		value[COMPARE_CROSS_B] = crossings(path[1], b);
	}
}

void
compare_print(const double value[COMPARE_N], int json)
{
	char *bytes = NULL;
	const char *sep = "{ ";
	size_t n;
	FILE *f = open_memstream(&bytes, &n);
	int i;

	for (i = 0; f && i < COMPARE_N; i++) {
		if (value[i] < 0)
			continue;
		if (!(value[i] <= DBL_MAX))
			die("%s is not finite", name[i]);
		if (json)
			fprintf(f, "%s\"%s\": %.17g", sep, name[i], value[i]);
		else
			fprintf(f, "%s %.9g\n", name[i], value[i]);
		sep = ", ";
	}
	if (f && json)
		fputs(" }\n", f);
	if (!f || fclose(f))
		die("no memory");
	cmd_emit(NULL, bytes, n);
	free(bytes);
}
