/* warpdistortion.h - how far a map f of a rectangle is from a conformal and area-keeping one, with a
 * barrier against folds.
 *
 * At each corner of each cell, with the differences f_u and f_v along its two sides there, and
 * J = det(f_u, f_v):
 *
 *   |Df|^2/(2J) - 1 + 0.1 (J + 1/J - 2),     |Df|^2/(2J) = (1 + |mu|^2)/(1 - |mu|^2),
 *
 * mu the Beltrami coefficient; and, where d = |Df|^2/(2J) - 1 of f with f_v times `stretch` exceeds a limit,
 * stiff (d - limit)^2: so a few places of large |mu| are held without making all others stiff.  Infinite where
 * J <= 1e-3: so a map of finite distortion whose border goes round the border of the rectangle once is bijective.
 */
#ifndef WARPDISTORTION_H
#define WARPDISTORTION_H

enum { WARPDISTORTION_ENOMEM = -1 };

/* A grid of nodes on [0,1] x [0,T], and workspace. */
typedef struct WarpDistortion {
	int     nu, nv;
	double  T, *work;
	double  stretch, limit, stiff;
} WarpDistortion;

/* stretch is 1 and stiff is 0; the caller may set others.  Returns 0, or WARPDISTORTION_ENOMEM with nothing to
 * free. */
int  warpdistortion_init(WarpDistortion *w, int nu, int nv, double T);
void warpdistortion_free(WarpDistortion *w);

/* The d that belongs to |mu|. */
double warpdistortion_of(double mu);

/* The mean over all corners of all cells, for f[2][nv][nu]; adds a times its derivatives by f to
 * g[2][nv][nu].  Returns INFINITY where f is folded; g is then not defined. */
double warpdistortion(const WarpDistortion *w, const double *f, double a, double *g);

/* The mean and the largest |mu| over the cells, from the mean differences of each, if f_v is multiplied
 * by `stretch`.  The largest is 1 or more if a cell is folded. */
void warpdistortion_mu(const WarpDistortion *w, const double *f, double stretch, double *mean, double *most);

#endif
