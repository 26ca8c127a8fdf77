/* choose.c - keeps the largest components. */
#include <stdlib.h>

#include "../mesh/fail.h"
#include "piece.h"
#include "step.h"

static int
by_area(const void *a, const void *b)
{
	const MendPiece *x = a, *y = b;

	return x->area > y->area ? -1 : x->area < y->area;
}

/* Reports the components.  chosen[i] is 1 if component i is kept. */
static int
report_pieces(const Piece *list, int n, const unsigned char *chosen, MendReport *r, char *err)
{
	int i;

	r->piece = mesh_alloc(err, (size_t)n, sizeof *r->piece);
	if (!r->piece)
		return MESH_ENOMEM;
	r->npiece = n;
	for (i = 0; i < n; i++) {
		r->piece[i] = (MendPiece){ list[i].nv, list[i].nf, list[i].loops, list[i].genus,
			list[i].area, chosen[i] };
		r->area += list[i].area;
	}
	qsort(r->piece, (size_t)n, sizeof *r->piece, by_area);
	return 0;
}

int
mend_choose(Sheet *s, const MendOptions *o, MendReport *r)
{
	int *piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece), n, f, e;
	unsigned char *keep = mesh_alloc(s->err, (size_t)s->nf, 1), *chosen = NULL;
	Piece *list = NULL;

	e = n = piece && keep ? piece_find(s, piece, &list) : MESH_ENOMEM;
	if (n >= 0 && !(chosen = mesh_alloc(s->err, (size_t)n, 1)))
		e = MESH_ENOMEM;
	if (e >= 0) {
		piece_largest(list, n, o->components ? o->components : n, chosen);
		for (f = 0; f < s->nf; f++)
			keep[f] = chosen[piece[f]];
		if ((e = report_pieces(list, n, chosen, r, s->err)) == 0)
			e = o->components && o->components < n ? sheet_keep(s, keep) : 0;
	}
	free(piece);
	free(keep);
	free(chosen);
	free(list);
	return e;
}
