/* deviation.c - how far a computed surface is from the one that its lambda and H belong to. */
#include <math.h>

#include "../../lib/grid/gridloss.h"
#include "../shared/chartof.h"
#include "../shared/place.h"
#include "deviation.h"

static const double NOTED = 0.01;

static double
distance(size_t n, double *const place[3], const double *phi, size_t p)
{
	return hypot(hypot(phi[p] - place[0][p], phi[n+p] - place[1][p]), phi[2*n+p] - place[2][p]);
}

void
deviation(const CmdInput *in, Lhg *g, const double *phi)
{
	size_t n = (size_t)g->nu*g->nv, p, worst = 0;
	char value[LHG_KEYLEN];
	double *place[3], area, far;

	if (lhg_getmeta(g, "scale", value, sizeof value) || !place_of(in, g, place))
		return;
	if (gridloss_area(chart_of(g), place, &area))
		die("%s: no memory for the area of %d x %d nodes", in->name, g->nu, g->nv);
	for (p = 0; p < n; p++)
		if (distance(n, place, phi, p) > distance(n, place, phi, worst))
			worst = p;
	far = distance(n, place, phi, worst)/sqrt(area);
	if (!isfinite(far))
		return;
	cmd_meta(g, "deviation", "%.3g", far);
	if (far > NOTED)
		note("%s: near (%.4g, %.4g, %.4g) the surface is %.2g of sqrt(area) from that of channels place (metadatum "
		    "deviation); more cells help, or grid2lh --residual", in->name, place[0][worst], place[1][worst],
		    place[2][worst], far);
}
