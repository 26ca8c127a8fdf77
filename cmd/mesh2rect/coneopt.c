/* coneopt.c - the cones of a sock or a pillow. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "../shared/cmd.h"
#include "coneopt.h"
#include "vertexlist.h"

static const double NOTED = 10; /* chi^2 of a pillow */

static int
nearest(const Disk *d, const double x[3])
{
	double least = HUGE_VAL, d2;
	int i, c, best = 0;

	for (i = 0; i < d->m.nv; i++) {
		for (d2 = 0, c = 0; c < 3; c++)
			d2 += (d->m.xyz[3*(size_t)i+c] - x[c])*(d->m.xyz[3*(size_t)i+c] - x[c]);
		if (d2 < least) {
			least = d2;
			best = i;
		}
	}
	return best;
}

/* Dies if vertex i is on the boundary, or one of the n cones before. */
static void
check_cone(const Disk *d, int i, int n, const int *cone)
{
	int k;

	for (k = 0; k < d->nb; k++)
		if (d->loop[k] == i)
			die("cone %d is a vertex of the boundary", d->file[i]);
	for (k = 0; k < n; k++)
		if (cone[k] == i)
			die("%s cones are vertex %d", d->nb ? "both" : "two", d->file[i]);
}

void
opt_cones(const char *arg, const Disk *d, int cone[3])
{
	int k, count = d->nb ? 2 : 3;
	VertexList g;

	for (k = 0; k < 3; k++)
		cone[k] = -1;
	if (!arg || strcmp(arg, "auto") == 0)
		return;
	if (!vertexlist(arg, count, &g))
		misuse("--cones=%s: need %s vertex numbers or %s points x,y,z;x,y,z%s", arg, d->nb ? "two" : "three",
		    d->nb ? "two" : "three", d->nb ? "" : ";x,y,z on a closed surface, whose fourth cone follows");
	for (k = 0; k < count; k++) {
		cone[k] = g.n == count ? vertexlist_number(d, "cone", "a face", g.x[k]) : nearest(d, g.x + 3*k);
		check_cone(d, cone[k], k, cone);
	}
}

/* The cones as numbers in the file, separated by commas. */
static const char *
list(const Disk *d, const Conformal *c, char text[64])
{
	int k, n = c->grid.g.kind->cones, at = 0;

	for (k = 0; k < n; k++)
		at += snprintf(text + at, 64 - at, k ? ",%d" : "%d", d->file[c->cone[k]]);
	return text;
}

void
cones_meta(Lhg *out, const Disk *d, const Conformal *c)
{
	char text[64];

	if (!c->grid.g.kind->cones)
		return;
	cmd_meta(out, "cones", "%s", list(d, c, text));
	cmd_meta(out, "chi2", "%.4g", c->chi2[1]);
}

void
cones_chi2(const char *mesh, const Disk *d, const Conformal *c)
{
	double chi2 = c->chi2[1];
	char text[64];

	if (!c->grid.g.kind->closed)
		return;
	detail("%s: cones at or near the vertices %s, of which the fourth follows from the others; chi^2 %.3g", mesh,
	    list(d, c, text), chi2);
	if (chi2 > NOTED)
		note("%s: chi^2 %.3g: parts of the surface get few nodes; three tips of limbs as --cones may serve better",
		    mesh, chi2);
}

int
cones_help(const Conformal *c)
{
	return c->grid.g.kind == &CHART_RECTANGLE && c->chi2[1] > 0 && c->chi2[0] > CONFORMAL_CLEARLY*c->chi2[1];
}

void
cones_note(const char *mesh, const Conformal *c, int noted)
{
	if (c->chi2[1] > 0 && c->grid.g.kind == &CHART_RECTANGLE)
		detail("%s: chi^2 %.3g on this rectangle, %.3g on a sock", mesh, c->chi2[0], c->chi2[1]);
	if (cones_help(c) && !noted)
		note("%s: limbs are small on the rectangle (chi^2 %.3g); --chart=sock holds them far better (%.3g)", mesh,
		    c->chi2[0], c->chi2[1]);
}
