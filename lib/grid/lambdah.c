/* lambdah.c - conformal factor and mean curvature by central differences. */
#include "lambdah.h"
#include "stencil.h"
#include "../base/vec3.h"

/* phi_u and phi_v count as parallel if |phi_u x phi_v| is at most this times lambda^2. */
static const double PARALLEL = 1e-14;

/* lambda and H at inner node (i,j); H is NaN if phi_u and phi_v are parallel. */
static void
at_node(Chart g, const double *const phi[3], int curvature, int i, int j, double *lambda, double *H)
{
	double phi_u[3], phi_v[3], lap[3], n[3], area, along, lambda2;

	stencil_tangents(g, phi, i, j, phi_u, phi_v);
	stencil_laplacian(g, phi, i, j, lap);                           /* (27) */
	cross3(phi_u, phi_v, n);
	area = norm3(n);                                                /* (29) */
	lambda2 = (dot3(phi_u, phi_u) + dot3(phi_v, phi_v))/2;          /* (25) */
	*lambda = sqrt(lambda2);
	*H = NAN;
	if (!(area > PARALLEL*lambda2))
		return;
	along = dot3(lap, n)/area;
	if (curvature == LAMBDAH_MAGNITUDE)
		along = copysign(norm3(lap), along);                    /* (28) */
	*H = along/(2*lambda2);                                         /* (26), (9) */
}

/* Raises lambda to at least 1e-4 of its root mean square, because log lambda and 1/lambda are
 * needed, and sets H to 0 where lambda was raised or H is not finite.  Where H is infinite, lambda is
 * set to this bound, too. */
static LambdahFlaws
repair(Chart g, double *lambda, double *H)
{
	Range columns = stencil_inner(g, 0), rows = stencil_inner(g, 1);
	LambdahFlaws flaws = { 0, 0 };
	double sum = 0, least;
	int i, j, p;

	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			p = j*g.nu + i;
			sum += lambda[p]*lambda[p];
		}
	least = 1e-4*sqrt(sum/stencil_inner_count(g));
	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			p = j*g.nu + i;
			if (lambda[p] > least && isfinite(H[p]))
				continue;
			if (lambda[p] > least && isnan(H[p]))
				flaws.parallel++;
			else {
				lambda[p] = least;
				flaws.raised++;
			}
			H[p] = 0;
		}
	return flaws;
}

static double
clamp(double x, double lo, double hi)
{
	return x < lo ? lo : x > hi ? hi : x;
}

/* Extrapolates to the n nodes p = first + l*stride of a side, each from the next two nodes inside,
 * p + in and p + 2*in. */
static void
extend(int n, int first, int stride, int in, double *lambda, double *H)
{
	int l, p;

	for (l = 0; l < n; l++) {
		p = first + l*stride;
		lambda[p] = lambda[p+in]*clamp(lambda[p+in]/lambda[p+2*in], 0.5, 2);
		H[p] = H[p+in] + clamp(H[p+in] - H[p+2*in], -fabs(H[p+in]), fabs(H[p+in]));
	}
}

/* Extrapolates to the nodes of each open side.  v = 0 and v = T come last and include the corners. */
static void
extend_sides(Chart g, double *lambda, double *H)
{
	Range columns = stencil_inner(g, 0), rows = stencil_inner(g, 1);
	int inner = rows.to - rows.from, first = rows.from*g.nu;

	if (columns.from > 0)
		extend(inner, first, g.nu, 1, lambda, H);
	if (columns.to < g.nu)
		extend(inner, first + g.nu - 1, g.nu, -1, lambda, H);
	if (rows.from > 0)
		extend(g.nu, 0, 1, g.nu, lambda, H);
	if (rows.to < g.nv)
		extend(g.nu, (g.nv - 1)*g.nu, 1, -g.nu, lambda, H);
}

enum { CORNER = 8 };    /* nodes */

/* Whether node i of n is within CORNER nodes of an end with an open side. */
static int
near_end(Range inner, int n, int i)
{
	return (inner.from > 0 && i < CORNER) || (inner.to < n && i >= n - CORNER);
}

/* Whether node p is within CORNER nodes of a corner, counted along both directions. */
static int
in_corner(Chart g, int p)
{
	return near_end(stencil_inner(g, 0), g.nu, p%g.nu) && near_end(stencil_inner(g, 1), g.nv, p/g.nu);
}

/* Where the boundary of the mesh is smooth at a corner of the rectangle, lambda goes to 0.  H then
 * reaches 10^3 times its usual size at a few nodes there, and these dominate its whole spectrum. */
void
lambdah_limit_corners(Chart g, double *H)
{
	int p, n = g.nu*g.nv, count = 0;
	double sum = 0, most;

	if (g.nu <= 3*CORNER || g.nv <= 3*CORNER)
		return;
	for (p = 0; p < n; p++)
		if (!in_corner(g, p)) {
			sum += H[p]*H[p];
			count++;
		}
	most = 4*sqrt(sum/count);
	for (p = 0; p < n; p++)
		if (in_corner(g, p))
			H[p] = clamp(H[p], -most, most);
}

LambdahFlaws
lambdah(Chart g, const double *const phi[3], int curvature, double *lambda, double *H)
{
	Range columns = stencil_inner(g, 0), rows = stencil_inner(g, 1);
	LambdahFlaws flaws;
	int i, j, p;

	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			p = j*g.nu + i;
			at_node(g, phi, curvature, i, j, &lambda[p], &H[p]);
		}
	flaws = repair(g, lambda, H);
	extend_sides(g, lambda, H);
	return flaws;
}

void
lambdah_residue(Chart g, const double *const phi[3], const double *lambda, double *const nu[2],
	double *const tau[2])
{
	double phi_u[3], phi_v[3], lap[3], l2;
	int i, j, p;

	for (p = 0, j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++, p++) {
			nu[0][p] = nu[1][p] = tau[0][p] = tau[1][p] = 0;
			if (!stencil_is_inner(g, i, j))
				continue;
			stencil_tangents(g, phi, i, j, phi_u, phi_v);
			stencil_laplacian(g, phi, i, j, lap);
			l2 = lambda[p]*lambda[p];
			nu[0][p] = (dot3(phi_u, phi_u) - dot3(phi_v, phi_v))/(2*l2);
			nu[1][p] = dot3(phi_u, phi_v)/l2;
			tau[0][p] = dot3(lap, phi_u)/l2;
			tau[1][p] = dot3(lap, phi_v)/l2;
		}
}

void
beltrami(Chart g, const double *const phi[3], double *mu)
{
	Range columns = stencil_inner(g, 0), rows = stencil_inner(g, 1);
	double phi_u[3], phi_v[3], E, F, G, root;
	int i, j;

	for (j = rows.from; j < rows.to; j++)
		for (i = columns.from; i < columns.to; i++) {
			stencil_tangents(g, phi, i, j, phi_u, phi_v);
			E = dot3(phi_u, phi_u);
			F = dot3(phi_u, phi_v);
			G = dot3(phi_v, phi_v);
			root = 2*sqrt(fmax(E*G - F*F, 0));
			*mu++ = E + G > 0 ? sqrt(fmax(E + G - root, 0)/(E + G + root)) : 1;
		}
}
