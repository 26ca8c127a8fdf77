/* mkpillow.c - closed surfaces on the pillow, for pillow.bats:
 *
 *   mkpillow sphere|egg|pear NU NV T     writes a grid with channels x y z to stdout
 *
 * The unit sphere; the sphere stretched to twice its height, which is not conformal; pillowball.h. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../format/lhg.h"
#include "pillowball.h"

static void
place(const char *shape, const PillowPlane *p, double u, double v, double x[3])
{
	Node a;

	if (strcmp(shape, "pear") == 0) {
		pillowpear(p, u, v, x);
		return;
	}
	a = pillowsphere(p, u, v);
	memcpy(x, a.x, sizeof a.x);
	if (strcmp(shape, "egg") == 0)
		x[2] *= 2;
}

int
main(int argc, char *argv[])
{
	static const char *const name[3] = { "x", "y", "z" };
	double *f[3], x[3];
	PillowPlane plane;
	LhgStream s;
	Chart g;
	Lhg out;
	int p, c;

	if (argc != 5)
		return 2;
	g = (Chart){ atoi(argv[2]), atoi(argv[3]), atof(argv[4]), &CHART_PILLOW };
	plane = pillowplane(g.T);
	lhg_init(&out, g.nu, g.nv, g.T);
	out.chart = LHG_PILLOW;
	for (c = 0; c < 3; c++)
		if (!(f[c] = lhg_add(&out, name[c], "length", LHG_GRID, 0)))
			return 1;
	for (p = 0; p < g.nu*g.nv; p++) {
		place(argv[1], &plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu), x);
		for (c = 0; c < 3; c++)
			f[c][p] = x[c];
	}
	lhg_open(&s, stdout);
	c = lhg_write(&s, &out);
	lhg_free(&out);
	return c != 0;
}
