/* anchor.h - moves a surface into place rigidly, by nodes whose positions are known. */
#ifndef ANCHOR_H
#define ANCHOR_H

#include <stddef.h>

#include "../base/chart.h"

enum {
	ANCHOR_ENOMEM = -1,
	ANCHOR_EVALUE = -2      /* positions that are not finite, or too large to be squared */
};

typedef struct Anchor {
	size_t  n, *node;
	double *at;             /* [n][3] the stored positions of these nodes */
	double *weight;         /* [n], or NULL: all equal */
} Anchor;

/* Stores the positions of the border nodes of phi[3][nv][nu], or of all nodes if border is 0, and their
 * weights, [nv][nu] or NULL.  Returns 0 or ANCHOR_ENOMEM; a then holds nothing to free. */
int  anchor_init(Anchor *a, Chart g, int border, const double *weight, const double *phi);
void anchor_free(Anchor *a);

/* Moves phi rigidly so that its nodes a->node come as near as possible to the stored positions, in
 * the sense of weighted least squares (procrustes.h).  Returns 0, ANCHOR_ENOMEM or ANCHOR_EVALUE. */
int anchor_place(const Anchor *a, Chart g, double *phi);

#endif
