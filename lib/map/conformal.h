/* conformal.h - the conformal grid of a disk or a closed surface: map, sample, polish. */
#ifndef CONFORMAL_H
#define CONFORMAL_H

#include "adapt.h"
#include "cones.h"
#include "polish.h"
#include "untangle.h"

/* A sock is clearly better if its chi^2 is less than that of the rectangle over this.  A smaller gain shows
 * in numbers, but the surface is distributed less evenly over its boundary.  doc/mathematics.md 3.8. */
#define CONFORMAL_CLEARLY 6.5

/* The cones are equal or on the boundary, or lie so deep in limbs that they cannot be told apart. */
enum {
	CONFORMAL_ECONES = -30,
	CONFORMAL_ECOARSE = -31,        /* faces of a closed mesh that may not be split are too large on the sphere */
	CONFORMAL_ECHI2 = -32,          /* chi^2 of a pillow is above options->chi2; it is in c->chi2[1] */
	CONFORMAL_ETURNED = -33         /* too many faces of a closed mesh are turned over on the sphere */
};

/* A gridded surface to which places correspond. */
typedef struct ConformalLike {
	Chart         g;
	const double *phi[3];   /* [nv][nu]; NULL: none */
} ConformalLike;

typedef struct ConformalOptions {
	AdaptOptions map;
	int    surface;         /* SAMPLER_FACETS or SAMPLER_SMOOTH */
	int    polish;          /* largest number of rounds of polishing */
	double keep;            /* > 0: take the fewest cells of conformal_cells, equally many along
	                         * u and v, whose grid keeps this share of the area of the disk */
	int    most;            /* if keep > 0: largest number of cells along u and v, >= 4 */
	int    fields;          /* numbers at the vertices of d to sample on the grid */
	const double *const *field;     /* [fields][nv] */
	int    cone[3];         /* vertices that become the cones of a sock, or the cones (0,0), (1/2,0), (1/2,T) of a
	                         * pillow; -1: those with the best chi^2 */
	int    choose;          /* 1: take the sock in place of the given rectangle if it is clearly better */
	int    shape;           /* 1: take the number of nodes of the given grid, but on a sock choose nu and
	                         * nv so that its cells are about square */
	double chi2;            /* > 0: largest chi^2 of a pillow */
	ConformalLike like;     /* of a pillow: its height is taken, and cones by spherelike.h */
} ConformalOptions;

typedef struct Conformal {
	Grid    grid;           /* its g.T is the height T of the map */
	double *u, *v;          /* [nv] positions of the vertices of the disk in the
	                         * chart of the grid */
	double  certificate;    /* of the map, before the polish; of a sphere, of linear elements (sphere.h) */
	int     vertices;       /* of the mesh on which the map was solved */
	int     full;           /* 1 if splitting ended at about options->map.most vertices, or at the
	                         * limit of crossings (intrinsicmap.h) */
	int     overlaid;       /* triangles of the disk that are turned over or flat in (u,v), with
	                         * straight sides; near them facets are sampled (sampler_overlay) */
	int     solved_turned;  /* triangles of negative (u,v) area, of the mesh of the solve */
	Untangled uv;           /* how turned triangles of the disk were turned back (untangle.h) */
	int     polished;       /* rounds of polishing that were kept */
	int     cone[4];        /* vertices that are the cones of a sock, or were chosen for one; those at the cones
	                         * (0,0), (1/2,0), (1/2,T), (0,T) of a pillow, or nearest to them */
	double **field;         /* [options->fields][g.nv][g.nu] the fields at the nodes */
	int     fields;
	double  chi2[2];        /* of the rectangle; and of the sock or the pillow with these cones, or 0 if a sock
	                         * cannot be much better (cones.h, spherecones.h) */
	double  apart[2];       /* with options->like: rms and next of spherelike.h */
} Conformal;

/* Maps the disk d and samples it on a grid of the kind g.kind with g.nu x g.nv nodes (g.T is not read;
 * nor are g.nu and g.nv if options->keep > 0).  corner: indices into the loop of d.  Returns 0, SPD_ENOMEM,
 * SPD_EINDEFINITE, SPD_ELARGE or CONFORMAL_ECONES; on an error c holds nothing to free.  On SPD_EINDEFINITE
 * report->column is the vertex of d where the solve failed, -1: at one that was added. */
int  conformal_grid(const Disk *d, const int corner[4], Chart g, const ConformalOptions *options,
	Conformal *c, SpdReport *report);

/* Maps the closed surface d of genus 0 and samples it on a pillow of g.nu x g.nv nodes, in the same way.  Returns also
 * CONFORMAL_ECOARSE, CONFORMAL_ECHI2 or CONFORMAL_ETURNED. */
int  conformal_closed(const Disk *d, Chart g, const ConformalOptions *options, Conformal *c, SpdReport *report);

/* The number of cells along a side to try after n, of the sequence 32 48 64 96 128 192 .. */
static inline int
conformal_cells(int n)
{
	return n < 32 ? 32 : n % 3 ? n/2*3 : n/3*4;
}

void conformal_free(Conformal *c);

#endif
