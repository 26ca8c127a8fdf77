/* framefit.c - lh2grid's frame method. */
#include "../../lib/surface/frame.h"
#include "framefit.h"

void
framefit(const CmdInput *in, Chart g, const double *lambda, const double *H, double *phi)
{
	size_t n = (size_t)g.nu*g.nv;
	double *x[3] = { phi, phi + n, phi + 2*n };
	SpdReport report = { 0, 0 };
	int at = 0;

	switch (frame_surface(g, lambda, H, x, &at, &report)) {
	case 0: return;
	case FRAME_EBAND: die("%s: the band has no tangent plane at node (%d,%d)", in->name, at%g.nu, at/g.nu);
	case SPD_ENOMEM: die("%s: no memory: the factor of %d x %d nodes needs %.0f bytes",
	    in->name, g.nu, g.nv, report.bytes);
	case SPD_ELARGE: die("%s: %d x %d nodes are more than the solver can number", in->name, g.nu, g.nv);
	default: die("%s: the normal equations are not positive definite at row %d", in->name, report.column);
	}
}
