/* warpmodes.h - displacements of a rectangle [0,1] x [0,T] onto itself, as sums of modes.
 *
 *   d_u = sum c_mn sin(m pi u) cos(n pi v/T),   d_v = sum e_mn cos(m pi u) sin(n pi v/T),
 *
 * 0 <= m, n < M.  So corners stay and points of a side move along it.  The coefficients are one
 * array [2][M][M]: c then e, n slower than m.
 */
#ifndef WARPMODES_H
#define WARPMODES_H

enum { WARPMODES_ENOMEM = -1 };

enum { WARPMODES_MOST = 64 };      /* M is at most this */

/* Sines and cosines at the nodes of a grid. */
typedef struct WarpModes {
	int     nu, nv, M;
	double *u[2], *v[2];    /* [nu][M], [nv][M]; [0]: of component d_u, [1]: of d_v */
	double *across[2];      /* u transposed, [M][nu] */
	double *half;           /* [2][nv][M] workspace */
} WarpModes;

/* Returns 0, or WARPMODES_ENOMEM with nothing to free. */
int  warpmodes_init(WarpModes *w, int nu, int nv, int M);
void warpmodes_free(WarpModes *w);

/* Sets d[2][nv][nu] to the displacements at the nodes; and, the transpose, c[2][M][M] to the
 * derivatives by the coefficients of a function with the derivatives g[2][nv][nu] by the
 * displacements.  Both use the workspace of w. */
void warpmodes_field(const WarpModes *w, const double *c, double *d);
void warpmodes_adjoint(const WarpModes *w, const double *g, double *c);

/* The displacement d at the point (u,v), and the same transposed: adds to c. */
void warpmodes_at(int M, double T, const double *c, double u, double v, double d[2]);
void warpmodes_at_adjoint(int M, double T, const double g[2], double u, double v, double *c);

#endif
