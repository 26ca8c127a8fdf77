/* fields.h - channels of a grid on the vertices of a mesh, for grid2mesh --with. */
#ifndef CMD_FIELDS_H
#define CMD_FIELDS_H

#include "../../lib/mesh/mesh.h"
#include "../shared/cmd.h"

/* The fields of --with: names, separated by commas, of channels that cover the grid; flip: H is negated. */
typedef struct Fields {
	const char *names;      /* NULL: none */
	int         flip;
} Fields;

/* Adds the fields to `to`: at nv vertices with the places uv, by interpolation, or NaN where a vertex has
 * none; if uv is NULL, at the nodes.  Dies if a channel is missing. */
void fields_add(const CmdInput *in, const Lhg *g, const Fields *f, int nv, const double *uv, Channels *to);

#endif
