/* gridpart.c - moves nodes of a gridded surface so that every face has area. */
#include <stdlib.h>
#include <string.h>

#include "gridmesh.h"
#include "stencil.h"
#include "../mesh/repair.h"

static const double FIRST = 1./1024, GROWTH = 2;        /* share of the way in the first
                                                 * round; factor from round to round */
enum { ROUNDS = 24 };

typedef struct Parting {
	Mesh          *m;
	Chart          g;
	int            single;
	unsigned char *moves;           /* [nv][nu] 1: the node is marked to be moved */
	double        *to;              /* [nv][nu][3] new positions of the marked nodes */
} Parting;

static void
round_to_floats(double *x, size_t n)
{
	size_t k;

	for (k = 0; k < n; k++)
		x[k] = (float)x[k];
}

/* Splits all cells anew, and marks the nodes of each cell that has faces without area.  Returns how
 * many such faces there are. */
static int
mark_flat(const Parting *n)
{
	int c, k, flat, all = 0, *tri = n->m->tri;

	for (c = 0; c < n->g.kind->cells(n->g); c++, tri += 6) {
		all += flat = gridmesh_cell(n->m, n->g, c, tri);
		for (k = 0; k < 6 && flat; k++)
			n->moves[tri[k]] = 1;
	}
	return all;
}

/* Marks the nodes that coincide with another node; *equal is their number.  Returns 0 or
 * MESH_ENOMEM. */
static int
mark_equal(const Parting *n, int *equal)
{
	int nv = n->m->nv, *to = malloc(nv*sizeof *to), *count = calloc(nv, sizeof *count), p, different;
	int e = to && count && !repair_weld(nv, n->m->xyz, to, &different) ? 0 : MESH_ENOMEM;

	*equal = 0;
	for (p = 0; p < nv && !e; p++)
		count[to[p]]++;
	for (p = 0; p < nv && !e; p++)
		if (count[to[p]] > 1) {
			n->moves[p] = 1;
			++*equal;
		}
	free(to);
	free(count);
	return e;
}

/* Whether (i,j) is a node, or lies beyond a joined side. */
static int
is_there(Chart g, int i, int j)
{
	const int (*joined)[2] = g.kind->joined;

	return (i >= 0 || joined[0][0]) && (i < g.nu || joined[0][1]) && (j >= 0 || joined[1][0]) &&
	    (j < g.nv || joined[1][1]);
}

/* Sets `to` to the position of node (i,j), moved by this share of the way to the mean of its
 * neighbours. */
static void
move_towards_mean(const Parting *n, int i, int j, double share, double to[3])
{
	static const int di[4] = { -1, 1, 0, 0 }, dj[4] = { 0, 0, -1, 1 };
	int k, c, count = 0, sign = 1;
	const double *x = n->m->xyz + 3*stencil_node(n->g, i, j, &sign), *y;
	double sum[3] = { 0, 0, 0 };

	for (k = 0; k < 4; k++)
		if (is_there(n->g, i + di[k], j + dj[k])) {
			y = n->m->xyz + 3*stencil_node(n->g, i + di[k], j + dj[k], &sign);
			for (c = 0; c < 3; c++)
				sum[c] += y[c] - x[c];
			count++;
		}
	for (c = 0; c < 3; c++)
		to[c] = x[c] + share*sum[c]/count;
}

/* Moves all marked nodes except corners, where two open sides meet, and clears the marks.  Each new
 * position follows from the old positions of the neighbours. */
static void
move_marked(const Parting *n, double share)
{
	Range u = stencil_inner(n->g, 0), v = stencil_inner(n->g, 1);
	int i, j;
	size_t p;

	for (p = 0, j = 0; j < n->g.nv; j++)
		for (i = 0; i < n->g.nu; i++, p++) {
			if ((i < u.from || i >= u.to) && (j < v.from || j >= v.to))
				n->moves[p] = 0;
			if (n->moves[p])
				move_towards_mean(n, i, j, share, n->to + 3*p);
			if (n->moves[p] && n->single)
				round_to_floats(n->to + 3*p, 3);
		}
	for (p = 0; p < (size_t)n->m->nv; p++)
		if (n->moves[p])
			memcpy(n->m->xyz + 3*p, n->to + 3*p, 3*sizeof(double));
	memset(n->moves, 0, n->m->nv);
}

int
gridmesh_part(Mesh *m, Chart g, int single, int *left)
{
	Parting n = { m, g, single, calloc(m->nv, 1), malloc(3*(size_t)m->nv*sizeof *n.to) };
	double share = FIRST;
	int round, equal = 0, e = n.moves && n.to ? 0 : MESH_ENOMEM;

	*left = 0;
	if (single)
		round_to_floats(m->xyz, 3*(size_t)m->nv);
	for (round = 0; !e; round++) {
		*left = mark_flat(&n);
		if (single)
			e = mark_equal(&n, &equal);
		*left += equal;
		if (e || !*left || round == ROUNDS)
			break;
		move_marked(&n, share);
		share = share*GROWTH < 1 ? share*GROWTH : 1;
	}
	free(n.moves);
	free(n.to);
	return e;
}
