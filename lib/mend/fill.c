/* fill.c - chooses the holes to fill, and fills them. */
#include <stdlib.h>

#include "../mesh/fail.h"
#include "hole.h"
#include "piece.h"
#include "step.h"

static int
by_length(const void *a, const void *b)
{
	const MendLoop *x = a, *y = b;

	if (x->length != y->length)
		return x->length > y->length ? -1 : 1;
	return x->at < y->at ? -1 : x->at > y->at;
}

static int
report_loops(const Sheet *s, const Loop *loop, int n, MendReport *r)
{
	int i;

	if (!(r->loop = mesh_alloc(s->err, (size_t)n, sizeof *r->loop)))
		return MESH_ENOMEM;
	r->nloop = n;
	for (i = 0; i < n; i++)
		r->loop[i] = (MendLoop){ s->source[s->tri[loop[i].side]], loop[i].n, loop[i].length };
	qsort(r->loop, (size_t)n, sizeof *r->loop, by_length);
	return 0;
}

/* Moves the loops that are to be filled to the front, in their order; returns their number.  piece:
 * [nf]; longest, all: [pieces], the longest loop of each component and the length of all its loops. */
static int
choose_loops(const MendOptions *o, Loop *loop, int n, const int *piece, double *all,
	int *longest)
{
	int i, p, m = 0;

	for (i = 0; i < n; i++) {
		p = piece[loop[i].side/3];
		all[p] += loop[i].length;
		if (longest[p] < 0 || loop[i].length > loop[longest[p]].length)
			longest[p] = i;
	}
	for (i = 0; i < n; i++) {
		p = piece[loop[i].side/3];
		if ((o->fill_all || longest[p] != i) && loop[i].length <= o->max_hole*all[p])
			loop[m++] = loop[i];
	}
	return m;
}

static int
fill_loops(Sheet *s, const MendOptions *o, Loop *loop, int n, MendReport *r)
{
	int *piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece), *longest = NULL, pieces = 0, i, e;
	Filled sum = { .left_at = -1, .order = o->fill };
	double *all = NULL;
	Piece *list = NULL;

	e = pieces = piece ? piece_find(s, piece, &list) : MESH_ENOMEM;
	if (e >= 0) {
		longest = mesh_alloc(s->err, (size_t)pieces, sizeof *longest);
		all = mesh_alloc(s->err, (size_t)pieces, sizeof *all);
		e = longest && all ? 0 : MESH_ENOMEM;
	}
	for (i = 0; !e && i < pieces; i++)
		longest[i] = -1, all[i] = 0;
	if (!e) {
		i = o->keep_holes ? 0 : choose_loops(o, loop, n, piece, all, longest);
		r->holes_kept = n - i;
		if ((e = hole_fill(s, loop, i, o->fill, &sum)) == 0) {
			r->holes = sum.holes, r->longest = sum.longest;
			r->faces = sum.faces, r->vertices = sum.vertices, r->order = sum.order;
			r->holes_left = sum.left;
			r->left_at = sum.left_at < 0 ? -1 : s->source[sum.left_at];
		}
	}
	free(piece);
	free(longest);
	free(all);
	free(list);
	return e;
}

int
mend_fill(Sheet *s, const MendOptions *o, MendReport *r)
{
	Loop *loop;
	int n, e;

	if (!o->keep_holes) {
		if ((e = hole_seams(s)) < 0)
			return e;
		r->seams = e;
	}
	if ((n = loop_find(s, &loop)) < 0)
		return n;
	if ((e = report_loops(s, loop, n, r)) == 0)
		e = fill_loops(s, o, loop, n, r);
	free(loop);
	return e;
}
