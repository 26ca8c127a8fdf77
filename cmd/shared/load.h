/* load.h - reading mesh files. */
#ifndef CMD_LOAD_H
#define CMD_LOAD_H

#include "../../lib/mesh/mesh.h"

/* The polygons of a mesh file ("-" or NULL: stdin), with its (u,v) if uv is not 0, or die with
 * the reason. */
void load_soup(const char *path, int uv, Soup *s);

/* The same from n bytes that were read already; frees them. */
void load_bytes(const char *name, char *bytes, size_t n, int uv, Soup *s);

/* As load_soup without (u,v), but coordinates may be not finite, and corners may be vertices that do not
 * exist (lib/meshfile: meshfile_parse_loose). */
void load_soup_loose(const char *path, Soup *s);

/* Dies if a vertex that a face has is out of range (range.h). */
void load_range(const char *name, const Soup *s);

/* Sets d to the disk made from s, or dies.  Repairs are printed as a note. */
void load_disk(const char *name, const Soup *s, Disk *d);

/* Dies if no mesh file begins with the n bytes at head.  For cmd_slurp_if (cmd.h). */
void load_look(const char *name, const char *head, size_t n);

#endif
