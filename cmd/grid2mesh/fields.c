/* fields.c - interpolates channels of a grid at the (u,v) of vertices. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/grid/gridpoint.h"
#include "../../lib/mesh/channel.h"
#include "../shared/chartof.h"
#include "fields.h"

static void
add(const CmdInput *in, const Lhg *g, const char *name, int flip, int nv, const double *uv, Channels *to)
{
	const double *f = cmd_need(in, g, name, LHG_GRID);
	double *x = channel_add(to, name, 1, (size_t)nv), sign = flip && strcmp(name, "H") == 0 ? -1 : 1;
	int i;

	if (!x)
		die("%s: no memory for channel %s at %d vertices", in->name, name, nv);
	channel_find(to, name)->type = CHANNEL_ANY;     /* the mesh may have had one of that name */
	for (i = 0; i < nv; i++)
		x[i] = uv ? NAN : f[i];
	if (uv)
		gridpoint_vertices(chart_of(g), 1, &f, nv, uv, x);
	for (i = 0; i < nv; i++)
		x[i] *= sign;
}

void
fields_add(const CmdInput *in, const Lhg *g, const Fields *f, int nv, const double *uv, Channels *to)
{
	char *copy, *word, *comma;

	if (!f->names)
		return;
	copy = cmd_alloc(strlen(f->names) + 1, 1);
	strcpy(copy, f->names);
	for (word = copy; word; word = comma) {
		if ((comma = strchr(word, ',')))
			*comma++ = '\0';
		add(in, g, word, f->flip, nv, uv, to);
	}
	free(copy);
}
