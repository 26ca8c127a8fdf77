/* overlay.h - the common subdivision of the mesh and an intrinsic triangulation.
 *
 * Its vertices are those of the mesh and the crossings; each of its triangles lies in one triangle of
 * the mesh and in one of the intrinsic triangulation.  So the surface and a map that is linear on
 * the intrinsic triangles are both linear on it, and where the map turns no intrinsic triangle it turns
 * none of these.
 */
#ifndef OVERLAY_H
#define OVERLAY_H

#include "../mesh/subdivision.h"
#include "intrinsic.h"

/* s      in   the mesh of t
 *        out  the common subdivision
 * u, v   in   [t->nv] the map at the vertices
 *        out  [s->d.m.nv] continued to the crossings; reallocated
 *
 * Returns 0 or INTRINSIC_ENOMEM; then s and u, v are only to be freed. */
int overlay(const Intrinsic *t, Subdivision *s, double **u, double **v);

#endif
