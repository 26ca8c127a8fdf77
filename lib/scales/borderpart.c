/* borderpart.c - the Laplace equation with given border values, by sine transforms. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../poisson/plate.h"
#include "borderpart.h"

enum { FIELDS = 3 };            /* of a plate */

/* The nodes of side `end` (0, 1) of an axis, without those on other open sides: the l-th of n is
 * node first + l*stride, and its neighbour inside is `in` further. */
typedef struct Side {
	size_t first, stride;
	ptrdiff_t in;
	int    n;
} Side;

static Side
side_of(Chart g, int axis, int end)
{
	const int *across = g.kind->joined[!axis];
	size_t last = axis ? (size_t)(g.nv - 1)*g.nu : (size_t)g.nu - 1, stride = axis ? 1 : g.nu;
	ptrdiff_t in = axis ? g.nu : 1;

	return (Side){ (end ? last : 0) + !across[0]*stride, stride, end ? -in : in,
	    (axis ? g.nu : g.nv) - !across[0] - !across[1] };
}

/* Calls `use` for each node p of each open side, except nodes on two open sides, with the neighbour of p
 * inside and w = 1/step^2, step being that between the two. */
static void
each_border_node(Chart g, void (*use)(void *ctx, size_t p, size_t inside, double w), void *ctx)
{
	double step[2] = { chart_h(g), chart_k(g) };
	int axis, end, l;

	for (axis = 0; axis < 2; axis++)
		for (end = 0; end < 2; end++) {
			Side s = side_of(g, axis, end);

			for (l = 0; l < s.n && !g.kind->joined[axis][end]; l++)
				use(ctx, s.first + l*s.stride, s.first + l*s.stride + s.in, 1/(step[axis]*step[axis]));
		}
}

typedef struct Lift {
	const double *f;
	double       *r, mean;
	size_t        n;
} Lift;

static void
add_to_mean(void *ctx, size_t p, size_t inside, double w)
{
	Lift *b = ctx;

	(void)inside, (void)w;
	b->mean += (b->f[p] - b->mean)/++b->n;
}

static void
add_to_residual(void *ctx, size_t p, size_t inside, double w)
{
	Lift *b = ctx;

	b->r[inside] += w*(b->f[p] - b->mean);
}

/* Whether node p is on an open side. */
static int
on_border(Chart g, size_t p)
{
	int at[2] = { p%g.nu, p/g.nu }, last[2] = { g.nu - 1, g.nv - 1 }, a;

	for (a = 0; a < 2; a++)
		if ((at[a] == 0 && !g.kind->joined[a][0]) || (at[a] == last[a] && !g.kind->joined[a][1]))
			return 1;
	return 0;
}

int
border_part(Chart g, int count, const double *const f[], double *const h[])
{
	size_t n = (size_t)g.nu*g.nv, p;
	double *z = calloc(FIELDS*n, sizeof *z);
	Lift b[FIELDS];
	Plate plate;
	int c;

	if (!z || plate_init(&plate, g, 0)) {
		free(z);
		return BORDERPART_ENOMEM;
	}
	for (c = 0; c < count; c++) {
		b[c] = (Lift){ .f = f[c], .r = z + c*n };
		each_border_node(g, add_to_mean, &b[c]);
		each_border_node(g, add_to_residual, &b[c]);
	}
	plate_solve(&plate, 0, 1, 0, z);
	for (c = 0; c < count; c++)
		for (p = 0; p < n; p++)
			h[c][p] = on_border(g, p) ? f[c][p] : z[c*n+p] + b[c].mean;
	plate_free(&plate);
	free(z);
	return 0;
}
