/* piece.h - the components of a sheet, connected across edges.  Private to lib/mend. */
#ifndef PIECE_H
#define PIECE_H

#include "sheet.h"

typedef struct Piece {
	int    nv, nf, loops;   /* vertices, faces, boundary loops */
	int    first;           /* its first face */
	int    genus;           /* handles; of a one-sided piece, cross-caps counted half, rounded up */
	double area;
} Piece;

/* Sets piece[f] to the component of each face, numbered by their first faces, and *list to their
 * measures, to be freed.  Needs s->twin and a vertex for each fan.  Returns their number, or
 * MESH_ENOMEM. */
int piece_find(const Sheet *s, int *piece, Piece **list);

/* The n largest of all components by area, the lower number first if they are equal: sets chosen[i] to
 * 1 or 0. */
void piece_largest(const Piece *list, int all, int n, unsigned char *chosen);

/* Turns faces so that neighbours agree, in each component with the orientation of most of its faces.
 * Returns how many were turned, MESH_ENOMEM, or MESH_EORIENT if a component is one-sided. */
int piece_orient(Sheet *s);

#endif
