/* nodefields.h - numbers at the vertices of a mesh, at the nodes of its grid. */
#ifndef NODEFIELDS_H
#define NODEFIELDS_H

#include "../sample/sampler.h"
#include "conformal.h"

/* Samples the fields of the options, in the order of the vertices of d, at the nodes of c->grid.  s samples d,
 * or mesh, a subdivision of it.  Sets c->field and c->fields.  Returns 0 or SPD_ENOMEM; c->field then is to be
 * freed all the same. */
int nodefields(const Sampler *s, const ChartMap *map, const Subdivision *mesh, const Disk *d,
	const ConformalOptions *o, Conformal *c);

#endif
