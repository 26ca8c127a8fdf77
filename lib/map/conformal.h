/* conformal.h - the conformal grid of a disk: map, sample, polish. */
#ifndef CONFORMAL_H
#define CONFORMAL_H

#include "adapt.h"
#include "polish.h"

typedef struct ConformalOptions {
	AdaptOptions map;
	int    surface;         /* SAMPLER_FACETS or SAMPLER_SMOOTH */
	int    polish;          /* rounds at most */
	int    keep_turned;     /* 1: turned triangles are no error */
} ConformalOptions;

typedef struct Conformal {
	Grid    grid;           /* with its T */
	double *u, *v;          /* [nv] positions of the vertices of the disk in the
	                         * chart of the grid */
	double  certificate;    /* of the map, before the polish */
	int     vertices;       /* of the mesh it was solved on */
	int     turned;         /* triangles of the sampled mesh with (u,v) area < 0 */
	int     polished;       /* rounds kept */
} Conformal;

enum { CONFORMAL_ETURNED = -20 };       /* c->turned > 0, and keep_turned is 0 */

/* Maps the disk d and samples it on g.nu x g.nv nodes (g.T is not read).  corner: indices into
 * its loop.  Returns 0, CONFORMAL_ETURNED, SPD_ENOMEM, SPD_EINDEFINITE or SPD_ELARGE; on an
 * error c holds nothing to free. */
int  conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report);
void conformal_free(Conformal *c);

#endif
