/* load.h - mesh files for the commands that read them. */
#ifndef CMD_LOAD_H
#define CMD_LOAD_H

#include "../../lib/mesh/mesh.h"

/* The polygons of a mesh file ("-" or NULL: stdin), or die with the reason. */
void load_soup(const char *path, Soup *s);

/* The same and the disk made from it, or die; what was repaired is noted. */
void load_both(const char *path, Soup *s, Disk *d);

#endif
