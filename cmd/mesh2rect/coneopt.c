/* coneopt.c - the cones of a sock. */
#include <math.h>
#include <string.h>

#include "../shared/cmd.h"
#include "coneopt.h"
#include "vertexlist.h"

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

void
opt_cones(const char *arg, const Disk *d, int cone[2])
{
	VertexList g;
	int k, i;

	cone[0] = cone[1] = -1;
	if (!arg || strcmp(arg, "auto") == 0)
		return;
	if (!vertexlist(arg, 2, &g))
		misuse("--cones=%s: need two vertex numbers or two points x,y,z;x,y,z", arg);
	for (k = 0; k < 2; k++) {
		cone[k] = g.n == 2 ? vertexlist_number(d, "cone", "a face", g.x[k]) : nearest(d, g.x + 3*k);
		for (i = 0; i < d->nb; i++)
			if (d->loop[i] == cone[k])
				die("cone %d is a vertex of the boundary", d->file[cone[k]]);
	}
	if (cone[0] == cone[1])
		die("both cones are vertex %d", d->file[cone[0]]);
}

void
cones_meta(Lhg *out, const Disk *d, const Conformal *c)
{
	cmd_meta(out, "cones", "%d,%d", d->file[c->cone[0]], d->file[c->cone[1]]);
	cmd_meta(out, "chi2", "%.4g", c->chi2[1]);
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
