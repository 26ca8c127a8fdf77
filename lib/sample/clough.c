/* clough.c - Clough-Tocher interpolant by the Bezier ordinates of the split triangle.
 *
 * Ordinates are points of R^3.  V_i is the place of vertex i in (u,v), e_ij = V_j - V_i, and S the
 * centroid.  A spoke goes from a vertex to S.  The part at side k has the corners i = k+1, j = k+2
 * (modulo 3) and S; its ordinates are
 *
 *   f_i                  the vertex
 *   t_ij = f_i + phi'_i(e_ij)/3                     on the side, next to i
 *   a_i  = f_i + phi'_i(S - V_i)/3                  on the spoke, next to i
 *   c_k                                             in the middle of the part
 *   q_i  = (a_i + c_j + c_k)/3                      on the spoke, next to S
 *   s    = (q_0 + q_1 + q_2)/3                      at S
 *
 * c_k follows from the derivative D at the middle M of the side, in the direction S - M:
 *
 *   D = 3 [ (a_i + a_j)/4 + c_k/2 - (f_i + 3 t_ij + 3 t_ji + f_j)/8 ].
 */
#include "clough.h"
#include "../base/vec3.h"

/* The ordinates of a triangle, except those near S. */
typedef struct Ordinates {
	const double *f[3];
	double t[3][2][3];      /* t[i][0] towards i+1, t[i][1] towards i+2 */
	double a[3][3], c[3][3];
} Ordinates;

/* out = phi'(du,dv) at a vertex. */
static void
derivative(const Jet *jet, double du, double dv, double out[3])
{
	int c;

	for (c = 0; c < 3; c++)
		out[c] = jet->u[c]*du + jet->v[c]*dv;
}

/* The derivative at the middle of side i j in direction (xu,xv).  Its component across the side is
 * computed from the jets at both ends, as in clough.h; its component along the side is the
 * derivative of the cubic on the side. */
static void
middle_derivative(const Clough *c, int i, int j, double xu, double xv, double out[3])
{
	const Jet *p = &c->jet[i], *q = &c->jet[j];
	const double *f = &c->m->xyz[3*i], *g = &c->m->xyz[3*j];
	double eu = c->u[j] - c->u[i], ev = c->v[j] - c->v[i], e2 = eu*eu + ev*ev;
	double along = e2 > 0 ? (xu*eu + xv*ev)/e2 : 0, ends, side;
	int d;

	xu -= along*eu;
	xv -= along*ev;
	for (d = 0; d < 3; d++) {
		ends = (p->u[d] + q->u[d])*eu + (p->v[d] + q->v[d])*ev;
		side = 1.5*(g[d] - f[d]) - ends/4;
		out[d] = ((p->u[d] + q->u[d])*xu + (p->v[d] + q->v[d])*xv)/2
		    + ((p->uu[d] - q->uu[d])*eu*xu + (p->uv[d] - q->uv[d])*(eu*xv + ev*xu)
		    + (p->vv[d] - q->vv[d])*ev*xv)/8 + along*side;
	}
}

/* Limits the distance of c_k from (f_i + f_j + S)/3, its place in a flat triangle, to
 * GRADIENT_BEND/3 L, where L is the longest side.  Returns 1 if c_k was moved. */
static int
limit(const Ordinates *n, int k, double L, double ck[3])
{
	double flat[3], d[3], far;
	int i = (k+1)%3, j = (k+2)%3, c;

	for (c = 0; c < 3; c++)
		flat[c] = (4*(n->f[i][c] + n->f[j][c]) + n->f[k][c])/9;
	sub3(ck, flat, d);
	far = norm3(d);
	if (far <= GRADIENT_BEND/3*L)
		return 0;
	for (c = 0; c < 3; c++)
		ck[c] = flat[c] + (far < HUGE_VAL ? d[c]*(GRADIENT_BEND/3*L/far) : 0);
	return 1;
}

static double
longest(const Ordinates *n)
{
	double d[3], most = 0;
	int k;

	for (k = 0; k < 3; k++) {
		sub3(n->f[k], n->f[(k+1)%3], d);
		most = larger(most, norm3(d));
	}
	return most;
}

/* Sets the ordinate c_k by the formula for D; (xu,xv) = S - M.  Needs the ordinates f, t and a. */
static void
middle_ordinate(const Clough *cl, const int *tri, Ordinates *n, int k)
{
	int i = (k+1)%3, j = (k+2)%3, c;
	double xu = (cl->u[tri[k]] - (cl->u[tri[i]] + cl->u[tri[j]])/2)/3;
	double xv = (cl->v[tri[k]] - (cl->v[tri[i]] + cl->v[tri[j]])/2)/3, D[3];

	middle_derivative(cl, tri[i], tri[j], xu, xv, D);
	for (c = 0; c < 3; c++)
		n->c[k][c] = 2*D[c]/3 - (n->a[i][c] + n->a[j][c])/2
		    + (n->f[i][c] + 3*n->t[i][0][c] + 3*n->t[j][1][c] + n->f[j][c])/4;
}

/* Computes the ordinates of triangle t.  Returns the number of sides k whose c_k was limited. */
static int
ordinates(const Clough *cl, int t, Ordinates *n)
{
	const int *tri = &cl->m->tri[3*t];
	int i, k, c, limited = 0;
	double d[3], L;

	for (i = 0; i < 3; i++)
		n->f[i] = &cl->m->xyz[3*tri[i]];
	for (i = 0; i < 3; i++) {
		for (k = 0; k < 2; k++) {
			int j = tri[(i+1+k)%3];

			derivative(&cl->jet[tri[i]], cl->u[j] - cl->u[tri[i]], cl->v[j] - cl->v[tri[i]], d);
			for (c = 0; c < 3; c++)
				n->t[i][k][c] = n->f[i][c] + d[c]/3;
		}
		for (c = 0; c < 3; c++)
			n->a[i][c] = (n->f[i][c] + n->t[i][0][c] + n->t[i][1][c])/3;
	}
	L = longest(n);
	for (k = 0; k < 3; k++) {
		middle_ordinate(cl, tri, n, k);
		limited += limit(n, k, L, n->c[k]);
	}
	return limited;
}

int
clough_eval(const Clough *cl, int t, const double bary[3], double phi[3])
{
	int k = bary[0] < bary[1] ? 0 : 1, i, j, c, limited;
	double x, y, z;
	Ordinates n;

	if (bary[2] < bary[k])
		k = 2;
	i = (k+1)%3, j = (k+2)%3;
	x = bary[i] - bary[k];
	y = bary[j] - bary[k];
	z = 3*bary[k];
	limited = ordinates(cl, t, &n);
	for (c = 0; c < 3; c++) {
		double q[3], s;
		int l;

		for (l = 0; l < 3; l++)
			q[l] = (n.a[l][c] + n.c[(l+1)%3][c] + n.c[(l+2)%3][c])/3;
		s = (q[0] + q[1] + q[2])/3;
		phi[c] = x*x*x*n.f[i][c] + y*y*y*n.f[j][c] + z*z*z*s
		    + 3*(x*y*(x*n.t[i][0][c] + y*n.t[j][1][c]) + x*z*(x*n.a[i][c] + z*q[i])
		    + y*z*(y*n.a[j][c] + z*q[j])) + 6*x*y*z*n.c[k][c];
	}
	return limited;
}
