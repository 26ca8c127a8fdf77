/* clean.h - from the polygons of a file to triangles that can be repaired.  Private to lib/mend. */
#ifndef CLEAN_H
#define CLEAN_H

#include "mend.h"
#include "sheet.h"

/* Splits the polygons of a soup into triangles: sets s, without twins, all vertices with their numbers
 * in the soup.  Triangles keep their corners; equal corners in a row count once; a polygon that cannot
 * be split into triangles with area is split into a fan.  Counts in r, from 0, the unused vertices and the
 * faces that are left out: missing, infinite, broken, twice, each with its first.  Faces
 * marked as filled in the soup stay marked.
 *
 * Returns 0, MESH_ENOMEM, or MESH_EDISK if no face is left. */
int sheet_clean(Sheet *s, const Soup *soup, MendReport *r);

#endif
