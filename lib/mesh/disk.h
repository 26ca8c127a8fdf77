/* disk.h - makes a disk of a polygon soup, or gives the reason why this is impossible. */
#ifndef DISK_H
#define DISK_H

#include "mesh.h"

/* Split polygons into triangles, then make repairs that need no guess and list them in d->note: drop
 * vertices of no face; weld vertices of equal position if faces share no vertices at all (as in
 * every STL); turn faces so that neighbours agree, towards the side of the majority.  Then check,
 * in this order, each error with its place: corners in range, finite coordinates, no degenerate
 * face, edges of at most two faces, one orientation, one component, vertices with one fan, one
 * boundary loop, no handles.
 *
 * The disk has the channels of s; a vertex welded from several has those of the first.
 *
 * s is only read.  Returns 0, MESH_ENOMEM, MESH_EINDEX, MESH_EVALUE, MESH_EFACE,
 * MESH_EMANIFOLD, MESH_EORIENT or MESH_EDISK, with the reason in d->err; d then holds
 * nothing to free. */
int disk_from_soup(Disk *d, const Soup *s);

/* The faces of a soup, for uses that need no disk: repaired and numbered as above, but faces that
 * cannot be split into triangles of some area are left out (d->note has their number and the first
 * of them), none is turned, and nothing is checked except that corners are in range, coordinates
 * are finite and a face is left.  loop and twin are NULL.
 *
 * Returns 0, MESH_ENOMEM, MESH_EINDEX, MESH_EVALUE, MESH_EFACE or MESH_EDISK, as above. */
int disk_loose(Disk *d, const Soup *s);

/* Reverse the normal: the orientation of every face and of the loop, which still begins at its lowest
 * vertex. */
void disk_flip(Disk *d);

/* Copy a channel of the disk to the soup it was made from, under that name: f, n numbers at each
 * vertex of d, and `none` at the vertices that were dropped.
 *
 * f        in   [d->m.nv][n]
 * s        in   the soup of disk_from_soup; a channel of that name is overwritten
 *
 * Returns 0 or MESH_ENOMEM, with the reason in s->err. */
int disk_channel_to_soup(const Disk *d, const char *name, int n, const double *f, double none, Soup *s);

/* The same for the (u,v) of the disk, [d->m.nv] each: the channel MESH_UV of s, and s->T.  (u,v)
 * outside [0,1] x [0,T], which a map of negative cotangents may have, are moved to its border. */
int disk_uv_to_soup(const Disk *d, const double *u, const double *v, double T, Soup *s);

#endif
