/* loss.c - reports how much of the mesh the grid of mesh2rect does not represent. */
#include <stdio.h>

#include "../../lib/grid/gridloss.h"
#include "../shared/cmd.h"
#include "coneopt.h"
#include "loss.h"

static const double NOTED = 0.01;       /* a loss is noted above this share of the area, a distance
                                         * above this share of its square root */

int
loss_report(Lhg *out, const char *mesh, double most, const char *like, const Disk *d, const Conformal *c)
{
	char what[200], sock[80] = "";
	int noted;
	const double *x;
	GridLoss loss;

	if (gridloss(&d->m, c->u, c->v, c->grid.g, c->grid.phi, &loss))
		die("no memory to compare the grid with the mesh");
	cmd_meta(out, "area", "%.9g", loss.area);
	cmd_meta(out, "kept", "%.6g", loss.kept);
	cmd_meta(out, "farthest", "%.6g", loss.farthest);
	x = d->m.xyz + 3*(size_t)loss.vertex;
	snprintf(what, sizeof what,
	    "%.3g %% of the area; the vertex at (%g %g %g) is %.3g %% of sqrt(area) away",
	    100*loss.kept, x[0], x[1], x[2], 100*loss.farthest);
	if (!(loss.kept >= 1 - most))
		die("%s: the grid holds only %s: --max-loss=%g", mesh, what, most);
	noted = !(loss.kept >= 1 - NOTED && loss.farthest <= NOTED);
	if (cones_help(c))
		snprintf(sock, sizeof sock, "--chart=sock (chi^2 %.3g, on the rectangle %.3g), ", c->chi2[1], c->chi2[0]);
	if (noted)
		note("%s: the grid holds %s: %smore cells (%s), other %s or a part of the mesh alone lose less", mesh, what, sock,
		    like && c->grid.g.kind->joined[1][0] ? "of the grid of --like" : "-n auto", c->grid.g.kind->closed ? "--cones" : "corners (-c)");
	return noted;
}
