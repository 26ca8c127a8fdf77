/* tangle.h - a disk mapped to a chart with some triangles turned over: the data of untangle.c and its
 * parts held.c, relax.c, collapse.c.  Private to this wing. */
#ifndef TANGLE_H
#define TANGLE_H

#include "../base/chart.h"
#include "../base/sheet.h"
#include "../mesh/mesh.h"
#include "../sample/gradient.h"

/* A vertex that may move, with its key (vertexkey.h). */
typedef struct Mover {
	double key;
	int    i;
} Mover;

/* Only the vertices of a region may move; relax enlarges the region. */
typedef struct Tangle {
	const Disk    *d;
	const ChartKind *kind;
	double         T;
	const int     *corner;  /* of the rectangle, as indices into the loop */
	const int     *cone;    /* of the sock, as vertices */
	unsigned char *side;    /* [nv] what holds a vertex (held.h), as bits; 0: it is free */
	Sheet         *sheet;   /* [3 nf] images of the corners of each triangle that lie on one sheet */
	double        *place;   /* [nv][2] the places to be kept where possible */
	double        *p;       /* [nv][2] the places now */
	Stars          star;
	double        *key;     /* [nv] of vertexkey.h */
	unsigned char *inside;  /* [nv] 1 in the region */
	Mover         *mover;   /* [nv] the vertices of the region, in the order of their keys */
	int            n;
	int           *tri, nt; /* [nf] the triangles at these vertices */
	double        *w;       /* [3 nf][2] weights at entry k of star.side: of the next corner of the
	                         * triangle, and of the one after it */
	double        *e;       /* [nv][2] p - place */
	double        *force;   /* [nv][2] (relax.h) */
	double        *area;    /* [nf] twice the areas before relax_back */
	int           *queue;   /* [nv] workspace of tangle_ball */
	unsigned char *ball;    /* [nv] */
} Tangle;

/* The image of corner h = 3*f + k of triangle f, on the sheet of f, for the places p. */
static inline void
tangle_image(const Tangle *t, const double *p, int h, double x[2])
{
	const double *q = &p[2*(size_t)t->d->m.tri[h]];

	x[0] = sheet_u(t->sheet[h], q[0]);
	x[1] = sheet_v(t->sheet[h], q[1]);
}

/* Whether triangle f may be turned over: its area is negative, or not certain to be positive.
 * Triangles that are flat beyond doubt are not: all corners on one side, or two at one place. */
int  tangle_bad(const Tangle *t, const double *p, int f);

/* The number of bad triangles at vertex i; the number of all bad triangles. */
int  tangle_star(const Tangle *t, const double *p, int i);
int  tangle_count(const Tangle *t);

/* Adds to queue[0..n-1] all vertices at most `rings` edges away from these, and sets t->ball to 1 at
 * all of them.  Returns the length of the queue. */
int  tangle_ball(Tangle *t, int n, int rings);

/* Sets t->ball to 0 for queue[0..n-1]. */
void tangle_clear(Tangle *t, int n);

#endif
