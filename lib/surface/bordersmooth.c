/* bordersmooth.c - smooths a fitted surface where its cells fold near the border. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/corner.h"
#include "../grid/cornerfold.h"
#include "../grid/cornerunfold.h"
#include "../grid/fold.h"
#include "bordersmooth.h"
#include "harmonicshare.h"

enum {
	MOST = 9,       /* solves; 1 to 3 unfold most faces */
	LEAST = 2       /* the smallest reach */
};

typedef struct Work {
	Chart g;
	int   radius;                   /* of the part of the grid that is looked at, in cells from the border */
	int   reach;                    /* of the smoothing, in cells from a folded one */
	double *share;                  /* [nv][nu] x */
	double *to;                     /* [3][nv][nu] */
	unsigned char *folded;          /* [nv][nu] */
} Work;

static int
count_folds(const Work *w, const double *phi)
{
	size_t n = (size_t)w->g.nu*w->g.nv;
	const double *const x[3] = { phi, phi + n, phi + 2*n };

	return fold_mark(w->g, x, w->radius, w->folded);
}

/* Raises x around the middle of cell (i,j). */
static void
raise_share(const Work *w, int i, int j)
{
	int a, b, r = w->reach;
	size_t p;

	for (b = j - r; b <= j + r + 1; b++)
		for (a = i - r; a <= i + r + 1; a++) {
			if (b < 0 || b >= w->g.nv || (!w->g.kind->joined[0][0] && (a < 0 || a >= w->g.nu)))
				continue;
			p = (size_t)b*w->g.nu + (a + w->g.nu)%w->g.nu;
			w->share[p] = fmax(w->share[p], corner_fade(hypot(a - i - 0.5, b - j - 0.5)/r));
		}
}

/* Sets x from the folded cells. */
static void
set_share(const Work *w)
{
	size_t n = (size_t)w->g.nu*w->g.nv, p;

	memset(w->share, 0, n*sizeof *w->share);
	for (p = 0; p < n; p++)
		if (w->folded[p])
			raise_share(w, (int)(p%w->g.nu), (int)(p/w->g.nu));
}

/* Turns back what is left at the corners. */
static void
unfold_corners(Chart g, double *phi)
{
	size_t n = (size_t)g.nu*g.nv;
	double *const x[3] = { phi, phi + n, phi + 2*n };
	const double *const fixed[3] = { phi, phi + n, phi + 2*n };
	int k, radius = corner_radius(g);

	for (k = 0; k < 4; k++)
		if (corner_exists(g, k) && corner_folds(g, k, fixed, radius))
			corner_unfold(g, k, x, radius);
}

int
border_smooth(Chart g, double *phi)
{
	size_t n = (size_t)g.nu*g.nv;
	Work w = { g, corner_radius(g), corner_radius(g), malloc(n*sizeof(double)), malloc(3*n*sizeof(double)), malloc(n) };
	int e = w.share && w.to && w.folded ? 0 : BORDERSMOOTH_ENOMEM, k, folds = 0, after;

	if (!e)
		folds = count_folds(&w, phi);
	for (k = 0; !e && folds && k < MOST && w.reach >= LEAST; k++) {
		set_share(&w);
		if (harmonic_share(g, w.share, phi, w.to)) {
			e = BORDERSMOOTH_ENOMEM;
			break;
		}
		after = count_folds(&w, w.to);
		if (after >= folds) {
			w.reach /= 2;
			count_folds(&w, phi);
			continue;
		}
		memcpy(phi, w.to, 3*n*sizeof *phi);
		folds = after;
	}
	if (!e && folds)
		unfold_corners(g, phi);
	free(w.share);
	free(w.to);
	free(w.folded);
	return e;
}
