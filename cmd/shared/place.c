/* place.c - the channels place.x place.y place.z. */
#include "place.h"
#include "range.h"

const char *const PLACE[3] = { "place.x", "place.y", "place.z" };

int
place_of(const CmdInput *in, const Lhg *g, double *f[3])
{
	int c, count = 0;

	for (c = 0; c < 3; c++)
		count += lhg_find(g, PLACE[c]) != NULL;
	for (c = 0; c < 3 && count; c++) {
		f[c] = cmd_need(in, g, PLACE[c], LHG_GRID);
		range_width(in, g, PLACE[c]);
	}
	return count > 0;
}

int
place_starts(const CmdInput *in, Lhg *g, int change)
{
	static const char *const start[3] = { "start.x", "start.y", "start.z" };
	double *f[3];
	int c;

	for (c = 0; c < 3; c++) {
		const LhgChannel *s = lhg_find(g, start[c]);

		if (!s || s->support != LHG_LATTICE)
			return 0;
	}
	if (!place_of(in, g, f))
		return 0;
	for (c = 0; c < 3 && change; c++) {
		lhg_drop(g, start[c]);
		cmd_add(g, start[c], "length", LHG_LATTICE, 1);
		lhg_gather(g, lhg_find(g, start[c]), lhg_find(g, PLACE[c])->f);
	}
	return 1;
}

void
place_drop(Lhg *g)
{
	int c;

	for (c = 0; c < 3; c++)
		lhg_drop(g, PLACE[c]);
	lhg_setmeta(g, "scale", NULL);
	lhg_setmeta(g, "relief", NULL);
}
