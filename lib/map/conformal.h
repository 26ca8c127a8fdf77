/* conformal.h - the conformal grid of a disk: map, sample, polish. */
#ifndef CONFORMAL_H
#define CONFORMAL_H

#include "adapt.h"
#include "polish.h"

typedef struct ConformalOptions {
	AdaptOptions map;
	int    surface;         /* SAMPLER_FACETS or SAMPLER_SMOOTH */
	int    polish;          /* rounds at most */
	int    keep_turned;     /* go on with turned triangles */
} ConformalOptions;

typedef struct Conformal {
	Grid    grid;           /* with its T */
	double *u, *v;          /* [nv] the disk's vertices in the chart of the grid */
	double  certificate;    /* of the map, before the polish */
	int     vertices;       /* of the mesh it was solved on */
	int     turned;         /* triangles of the sampled mesh with (u,v) area < 0 */
	int     polished;       /* rounds kept */
} Conformal;

enum { CONFORMAL_ETURNED = -20 };       /* c->turned > 0, and options do not keep them */

/* The disk d with corners at these places of its loop, on g.nu x g.nv nodes (g.T is not
 * read).  Returns 0, CONFORMAL_ETURNED, or SPD_ENOMEM, SPD_EINDEFINITE, SPD_ELARGE; then c
 * holds nothing to free. */
int  conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report);
void conformal_free(Conformal *c);

#endif
