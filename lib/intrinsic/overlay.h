/* overlay.h - the common subdivision of the mesh and an intrinsic triangulation.
 *
 * Its vertices are those of the mesh and the crossings.  Each of its triangles lies in one triangle
 * of the mesh and in one intrinsic triangle.  So the surface is flat on each of its triangles, and
 * a map that is linear on the intrinsic triangles is linear there, too.  A triangle of the
 * subdivision is turned over only if its intrinsic triangle is.
 */
#ifndef OVERLAY_H
#define OVERLAY_H

#include "../mesh/subdivision.h"
#include "intrinsic.h"

/* Makes the common subdivision, and continues the map to it.
 *
 * s      in   the subdivision whose disk is the mesh of t
 *        out  the common subdivision; s->inner is not kept
 * u, v   in   [t->nv] the map at the vertices
 *        out  [s->d.m.nv] the map at the vertices and crossings; reallocated
 *
 * Returns 0 or INTRINSIC_ENOMEM; then s and u, v are only to be freed. */
int overlay(const Intrinsic *t, Subdivision *s, double **u, double **v);

#endif
