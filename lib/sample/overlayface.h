/* overlayface.h - finds in which face of a mesh each triangle of its subdivision lies. */
#ifndef OVERLAYFACE_H
#define OVERLAYFACE_H

#include "gradient.h"
#include "../mesh/subdivision.h"

/* Finds the face of m in which each triangle of o lies.
 *
 * m     in   the mesh that o subdivides
 * s     in   the stars of m
 * face  out  [o->d.m.nf]; -1 if it cannot be determined, which happens only for triangles
 *            without area
 *
 * Returns 0 or MESH_ENOMEM. */
int overlay_faces(const Mesh *m, const Stars *s, const Subdivision *o, int *face);

#endif
