/* borderread.c - the boundary curve of a grid with x y z or band. */
#include "borderread.h"
#include "chartof.h"

/* Sets coordinate c of the border from a channel that has all border nodes. */
static void
border_coordinate(const Lhg *g, const LhgChannel *from, int c, Border *b)
{
	size_t k, p = lhg_first(g, from);
	int number;

	for (k = 0; k < from->n; k++, p = lhg_next(g, from, p)) {
		number = border_number(b->g, (int)(p%g->nu), (int)(p/g->nu));
		if (number >= 0)
			b->x[3*number + c] = from->f[k];
	}
}

void
border_read(const CmdInput *in, const Lhg *g, Border *b)
{
	static const char *const name[2][3] = { { "x", "y", "z" }, { "band.x", "band.y", "band.z" } };
	int band = !lhg_find(g, "x"), c;

	if (border_init(b, chart_of(g)))
		die("%s: no memory for the border of %d x %d nodes", in->name, g->nu, g->nv);
	for (c = 0; c < 3; c++) {
		cmd_need(in, g, name[band][c], band ? LHG_BORDER : LHG_GRID);
		border_coordinate(g, lhg_find(g, name[band][c]), c, b);
	}
	if (border_measure(b))
		die("%s: the boundary has no length", in->name);
}
