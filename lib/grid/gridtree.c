/* gridtree.c - the distance of points from a gridded surface, by a pyramid of boxes. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "gridtree.h"

enum { BLOCK = 4 };     /* cells along a side of the lowest boxes */

static double
segment2(const double a[3], const double e[3], const double x[3])
{
	double d[3], length2 = dot3(e, e), s;
	int c;

	sub3(x, a, d);
	s = length2 > 0 ? fmin(fmax(dot3(d, e)/length2, 0), 1) : 0;
	for (c = 0; c < 3; c++)
		d[c] -= s*e[c];
	return dot3(d, d);
}

/* The squared distance of x from the triangle a, b, c, which may be degenerate (a line or a
 * point). */
static double
triangle2(const double *a, const double *b, const double *c, const double x[3])
{
	const double *corner[3] = { a, b, c };
	double e[3][3], n[3], d[3], side[3], n2, best = HUGE_VAL;
	int k, inside = 1;

	sub3(b, a, e[0]);
	sub3(c, b, e[1]);
	sub3(a, c, e[2]);
	cross3(e[0], e[1], n);
	n2 = dot3(n, n);
	for (k = 0; k < 3; k++) {
		sub3(x, corner[k], d);
		cross3(e[k], d, side);
		inside &= dot3(side, n) > 0;
	}
	if (inside && n2 > 0)
		return dot3(d, n)*dot3(d, n)/n2;
	for (k = 0; k < 3; k++)
		best = fmin(best, segment2(corner[k], e[k], x));
	return best;
}

double
gridtree_cell2(const GridTree *t, int n, const double x[3])
{
	const int *v = t->m->tri + 6*(size_t)n;
	double d[2];
	int k;

	for (k = 0; k < 2; k++)
		d[k] = triangle2(t->m->xyz + 3*(size_t)v[3*k], t->m->xyz + 3*(size_t)v[3*k+1],
		    t->m->xyz + 3*(size_t)v[3*k+2], x);
	return fmin(d[0], d[1]);
}

static double *
box(const GridTree *t, int level, int i, int j)
{
	return t->box[level] + 6*((size_t)j*t->nu[level] + i);
}

/* Enlarges the box b so that it contains the box from lo to hi. */
static void
widen(double b[6], const double lo[3], const double hi[3])
{
	int c;

	for (c = 0; c < 3; c++) {
		b[c] = fmin(b[c], lo[c]);
		b[3+c] = fmax(b[3+c], hi[c]);
	}
}

/* The number of cells in row j from i on, at most BLOCK. */
static int
cells_from(const GridTree *t, int i, int j)
{
	int row = t->cells - j*t->ncu < t->ncu ? t->cells - j*t->ncu : t->ncu;

	return row - i < BLOCK ? row - i : BLOCK;
}

/* Enlarges the box b so that it contains block (i,j) of cells. */
static void
block_box(const GridTree *t, int i, int j, double b[6])
{
	int p, q, k;

	for (q = BLOCK*j; q < BLOCK*(j+1) && q < t->ncv; q++)
		for (p = 0; p < cells_from(t, BLOCK*i, q); p++)
			for (k = 0; k < 6; k++) {
				int node = t->m->tri[6*((size_t)q*t->ncu + BLOCK*i + p) + k];
				const double *x = t->m->xyz + 3*(size_t)node;

				widen(b, x, x);
			}
}

static void
fill(GridTree *t, int level)
{
	int i, j, p, q, c;

	for (j = 0; j < t->nv[level]; j++)
		for (i = 0; i < t->nu[level]; i++) {
			double *b = box(t, level, i, j);

			for (c = 0; c < 3; c++)
				b[c] = HUGE_VAL, b[3+c] = -HUGE_VAL;
			if (level == t->levels - 1) {
				block_box(t, i, j, b);
				continue;
			}
			for (q = 2*j; q < 2*j + 2 && q < t->nv[level+1]; q++)
				for (p = 2*i; p < 2*i + 2 && p < t->nu[level+1]; p++)
					widen(b, box(t, level+1, p, q), box(t, level+1, p, q) + 3);
		}
}

int
gridtree_init(GridTree *t, const Mesh *m, Chart g)
{
	int cells = m->nf/2, ncu = g.kind->joined[0][1] ? g.nu : g.nu - 1, ncv = (cells + ncu - 1)/ncu;
	int n, level, bu = (ncu - 1)/BLOCK + 1, bv = (ncv - 1)/BLOCK + 1;

	*t = (GridTree){ .m = m, .ncu = ncu, .ncv = ncv, .cells = cells, .levels = 1 };
	for (n = bu > bv ? bu : bv; n > 1; n = (n + 1)/2)
		t->levels++;
	for (level = t->levels - 1; level >= 0; level--) {
		t->nu[level] = bu;
		t->nv[level] = bv;
		if (!(t->box[level] = malloc(6*(size_t)bu*bv*sizeof **t->box))) {
			gridtree_free(t);
			return MESH_ENOMEM;
		}
		fill(t, level);
		bu = (bu + 1)/2;
		bv = (bv + 1)/2;
	}
	return 0;
}

void
gridtree_free(GridTree *t)
{
	int level;

	for (level = 0; level < GRIDTREE_LEVELS; level++)
		free(t->box[level]);
	memset(t->box, 0, sizeof t->box);
}

static double
box2(const double b[6], const double x[3])
{
	double d, sum = 0;
	int c;

	for (c = 0; c < 3; c++) {
		d = fmax(fmax(b[c] - x[c], x[c] - b[3+c]), 0);
		sum += d*d;
	}
	return sum;
}

static double
search_block(const GridTree *t, int i, int j, const double x[3], double best)
{
	int p, q;

	for (q = BLOCK*j; q < BLOCK*(j+1) && q < t->ncv; q++)
		for (p = 0; p < cells_from(t, BLOCK*i, q); p++)
			best = fmin(best, gridtree_cell2(t, q*t->ncu + BLOCK*i + p, x));
	return best;
}

static double
search(const GridTree *t, int level, int i, int j, const double x[3], double best)
{
	double d2[4];
	int k, n, nearest;

	if (level == t->levels - 1)
		return search_block(t, i, j, x, best);
	for (k = 0; k < 4; k++)
		d2[k] = 2*i + k%2 < t->nu[level+1] && 2*j + k/2 < t->nv[level+1] ?
		    box2(box(t, level+1, 2*i + k%2, 2*j + k/2), x) : HUGE_VAL;
	for (n = 0; n < 4; n++) {
		for (nearest = 0, k = 1; k < 4; k++)
			nearest = d2[k] < d2[nearest] ? k : nearest;
		if (!(d2[nearest] < best))
			break;
		best = search(t, level+1, 2*i + nearest%2, 2*j + nearest/2, x, best);
		d2[nearest] = HUGE_VAL;
	}
	return best;
}

double
gridtree_distance2(const GridTree *t, const double x[3], double bound2)
{
	return box2(box(t, 0, 0, 0), x) < bound2 ? search(t, 0, 0, 0, x, bound2) : bound2;
}
