/* lambdah.c - conformal factor and mean curvature by central differences. */
#include "lambdah.h"
#include "../base/vec3.h"

/* phi_u and phi_v at inner node p. */
static void
tangents(Chart g, const double *const phi[3], int p, double phi_u[3], double phi_v[3])
{
	double h = chart_h(g), k = chart_k(g);
	int c;

	for (c = 0; c < 3; c++) {
		phi_u[c] = (phi[c][p+1] - phi[c][p-1])/(2*h);
		phi_v[c] = (phi[c][p+g.nu] - phi[c][p-g.nu])/(2*k);
	}
}

/* phi_uu + phi_vv at inner node p.                                             (27) */
static void
laplacian(Chart g, const double *const phi[3], int p, double lap[3])
{
	double h = chart_h(g), k = chart_k(g);
	int c;

	for (c = 0; c < 3; c++)
		lap[c] = (phi[c][p+1] - 2*phi[c][p] + phi[c][p-1])/(h*h)
		    + (phi[c][p+g.nu] - 2*phi[c][p] + phi[c][p-g.nu])/(k*k);
}

/* lambda and H at inner node p; H = 0 without a tangent plane. */
static void
at_node(Chart g, const double *const phi[3], int curvature, int p, double *lambda, double *H)
{
	double phi_u[3], phi_v[3], lap[3], n[3], area, along, lambda2;

	tangents(g, phi, p, phi_u, phi_v);
	laplacian(g, phi, p, lap);
	cross3(phi_u, phi_v, n);
	area = norm3(n);
	lambda2 = (dot3(phi_u, phi_u) + dot3(phi_v, phi_v))/2;          /* (25) */
	*lambda = sqrt(lambda2);
	*H = 0;
	if (!(area > 0))
		return;
	along = dot3(lap, n)/area;
	if (curvature == LAMBDAH_MAGNITUDE)
		along = copysign(norm3(lap), along);                    /* (28) */
	*H = along/(2*lambda2);                                         /* (26) */
}

/* Keeps lambda away from 0, where log lambda and 1/lambda are not defined. */
static int
raise_floor(Chart g, double *lambda, double *H)
{
	double sum = 0, least;
	int i, j, p, raised = 0;

	for (j = 1; j < g.nv - 1; j++)
		for (p = j*g.nu + 1; p < (j+1)*g.nu - 1; p++)
			sum += lambda[p]*lambda[p];
	least = 1e-4*sqrt(sum/((g.nu - 2.0)*(g.nv - 2.0)));
	for (j = 1; j < g.nv - 1; j++)
		for (i = 1; i < g.nu - 1; i++) {
			p = j*g.nu + i;
			if (lambda[p] > least && isfinite(H[p]))
				continue;
			lambda[p] = least;
			H[p] = 0;
			raised++;
		}
	return raised;
}

static double
clamp(double x, double lo, double hi)
{
	return x < lo ? lo : x > hi ? hi : x;
}

/* The n nodes p = first + l*stride of one side, from the rings at p + in and p + 2 in. */
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

/* Whether node p is within CORNER nodes of a corner, counted along both directions. */
enum { CORNER = 8 };

static int
in_corner(Chart g, int p)
{
	int i = p%g.nu, j = p/g.nu;

	return (i < CORNER || i >= g.nu - CORNER) && (j < CORNER || j >= g.nv - CORNER);
}

/* |H| near a corner held to four times the root mean square of H elsewhere: where the
 * boundary of the mesh is smooth there, lambda goes to 0 and H, of a few nodes, to 10^3
 * times the rest, which turns its whole spectrum white. */
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

int
lambdah(Chart g, const double *const phi[3], int curvature, double *lambda, double *H)
{
	int j, p, raised;

	for (j = 1; j < g.nv - 1; j++)
		for (p = j*g.nu + 1; p < (j+1)*g.nu - 1; p++)
			at_node(g, phi, curvature, p, &lambda[p], &H[p]);
	raised = raise_floor(g, lambda, H);
	extend(g.nv - 2, g.nu, g.nu, 1, lambda, H);
	extend(g.nv - 2, 2*g.nu - 1, g.nu, -1, lambda, H);
	extend(g.nu, 0, 1, g.nu, lambda, H);
	extend(g.nu, (g.nv - 1)*g.nu, 1, -g.nu, lambda, H);
	return raised;
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
			if (i == 0 || j == 0 || i == g.nu - 1 || j == g.nv - 1)
				continue;
			tangents(g, phi, p, phi_u, phi_v);
			laplacian(g, phi, p, lap);
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
	double phi_u[3], phi_v[3], E, F, G, root;
	int j, p;

	for (j = 1; j < g.nv - 1; j++)
		for (p = j*g.nu + 1; p < (j+1)*g.nu - 1; p++) {
			tangents(g, phi, p, phi_u, phi_v);
			E = dot3(phi_u, phi_u);
			F = dot3(phi_u, phi_v);
			G = dot3(phi_v, phi_v);
			root = 2*sqrt(fmax(E*G - F*F, 0));
			*mu++ = E + G > 0 ? sqrt(fmax(E + G - root, 0)/(E + G + root)) : 1;
		}
}
