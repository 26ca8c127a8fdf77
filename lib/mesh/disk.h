/* disk.h - from a polygon soup to a disk, or the true reason why not. */
#ifndef DISK_H
#define DISK_H

#include "mesh.h"

/* Split polygons into triangles, then repair what can be repaired without a guess and
 * say it in d->note: drop vertices of no face; weld vertices of equal position when
 * faces share no vertices at all (a soup, as STL always is); turn faces so that
 * neighbours agree, as most of them stand.  Then demand, in this order and each with
 * its place: corners in range, finite coordinates, no degenerate face, edges of at most
 * two faces, one orientation, one component, vertices with one fan, one boundary loop,
 * no handles.
 *
 * s is only read.  Returns 0, MESH_ENOMEM, MESH_EINDEX, MESH_EVALUE, MESH_EFACE,
 * MESH_EMANIFOLD, MESH_EORIENT or MESH_EDISK, with the reason in d->err; d then holds
 * nothing to free. */
int disk_from_soup(Disk *d, const Soup *s);

/* Turn the normal: every face the other way round, and with them the loop, which still
 * begins at its lowest vertex. */
void disk_flip(Disk *d);

/* The (u,v) of a disk's vertices given to the vertices of the soup it was made from:
 * s->uv, (-1,-1) for those that were dropped, and s->T.  What lies outside
 * [0,1] x [0,T], as a map of negative cotangents may, is put on its border.
 *
 * u, v     in   [d->m.nv]
 * s        in   the soup of disk_from_soup; its uv is allocated or overwritten
 *
 * Returns 0 or MESH_ENOMEM, with the reason in s->err. */
int disk_uv(const Disk *d, const double *u, const double *v, double T, Soup *s);

#endif
