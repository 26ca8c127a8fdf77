/* open.c - closed surfaces are cut open from end to end. */
#include <math.h>
#include <stdlib.h>

#include "../mesh/fail.h"
#include "area.h"
#include "open.h"
#include "path.h"
#include "piece.h"

/* The vertex of piece p nearest to a point; among equally near ones the lowest. */
static int
nearest(const Sheet *s, const int *piece, int p, const double *at)
{
	double d[3], least = HUGE_VAL;
	int i, found = -1;

	for (i = 0; i < 3*s->nf; i++) {
		if (piece[i/3] != p)
			continue;
		sub3(sheet_at(s, s->tri[i]), at, d);
		if (dot3(d, d) < least || (dot3(d, d) == least && s->tri[i] < found)) {
			least = dot3(d, d);
			found = s->tri[i];
		}
	}
	return found;
}

/* Cuts along the path from the start to the farthest vertex.  A cut along a single edge opens nothing, so
 * such a cut is continued along another edge of a face there. */
static double
cut(PathTree *t, Sheet *s)
{
	int v = t->order[t->n - 1], n = 0;
	const int side = t->via[v], more = s->tri[side] == v ? sheet_prev(side) : sheet_next(side);
	const double length = t->distance[v];

	for (; t->via[v] >= 0; v = path_before(t, s, v), n++)
		path_cut(s, t->via[v]);
	if (n > 1)
		return length;
	path_cut(s, more);
	return length + sheet_length(s, more);
}

int
open_all(Sheet *s, const double *at, double *length)
{
	int *piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece), n, p, v, merged, split, e;
	PathTree t = { 0 };
	Piece *list = NULL;

	*length = 0;
	e = n = piece ? piece_find(s, piece, &list) : MESH_ENOMEM;
	if (n >= 0)
		e = path_init(&t, s);
	for (p = 0; !e && p < n; p++) {
		if (list[p].loops > 0)
			continue;
		v = at ? nearest(s, piece, p, at) : s->tri[3*(size_t)list[p].first];
		path_from(&t, s, v, NULL);
		if (!at)
			path_from(&t, s, t.order[t.n - 1], NULL);
		*length += cut(&t, s);
	}
	if (!e)
		e = sheet_part(s, NULL, &merged, &split);
	path_free(&t);
	free(piece);
	free(list);
	return e;
}
