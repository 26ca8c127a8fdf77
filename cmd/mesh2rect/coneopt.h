/* coneopt.h - the options --chart and --cones of mesh2rect. */
#ifndef CMD_CONEOPT_H
#define CMD_CONEOPT_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

/* Sets cone to two inner vertices of d, or to three of a closed surface, or dies.  arg NULL or "auto": -1, chosen by
 * lib/map/cones.h or spherecones.h; "I,J": vertices by their number in the file; "x,y,z;x,y,z": the vertices nearest to
 * these points. */
void opt_cones(const char *arg, const Disk *d, int cone[3]);

/* Adds the metadata of a sock or a pillow. */
void cones_meta(Lhg *out, const Disk *d, const Conformal *c);

/* Whether a sock would hold the surface clearly better than the rectangle of c. */
int cones_help(const Conformal *c);

/* Notes it, unless another note has said so. */
void cones_note(const char *mesh, const Conformal *c, int noted);


/* On a pillow: prints the cones as details, and notes a chi^2 above 10. */
void cones_chi2(const char *mesh, const Disk *d, const Conformal *c);

#endif
