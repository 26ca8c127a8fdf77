/* gridcell.c - bilinear elements with the metric of a gridded surface. */
#include <math.h>
#include <string.h>

#include "../base/vec3.h"
#include "gridcell.h"

static const double FLATTEST = 1e-3;    /* smallest ratio of the eigenvalues of the metric: flatter
                                         * cells tell nothing of the surface.  The eigenvalues of A
                                         * are then within 1e-3 .. 1 of the largest, for which CG
                                         * needs at most about MOST_STEPS steps */

/* The lengths of the mean of the four unit normals where trust begins and ends. */
static const double TURNED = 0.8, STRAIGHT = 0.98;

double
gridcell_trust(const GridCell *cell)
{
	double sum[3] = { 0, 0, 0 }, n[3], length;
	int a, c;

	for (a = 0; a < 4; a++) {
		cross3(cell->corner[a]->phi_u, cell->corner[a]->phi_v, n);
		length = norm3(n);
		for (c = 0; c < 3 && length > 0; c++)
			sum[c] += n[c]/length;
	}
	return fmin(fmax((norm3(sum)/4 - TURNED)/(STRAIGHT - TURNED), 0), 1);
}

/* The points of a cell where its metric is evaluated, as distances along u and v from its middle in
 * units of the cell, and the weight of central differences in the tangents there.  lambda and H are
 * later computed by central differences, so cell differences alone would make the grid conformal in
 * another sense.  Central differences alone do not see the odd-even mode.  At Gauss points the mean
 * of both gave a Beltrami coefficient 1.5 to 2 times smaller than either alone; on
 * buddha_laughing_15k at 257 x 257 its median was .0017.  At the corners the median is .0014 with
 * the mean, and .0010 with 0.9 central, in twice as many rounds. */
static const struct { double from_middle, central; } METRIC[] = {
	[GRIDLAPLACE_CELLS] = { 0.28867513459481288, 0.5 },     /* 1/sqrt(12) */
	[GRIDLAPLACE_NODES] = { 0.5, 0.9 },
};

/* The tangents at (x,y) of the unit cell.  du and dv are the derivatives of the four bilinear shape
 * functions there. */
static void
tangents(const GridCell *cell, double central, double x, double y, const double du[4], const double dv[4],
	double phi_u[3], double phi_v[3])
{
	double shape[4] = { (1 - x)*(1 - y), x*(1 - y), (1 - x)*y, x*y };
	const GridNode *p;
	int a, c;

	for (c = 0; c < 3; c++) {
		phi_u[c] = phi_v[c] = 0;
		for (a = 0; a < 4; a++) {
			p = cell->corner[a];
			phi_u[c] += central*shape[a]*(cell->sign[a]*p->phi_u[c]) + (1 - central)*du[a]*p->phi[c];
			phi_v[c] += central*shape[a]*(cell->sign[a]*p->phi_v[c]) + (1 - central)*dv[a]*p->phi[c];
		}
	}
}

/* Adds a multiple of the identity to a metric that is flatter than FLATTEST. */
static void
thicken(double *E, double F, double *G)
{
	double middle = (*E + *G)/2, radius = sqrt((*E - *G)*(*E - *G)/4 + F*F);
	double more = (FLATTEST*(middle + radius) - (middle - radius))/(1 - FLATTEST);

	if (more > 0)
		*E += more, *G += more;
}

/* Adds the contribution of quadrature point (x,y) to the lower triangle m of the cell's matrix. */
static void
add_point(const GridCell *cell, double central, double trust, double x, double y, double m[10])
{
	double h = cell->h, k = cell->k;
	double du[4] = { -(1 - y)/h, (1 - y)/h, -y/h, y/h };
	double dv[4] = { -(1 - x)/k, -x/k, (1 - x)/k, x/k };
	double phi_u[3], phi_v[3], E, F, G, area;
	int a, b;

	tangents(cell, central, x, y, du, dv, phi_u, phi_v);
	E = dot3(phi_u, phi_u), F = dot3(phi_u, phi_v), G = dot3(phi_v, phi_v); /* (3), (5) */
	thicken(&E, F, &G);
	area = sqrt(fmax(E*G - F*F, 0));
	if (!(area > 0))
		E = G = area = 1, F = 0;
	for (a = 0; a < 4; a++)
		for (b = 0; b <= a; b++)
			*m++ += trust*((G*du[a]*du[b] - F*(du[a]*dv[b] + dv[a]*du[b]) + E*dv[a]*dv[b])/area*h*k/4)
			    + (1 - trust)*((du[a]*du[b] + dv[a]*dv[b])*h*k/4);
}

void
gridcell_matrix(const GridCell *cell, int metric, double trust, double m[10])
{
	double r = METRIC[metric].from_middle;
	int q;

	memset(m, 0, 10*sizeof *m);
	for (q = 0; q < 4; q++)
		add_point(cell, METRIC[metric].central, trust, q%2 ? 0.5 + r : 0.5 - r, q/2 ? 0.5 + r : 0.5 - r, m);
}
