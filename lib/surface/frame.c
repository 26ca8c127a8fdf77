/* frame.c - Codazzi, natural frame and position equations on cell centres. */
#include <stdlib.h>

#include "cellsq.h"
#include "frame.h"
#include "frameband.h"
#include "../base/vec3.h"

enum { FRAME_HELD = 2 };        /* rings where frame and second form are held; see from_band */

/* The data of the three linear systems. */
typedef struct Given {
	Chart         g;
	const double *lambda, *H;
	double       *DM;       /* [node][2], the solution of the first */
	double       *pqn;      /* [node][3 fields][3 coordinates], the solution of the second */
} Given;

/* Weights of the four corners of a cell in the average and in the differences. */
static const double MEAN[4] = { 0.25, 0.25, 0.25, 0.25 };
static const double SIGN_U[4] = { -1, 1, -1, 1 }, SIGN_V[4] = { -1, -1, 1, 1 };

/* A field at the centre of cell (i,j), and its derivatives there. */
static double
centre(Chart g, const double *f, int step, int i, int j)
{
	const double *a = f + (size_t)(j*g.nu + i)*step, *b = a + (size_t)g.nu*step;

	return (a[0] + a[step] + b[0] + b[step])/4;
}

static double
centre_u(Chart g, const double *f, int i, int j)
{
	const double *a = f + (size_t)j*g.nu + i, *b = a + g.nu;

	return (a[1] - a[0] + b[1] - b[0])/(2*chart_h(g));
}

static double
centre_v(Chart g, const double *f, int i, int j)
{
	const double *a = f + (size_t)j*g.nu + i, *b = a + g.nu;

	return (b[0] - a[0] + b[1] - a[1])/(2*chart_k(g));
}

/* Adds the term  c_u f_u + c_v f_v + c f  to the row, for field f at the cell's centre. */
static void
term(const Given *s, double *row, int fields, int field, double c_u, double c_v, double c)
{
	double h = chart_h(s->g), k = chart_k(s->g);
	int corner;

	for (corner = 0; corner < 4; corner++)
		row[corner*fields + field] += c_u*SIGN_U[corner]/(2*h) + c_v*SIGN_V[corner]/(2*k) + c*MEAN[corner];
}

/* lambda^2 at the centre: the mean of the squares. */
static double
centre_lambda2(const Given *s, int i, int j)
{
	const double *a = s->lambda + (size_t)j*s->g.nu + i, *b = a + s->g.nu;

	return (a[0]*a[0] + a[1]*a[1] + b[0]*b[0] + b[1]*b[1])/4;
}

static double
centre_lambda2H(const Given *s, int i, int j)
{
	const double *a = s->lambda + (size_t)j*s->g.nu + i, *b = a + s->g.nu;
	const double *f = s->H + (size_t)j*s->g.nu + i, *e = f + s->g.nu;

	return (a[0]*a[0]*f[0] + a[1]*a[1]*f[1] + b[0]*b[0]*e[0] + b[1]*b[1]*e[1])/4;
}

/* mu_zbar = (lambda^2/2) H_z in real form, for mu = (D - i M)/2.                      (14) */
static void
codazzi(const void *ctx, int i, int j, CellRows *r)
{
	const Given *s = ctx;
	double lambda2 = centre_lambda2(s, i, j);
	enum { D, M };

	term(s, r->A[0], 2, D, 1, 0, 0);        /* D_u + M_v =  lambda^2 H_u */
	term(s, r->A[0], 2, M, 0, 1, 0);
	r->b[0][0] = lambda2*centre_u(s->g, s->H, i, j);
	term(s, r->A[1], 2, D, 0, 1, 0);        /* D_v - M_u = -lambda^2 H_v */
	term(s, r->A[1], 2, M, -1, 0, 0);
	r->b[1][0] = -lambda2*centre_v(s->g, s->H, i, j);
}

/* The natural frame equations (13) in real form (doc/mathematics.md 7.1), all terms on the left.
 * The rows of n are scaled by lambda, as n is of size 1 and p and q are of size lambda.   (30) */
static void
natural_frame(const void *ctx, int i, int j, CellRows *r)
{
	const Given *s = ctx;
	double lambda2 = centre_lambda2(s, i, j), lambda = sqrt(lambda2), l2H = centre_lambda2H(s, i, j);
	double a = 0, b = 0, D = centre(s->g, s->DM, 2, i, j), M = centre(s->g, s->DM + 1, 2, i, j);
	double L = l2H + D, N = l2H - D;
	enum { p, q, n };
	int c;

	for (c = 0; c < 4; c++) {               /* a = (log lambda)_u, b = (log lambda)_v */
		double l = log(s->lambda[(size_t)(j + c/2)*s->g.nu + i + c%2]);

		a += SIGN_U[c]*l/(2*chart_h(s->g));
		b += SIGN_V[c]*l/(2*chart_k(s->g));
	}
	term(s, r->A[0], 3, p, 1, 0, -a);       /* p_u =  a p - b q + L n */
	term(s, r->A[0], 3, q, 0, 0, b);
	term(s, r->A[0], 3, n, 0, 0, -L);
	term(s, r->A[1], 3, p, 0, 1, -b);       /* p_v =  b p + a q + M n */
	term(s, r->A[1], 3, q, 0, 0, -a);
	term(s, r->A[1], 3, n, 0, 0, -M);
	term(s, r->A[2], 3, p, 0, 0, -b);       /* q_u =  b p + a q + M n */
	term(s, r->A[2], 3, q, 1, 0, -a);
	term(s, r->A[2], 3, n, 0, 0, -M);
	term(s, r->A[3], 3, p, 0, 0, a);        /* q_v = -a p + b q + N n */
	term(s, r->A[3], 3, q, 0, 1, -b);
	term(s, r->A[3], 3, n, 0, 0, -N);
	term(s, r->A[4], 3, p, 0, 0, L/lambda); /* lambda n_u = -(L p + M q)/lambda */
	term(s, r->A[4], 3, q, 0, 0, M/lambda);
	term(s, r->A[4], 3, n, lambda, 0, 0);
	term(s, r->A[5], 3, p, 0, 0, M/lambda); /* lambda n_v = -(M p + N q)/lambda */
	term(s, r->A[5], 3, q, 0, 0, N/lambda);
	term(s, r->A[5], 3, n, 0, lambda, 0);
}

/* Equations for phi, given its derivatives.                                          (31) */
static void
position(const void *ctx, int i, int j, CellRows *r)
{
	const Given *s = ctx;
	int c;

	term(s, r->A[0], 1, 0, 1, 0, 0);        /* phi_u = p */
	term(s, r->A[1], 1, 0, 0, 1, 0);        /* phi_v = q */
	for (c = 0; c < 3; c++) {
		r->b[0][c] = centre(s->g, s->pqn + c, 9, i, j);
		r->b[1][c] = centre(s->g, s->pqn + 3 + c, 9, i, j);
	}
}

/* Along one direction, the place of node i of n among the inner nodes of the fine grid, of `fine`
 * nodes. */
static double
place(int i, int n, int fine)
{
	double x = i*(fine - 1.0)/(n - 1);

	return x < 1 ? 1 : x > fine - 2 ? fine - 2 : x;
}

/* Number of steps from node i of n to the nearer end. */
static int
from_end(int i, int n)
{
	return i < n - 1 - i ? i : n - 1 - i;
}

/* Frame and second form on one ring of nodes, read from the fine grid, which may be the same
 * grid. */
static int
read_band(Given *s, int ring, Chart fine, double *const phi[3], int *at)
{
	const double *const cphi[3] = { phi[0], phi[1], phi[2] };
	int nu = s->g.nu, nv = s->g.nv, p, i, j;

	for (p = 0; p < nu*nv; p++) {
		i = from_end(p%nu, nu);
		j = from_end(p/nu, nv);
		if ((i < j ? i : j) != ring)
			continue;
		if (frameband(fine, cphi, place(p%nu, nu, fine.nu), place(p/nu, nv, fine.nv), at,
		    s->pqn + 9*(size_t)p, s->DM + 2*(size_t)p))
			return FRAME_EBAND;
	}
	return 0;
}

/* Replaces B = (p q) by lambda B (B'B)^(-1/2).  The inverse square root of a 2 x 2 matrix has a
 * closed form. */
void
frame_make_conformal(double lambda, double p[3], double q[3])
{
	double E = dot3(p, p), F = dot3(p, q), G = dot3(q, q);
	double root = sqrt(fmax(E*G - F*F, 0)), s = lambda/(root*sqrt(E + G + 2*root)), a, b;
	int c;

	if (!(s < HUGE_VAL))
		return;
	for (c = 0; c < 3; c++) {
		a = p[c], b = q[c];
		p[c] = s*((G + root)*a - F*b);
		q[c] = s*((E + root)*b - F*a);
	}
}

static int
positions(const Given *s, int held, double *const phi[3], SpdReport *report)
{
	CellSystem sys = { s->g, 1, 2, 3, held, position, s };
	size_t n = (size_t)s->g.nu*s->g.nv, p;
	double *x = malloc(3*n*sizeof *x);
	int c, e = SPD_ENOMEM;

	if (!x)
		return e;
	for (p = 0; p < n; p++)
		for (c = 0; c < 3; c++)
			x[3*p+c] = phi[c][p];
	e = cellsq_solve(&sys, x, report);
	for (p = 0; !e && p < n; p++)
		for (c = 0; c < 3; c++)
			phi[c][p] = x[3*p+c];
	free(x);
	return e;
}

/* Solves the three systems one after the other.  The frame is given on the outer frame_held rings,
 * phi on the outer phi_held rings. */
static int
solve(Given *s, int frame_held, int phi_held, double *const phi[3], SpdReport *report)
{
	CellSystem second_form = { s->g, 2, 2, 1, frame_held, codazzi, s };
	CellSystem frame = { s->g, 3, 6, 3, frame_held, natural_frame, s };
	size_t n = (size_t)s->g.nu*s->g.nv, p;
	int e = cellsq_solve(&second_form, s->DM, report);

	if (!e)
		e = cellsq_solve(&frame, s->pqn, report);
	for (p = 0; !e && p < n; p++)
		frame_make_conformal(s->lambda[p], s->pqn + 9*p, s->pqn + 9*p + 3);
	return e ? e : positions(s, phi_held, phi, report);
}

/* If the band lies on the grid itself, frame and second form are known on the second ring.  The
 * outermost ring then lies in no cell with a free node, and its frame stays 0.  If the band is of a
 * finer grid, frame and second form are read on the outermost ring, to first order in the steps. */
static int
from_band(Chart fine, double *const band[3], Given s, double *const phi[3], int *at, SpdReport *report)
{
	size_t n = (size_t)s.g.nu*s.g.nv;
	int same = band == phi, e = SPD_ENOMEM;

	s.DM = calloc(2*n, sizeof *s.DM);
	s.pqn = calloc(9*n, sizeof *s.pqn);
	if (s.DM && s.pqn)
		e = read_band(&s, same ? 1 : 0, fine, band, at);
	if (!e)
		e = solve(&s, same ? FRAME_HELD : 1, same ? FRAME_BAND : 1, phi, report);
	free(s.DM);
	free(s.pqn);
	return e;
}

int
frame_surface(Chart g, const double *lambda, const double *H, double *const phi[3],
	int *at, SpdReport *report)
{
	return from_band(g, phi, (Given){ g, lambda, H, NULL, NULL }, phi, at, report);
}

int
frame_coarse(Chart fine, double *const band[3], Chart g, const double *lambda, const double *H,
	double *const phi[3], int *at, SpdReport *report)
{
	return from_band(fine, band, (Given){ g, lambda, H, NULL, NULL }, phi, at, report);
}
