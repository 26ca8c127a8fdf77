/* load.h - reading mesh files. */
#ifndef CMD_LOAD_H
#define CMD_LOAD_H

#include "../../lib/mesh/mesh.h"

/* The polygons of a mesh file ("-" or NULL: stdin), with its (u,v) if uv is not 0, or die with
 * the reason. */
void load_soup(const char *path, int uv, Soup *s);

/* The same from n bytes that were read already; frees them. */
void load_bytes(const char *name, char *bytes, size_t n, int uv, Soup *s);

/* The disk made from s, or die; repairs are noted. */
void load_disk(const char *name, const Soup *s, Disk *d);

/* Die if these bytes begin no mesh file.  A CmdLook. */
void load_look(const char *name, const char *head, size_t n);

#endif
