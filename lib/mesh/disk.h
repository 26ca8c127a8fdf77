/* disk.h - makes a disk from a polygon soup, or says why this is impossible. */
#ifndef DISK_H
#define DISK_H

#include "mesh.h"

/* Splits polygons into triangles, makes the repairs that need no guess, lists these in d->note, and
 * checks the rest.  The repairs: drop vertices that belong to no face; if no two faces share a
 * vertex (as in every STL), weld vertices of equal position; turn faces so that neighbours agree,
 * with the orientation of the majority.  The checks: corners in range, finite coordinates, no
 * degenerate face, edges of at most two faces, consistent orientation, one component, one fan of
 * faces at each vertex, one boundary loop, no handles.  The first error is reported with its place.
 *
 * The disk has the channels of s; a vertex welded from several has those of the first.
 *
 * s is only read.  Returns 0; or MESH_ENOMEM, MESH_EINDEX, MESH_EVALUE, MESH_EFACE,
 * MESH_EMANIFOLD, MESH_EORIENT or MESH_EDISK, with the reason in d->err and nothing in d to
 * free. */
int disk_from_soup(Disk *d, const Soup *s);

/* As disk_from_soup, but a closed surface of genus 0 is taken, too: nb is then 0, and twin has no -1.
 * Its faces are turned so that the normal points outwards. */
int disk_or_closed(Disk *d, const Soup *s);

/* The faces of a soup, for uses that need no disk.  Vertices are dropped and welded as above, but
 * no face is turned.  Faces that cannot be split into triangles with area are left out; d->note
 * tells how many, and which was the first.  The only checks are that corners are in range,
 * coordinates are finite and at least one face is left.  loop and twin are NULL.
 *
 * Returns 0; or MESH_ENOMEM, MESH_EINDEX, MESH_EVALUE, MESH_EFACE or MESH_EDISK, as above. */
int disk_loose(Disk *d, const Soup *s);

/* Reverses the orientation of every face, hence the normal, and the direction of the loop.  The
 * loop still begins at its lowest vertex number. */
void disk_flip(Disk *d);

/* Flips a closed surface whose normal points inwards.  Returns whether it did. */
int  disk_turn_outwards(Disk *d);

#endif
