/* channel.h - named numbers at the vertices of a mesh: (u,v), a scalar, a colour. */
#ifndef CHANNEL_H
#define CHANNEL_H

#include "mesh.h"

/* The channel of that name, or NULL. */
Channel *channel_find(const Channels *c, const char *name);

/* The values of the channel of that name, [nv][n], or NULL. */
double *channel_values(const Channels *c, const char *name);

/* A channel of n numbers at each of nv vertices: the one of that name, or a new one with room for
 * them.  name has fewer than CHANNEL_NAME characters.  Returns the values, which are not set, or
 * NULL if memory runs out; the channels are then unchanged. */
double *channel_add(Channels *c, const char *name, int n, size_t nv);

/* Copies all channels of `from` to nv other vertices: new vertex i gets the values of old vertex
 * vertex[i], or `none` if that is -1.  `to` must be empty.  Returns 0, or MESH_ENOMEM; `to` is then
 * still empty. */
int channels_gather(Channels *to, const Channels *from, int nv, const int *vertex, double none);

void channels_free(Channels *c);

#endif
