/* overlayface.h - where the triangles of a finer mesh lie on the given one. */
#ifndef OVERLAYFACE_H
#define OVERLAYFACE_H

#include "gradient.h"
#include "../mesh/subdivision.h"

/* The face of m that each triangle of o lies in.
 *
 * m     the given mesh of o
 * s     of m
 * face  out  [o->d.m.nf]; -1 if it cannot be told, which can happen to triangles without area
 *
 * Returns 0 or MESH_ENOMEM. */
int overlay_faces(const Mesh *m, const Stars *s, const Subdivision *o, int *face);

#endif
