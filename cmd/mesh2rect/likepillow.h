/* likepillow.h - the option --like of mesh2rect on the pillow. */
#ifndef CMD_LIKEPILLOW_H
#define CMD_LIKEPILLOW_H

#include "../../lib/map/conformal.h"
#include "../shared/cmd.h"

typedef struct LikePillow {
	CmdInput in;
	Lhg      g;
} LikePillow;

/* Reads the grid in path, to which the closed surface `mesh` is to correspond, or dies if it is on no pillow or has no positions.
 * Sets o->like, which points into l, and nu and nv of g. */
void likepillow_read(const char *path, const char *mesh, LikePillow *l, Chart *g, ConformalOptions *o);

/* Reports the distance of the surfaces, and notes if another fit is about as good. */
void likepillow_report(const LikePillow *l, const Conformal *c);

#endif
