/* remedy.h - extends the message of a refused mesh by the options of mesh2disk that can mend it.  For
 * lib/mesh only. */
#ifndef REMEDY_H
#define REMEDY_H

#include "topology.h"

/* Appends "; mesh2disk " and the remedy to the message.  Returns code. */
int remedy(char err[MESH_ERRLEN], int code, const char *what);

/* Appends that mesh2disk keeps the largest component, and its share of the area. */
int remedy_components(const Topology *t, const double *xyz, int code);

/* Appends how many boundary vertices lie within a millionth of the diagonal of the bounding box of
 * another, as the copies of a soup do, and how mesh2disk welds them.  Returns code. */
int remedy_close(const Topology *t, const double *xyz, int code);

/* The number of boundary vertices at the place of another, or MESH_ENOMEM with a message in d->err. */
int remedy_coincident(Disk *d);

#endif
