/* gridpart.c - moves nodes of a gridded surface so that every face has area. */
#include <stdlib.h>
#include <string.h>

#include "gridmesh.h"
#include "../mesh/repair.h"

static const double FIRST = 1./1024, GROWTH = 2;        /* share of the way in the first
                                                 * round; factor from round to round */
enum { ROUNDS = 24 };

typedef struct Nodes {
	Mesh          *m;
	int            nu, nv, single;
	unsigned char *moves;           /* [nv][nu] 1: the node is marked to be moved */
	double        *to;              /* [nv][nu][3] new positions of the marked nodes */
} Nodes;

static void
round_to_floats(double *x, size_t n)
{
	size_t k;

	for (k = 0; k < n; k++)
		x[k] = (float)x[k];
}

static double *
position(const Nodes *n, int i, int j)
{
	return n->m->xyz + 3*((size_t)j*n->nu + i);
}

/* Splits all cells anew, and marks the nodes of each cell that has faces without area.  Returns how
 * many such faces there are. */
static int
mark_flat(const Nodes *n)
{
	int i, j, k, p, flat, all = 0, *tri = n->m->tri;

	for (j = 0; j < n->nv - 1; j++)
		for (i = 0; i < n->nu - 1; i++, tri += 6) {
			p = j*n->nu + i;
			all += flat = gridmesh_cell(n->m, p, n->nu, tri);
			for (k = 0; k < 6 && flat; k++)
				n->moves[tri[k]] = 1;
		}
	return all;
}

/* Marks the nodes that coincide with another node; *equal is their number.  Returns 0 or
 * MESH_ENOMEM. */
static int
mark_equal(const Nodes *n, int *equal)
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

/* Sets `to` to the position of node (i,j), moved by this share of the way to the mean of its
 * neighbours. */
static void
move_towards_mean(const Nodes *n, int i, int j, double share, double to[3])
{
	static const int di[4] = { -1, 1, 0, 0 }, dj[4] = { 0, 0, -1, 1 };
	const double *x = position(n, i, j), *y;
	double sum[3] = { 0, 0, 0 };
	int k, c, count = 0;

	for (k = 0; k < 4; k++)
		if (i + di[k] >= 0 && i + di[k] < n->nu && j + dj[k] >= 0 && j + dj[k] < n->nv) {
			y = position(n, i + di[k], j + dj[k]);
			for (c = 0; c < 3; c++)
				sum[c] += y[c] - x[c];
			count++;
		}
	for (c = 0; c < 3; c++)
		to[c] = x[c] + share*sum[c]/count;
}

/* Moves all marked nodes except corners of the grid, and clears the marks.  Each new position follows
 * from the old positions of the neighbours. */
static void
move_marked(const Nodes *n, double share)
{
	int i, j;
	size_t p;

	for (p = 0, j = 0; j < n->nv; j++)
		for (i = 0; i < n->nu; i++, p++) {
			if ((i == 0 || i == n->nu - 1) && (j == 0 || j == n->nv - 1))
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
gridmesh_part(Mesh *m, int nu, int nv, int single, int *left)
{
	Nodes n = { m, nu, nv, single, calloc(m->nv, 1), malloc(3*(size_t)m->nv*sizeof *n.to) };
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
