/* cornersmooth.c - smooths the corners of a fitted surface. */
#include <stdlib.h>
#include <string.h>

#include "../base/corner.h"
#include "../grid/cornerfold.h"
#include "../grid/cornerunfold.h"
#include "cornersmooth.h"
#include "harmonicshare.h"

static const double DEGENERATE = 0.5;   /* lambda counts as going to 0 at a corner if the weight o of
                                         * the inner node next to it is below this */
enum { LEAST = 3 };                     /* the smallest radius, in cells, with cells to smooth */

static int
wants(const Misfit *m, int k, const double *const phi[3])
{
	int radius = corner_radius(m->g);

	if (!corner_exists(m->g, k) || radius < LEAST)
		return 0;
	return (!m->place && m->o[corner_node(m->g, k, 1, 1)] < DEGENERATE) || corner_folds(m->g, k, phi, radius);
}

/* Sets x of cornersmooth.h at the inner nodes around corner k. */
static void
set_share(Chart g, int k, double *x)
{
	int radius = corner_radius(g), a, b, p;

	for (b = 1; b < radius; b++)
		for (a = 1; a < radius; a++) {
			p = corner_node(g, k, a, b);
			x[p] = corner_share(g, p%g.nu, p/g.nu);
		}
}

/* Blends phi into the place around the corners. */
static void
blend_with_place(const Misfit *m, double *phi)
{
	size_t n = (size_t)m->g.nu*m->g.nv, p;
	double share;
	int c;

	for (p = 0; p < n; p++) {
		share = m->hold[p] > 0 ? corner_share(m->g, p%m->g.nu, p/m->g.nu) : 0;
		for (c = 0; c < 3 && share > 0; c++)
			phi[c*n+p] += share*(m->place[c*n+p] - phi[c*n+p]);
	}
}

/* Writes phi with the corners of `which` smoothed to `to`. */
static int
smooth(const Misfit *m, const int which[4], const double *phi, double *to)
{
	double *share = calloc((size_t)m->g.nu*m->g.nv, sizeof *share);
	int k, e = share ? 0 : CORNERSMOOTH_ENOMEM;

	for (k = 0; k < 4 && !e; k++)
		if (which[k])
			set_share(m->g, k, share);
	if (!e && harmonic_share(m->g, share, phi, to))
		e = CORNERSMOOTH_ENOMEM;
	free(share);
	return e;
}

/* Clears in `which` the corners that smoothing does not help: those with folded cells that do not become
 * fewer, and those that gain folded cells.  Returns their number. */
static int
leave_out(Chart g, int which[4], const double *phi, const double *smoothed)
{
	size_t all = (size_t)g.nu*g.nv;
	const double *const x[3] = { phi, phi + all, phi + 2*all };
	const double *const y[3] = { smoothed, smoothed + all, smoothed + 2*all };
	int k, before, after, left = 0, radius = corner_radius(g);

	for (k = 0; k < 4; k++) {
		before = which[k] ? corner_folds(g, k, x, radius) : 0;
		after = which[k] ? corner_folds(g, k, y, radius) : 0;
		if (after > before || (before && after == before)) {
			which[k] = 0;
			left++;
		}
	}
	return left;
}

int
corners_smooth(const Misfit *m, double *phi)
{
	size_t all = (size_t)m->g.nu*m->g.nv;
	double *const x[3] = { phi, phi + all, phi + 2*all };
	const double *const fixed[3] = { x[0], x[1], x[2] };
	int k, count = 0, left = 1, e = 0, which[4];
	double *to = NULL;

	if (m->place)
		blend_with_place(m, phi);
	for (k = 0; k < 4; k++)
		count += which[k] = wants(m, k, fixed);
	if (count && !(to = malloc(3*all*sizeof *to)))
		return CORNERSMOOTH_ENOMEM;
	while (!e && count && left) {
		e = smooth(m, which, phi, to);
		left = e ? 0 : leave_out(m->g, which, phi, to);
		count -= left;
	}
	if (!e && count)
		memcpy(phi, to, 3*all*sizeof *to);
	for (k = 0; k < 4 && !e && count; k++)
		if (which[k])
			corner_unfold(m->g, k, x, corner_radius(m->g));
	free(to);
	return e;
}
