/* surface.h - a surface from a stream of grids or a mesh file, whichever it is. */
#ifndef CMD_SURFACE_H
#define CMD_SURFACE_H

#include "../lib/mesh.h"

/* The mesh of a file ("-": stdin): of an .lhg stream of one grid with channels x y z,
 * by its first bytes, or of a mesh file; or die with the reason. */
void surface_load(const char *path, Mesh *m);

#endif
