/* intrinsicsolve.h - the harmonic functions of an embeddable triangulation. */
#ifndef INTRINSICSOLVE_H
#define INTRINSICSOLVE_H

#include "../sparse/spd.h"
#include "embed.h"

typedef struct IntrinsicMap {
	Embeddable s;
	double    *u, *v;       /* [s.t.nv], after quadratic elements [s.t.nv + s.t.ne] */
	double     T, certificate;
	int        full;        /* 1 if splitting ended because there were as many vertices, or
	                         * crossings, as allowed */
	int        quadratic;   /* 1 if u, v are from quadratic elements */
	int        turned;      /* triangles of s.t with (u,v) area < -1e-14 T */
} IntrinsicMap;

/* Computes the map by linear elements.  Returns 0, SPD_ENOMEM or SPD_EINDEFINITE. */
int intrinsic_solve(IntrinsicMap *m, SpdReport *report);

/* Solves again with quadratic elements.  The new map replaces the old one if it has a smaller
 * certificate and turns no triangle over.  Returns 0 or SPD_ENOMEM. */
int intrinsic_solve_quadratic(IntrinsicMap *m, SpdReport *report);

#endif
