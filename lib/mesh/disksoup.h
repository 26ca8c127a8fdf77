/* disksoup.h - from a disk back to the polygon soup that it was made from. */
#ifndef DISKSOUP_H
#define DISKSOUP_H

#include "mesh.h"

/* Copies numbers at the vertices of a disk to a channel of the soup from which the disk was made.
 * f has n numbers at each vertex of d.  Vertices of the soup that were dropped get `none`.
 *
 * f        in   [d->m.nv][n]
 * s        in   the soup of disk_from_soup; a channel of that name is overwritten
 *
 * Returns 0 or MESH_ENOMEM, with the reason in s->err. */
int disk_channel_to_soup(const Disk *d, const char *name, int n, const double *f, double none, Soup *s);

/* Does the same for the (u,v) of the disk, [d->m.nv] each: sets the channel MESH_UV of s, and s->T.
 * Places outside [0,1] x [0,T] are moved to the border of the rectangle. */
int disk_uv_to_soup(const Disk *d, const double *u, const double *v, double T, Soup *s);

#endif
