/* piece.c - components, their measures, and their orientation. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "../mesh/topology.h"
#include "area.h"
#include "piece.h"

/* Numbers the trees of faces by their first faces; returns how many there are. */
static int
label(const Sheet *s, int *up, int *piece)
{
	int f, i, n = 0;

	for (f = 0; f < s->nf; f++)
		up[f] = f;
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] > i)
			sheet_unite(up, i/3, s->twin[i]/3);
	for (f = 0; f < s->nf; f++) {
		i = sheet_root(up, f);          /* the lowest face of the tree */
		piece[f] = i == f ? n++ : piece[i];
	}
	return n;
}

/* Counts faces, vertices and boundary loops of each piece; sides: boundary sides.  up is [nv]. */
static void
measure(const Sheet *s, const int *piece, Piece *list, int *sides, int *up)
{
	int f, i, v;

	for (v = 0; v < s->nv; v++)
		up[v] = -1;
	for (i = 0; i < 3*s->nf; i++) {
		v = s->tri[i];
		list[piece[i/3]].nv += up[v] < 0;
		up[v] = v;
	}
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] < 0) {
			sheet_unite(up, s->tri[i], sheet_to(s, i));
			sides[piece[i/3]]++;
		}
	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] < 0)             /* twice: a loop has two sides at its lowest vertex */
			list[piece[i/3]].loops += (sheet_root(up, s->tri[i]) == s->tri[i]) +
			    (sheet_root(up, sheet_to(s, i)) == sheet_to(s, i));
	for (f = 0; f < s->nf; f++) {
		Piece *p = &list[piece[f]];

		if (p->nf++ == 0)
			p->first = f;
		p->area += sheet_area(s, f);
	}
}

int
piece_find(const Sheet *s, int *piece, Piece **list)
{
	const int most = s->nv > s->nf ? s->nv : s->nf;
	int *up = mesh_alloc(s->err, (size_t)most, sizeof *up), *sides = NULL, n = MESH_ENOMEM, k, chi;

	*list = NULL;
	if (up) {
		n = label(s, up, piece);
		sides = mesh_alloc(s->err, (size_t)n, sizeof *sides);
		*list = mesh_alloc(s->err, (size_t)n, sizeof **list);
	}
	if (sides && *list) {
		memset(sides, 0, (size_t)n*sizeof *sides);
		memset(*list, 0, (size_t)n*sizeof **list);
		measure(s, piece, *list, sides, up);
		for (k = 0; k < n; k++) {
			Piece *p = *list + k;

			p->loops /= 2;
			chi = p->nv - (3*p->nf + sides[k])/2 + p->nf;   /* = 2 - 2 genus - loops */
			p->genus = (3 - p->loops - chi)/2;
		}
	} else {
		free(*list);
		*list = NULL;
		n = MESH_ENOMEM;
	}
	free(up);
	free(sides);
	return n;
}

void
piece_largest(const Piece *list, int all, int n, unsigned char *chosen)
{
	int i, k, most;

	memset(chosen, 0, (size_t)all);
	for (k = 0; k < n && k < all; k++) {
		for (most = -1, i = 0; i < all; i++)
			if (!chosen[i] && (most < 0 || list[i].area > list[most].area))
				most = i;
		chosen[most] = 1;
	}
}

static int
reversed(const signed char *turn, int side)
{
	return side < 0 || !turn[side/3] ? side : side - side%3 + 2 - side%3;
}

/* Turns the marked faces and numbers their sides again. */
static int
turn_faces(Sheet *s, const signed char *turn)
{
	int *twin = mesh_alloc(s->err, 3*(size_t)s->nf, sizeof *twin), i, f, c;

	if (!twin)
		return MESH_ENOMEM;
	for (i = 0; i < 3*s->nf; i++)
		twin[reversed(turn, i)] = reversed(turn, s->twin[i]);
	free(s->twin);
	s->twin = twin;
	for (f = 0; f < s->nf; f++)
		if (turn[f]) {
			int *t = s->tri + 3*(size_t)f;

			c = t[1], t[1] = t[2], t[2] = c;
		}
	return 0;
}

/* In each component where more than half of the faces are marked, marks the others instead.  Returns
 * how many are marked then. */
static int
turn_the_fewer(const Sheet *s, const int *piece, const Piece *list, int n, signed char *turn)
{
	int *marked = mesh_alloc(s->err, (size_t)n, sizeof *marked), f, count = 0;

	if (!marked)
		return MESH_ENOMEM;
	memset(marked, 0, (size_t)n*sizeof *marked);
	for (f = 0; f < s->nf; f++)
		marked[piece[f]] += turn[f];
	for (f = 0; f < s->nf; f++) {
		if (2*(long)marked[piece[f]] > list[piece[f]].nf)
			turn[f] = !turn[f];
		count += turn[f];
	}
	free(marked);
	return count;
}

static int
disagree(const Sheet *s)
{
	int i;

	for (i = 0; i < 3*s->nf; i++)
		if (s->twin[i] >= 0 && s->tri[i] == s->tri[s->twin[i]])
			return 1;
	return 0;
}

int
piece_orient(Sheet *s)
{
	const Topology t = { .nv = s->nv, .nf = s->nf, .tri = s->tri, .twin = s->twin,
		.file = s->source, .err = s->err };
	signed char *turn;
	int *piece, n, e = MESH_ENOMEM;
	Piece *list = NULL;

	if (!disagree(s))
		return 0;
	turn = mesh_alloc(s->err, (size_t)s->nf, 1);
	piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece);
	if (turn && piece && (e = topology_orient(&t, turn)) == 0) {
		e = n = piece_find(s, piece, &list);
		if (n >= 0)
			e = turn_the_fewer(s, piece, list, n, turn);
		if (e > 0 && turn_faces(s, turn))
			e = MESH_ENOMEM;
	}
	free(turn);
	free(piece);
	free(list);
	return e;
}
