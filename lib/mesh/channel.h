/* channel.h - named arrays of numbers at the vertices of a mesh, such as (u,v), a scalar or a
 * colour. */
#ifndef CHANNEL_H
#define CHANNEL_H

#include "mesh.h"

/* The channel of that name, or NULL. */
Channel *channel_find(const Channels *c, const char *name);

/* The values of the channel of that name, [nv][n], or NULL. */
double *channel_values(const Channels *c, const char *name);

/* Whether numbers of that type are whole. */
int channel_whole(ChannelType type);

/* Whether it is red, green, blue or alpha. */
int channel_colour(const Channel *c);

/* Whether a file can hold x as that type; floats also where they round it. */
int channel_holds(ChannelType type, double x);

/* The values of MESH_SOURCE at nv vertices, if all are numbers of vertices of a mesh of `most`, or -1; else NULL. */
const double *channel_source(const Channels *c, int nv, int most);

/* Finds the channel of that name, or adds one of n numbers at each of nv vertices.  name has fewer
 * than CHANNEL_NAME characters.  Returns the values; those of a new channel are not set.  Returns
 * NULL if memory runs out, with the channels unchanged. */
double *channel_add(Channels *c, const char *name, int n, size_t nv);

/* Copies all channels of `from` to nv other vertices: new vertex i gets the values of old vertex
 * vertex[i], or `none` if that is -1.  `to` must be empty.  Returns 0, or MESH_ENOMEM with `to`
 * still empty. */
int channels_gather(Channels *to, const Channels *from, int nv, const int *vertex, double none);

void channels_free(Channels *c);

#endif
