/* conformal.h - the conformal grid of a disk: map, sample, polish. */
#ifndef CONFORMAL_H
#define CONFORMAL_H

#include "adapt.h"
#include "polish.h"

typedef struct ConformalOptions {
	AdaptOptions map;
	int    surface;         /* SAMPLER_FACETS or SAMPLER_SMOOTH */
	int    polish;          /* rounds at most */
	double keep;            /* > 0: the fewest cells of conformal_cells, equally many along u and v,
	                         * whose grid has this share of the area of the disk */
	int    most;            /* then: cells at most, >= 4; as many if the share is not reached */
} ConformalOptions;

typedef struct Conformal {
	Grid    grid;           /* with its T */
	double *u, *v;          /* [nv] positions of the vertices of the disk in the
	                         * chart of the grid */
	double  certificate;    /* of the map, before the polish */
	int     vertices;       /* of the mesh it was solved on */
	int     overlaid;       /* triangles of the disk that the map turned over or made flat when drawn
	                         * straight; facets are sampled near them (sampler_overlay) */
	int     solved_turned;  /* triangles of the mesh it was solved on with (u,v) area < 0 */
	int     turned;         /* triangles of the disk with (u,v) area < 0 */
	int     polished;       /* rounds kept */
} Conformal;

/* Maps the disk d and samples it on g.nu x g.nv nodes (g.T is not read; nor is g.nu x g.nv if
 * options->keep is set).  corner: indices into
 * its loop.  Returns 0, SPD_ENOMEM, SPD_EINDEFINITE or SPD_ELARGE; on an error c holds nothing to
 * free. */
int  conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report);
/* The numbers of cells to try, 32 48 64 96 128 192 ..: the next after n. */
static inline int
conformal_cells(int n)
{
	return n < 32 ? 32 : n % 3 ? n/2*3 : n/3*4;
}

void conformal_free(Conformal *c);

#endif
