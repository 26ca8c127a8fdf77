/* load.h - reading mesh files. */
#ifndef CMD_LOAD_H
#define CMD_LOAD_H

#include "../../lib/meshfile/meshfile.h"

/* The polygons of a mesh file ("-" or NULL: stdin), read as the flags MESHFILE_UV .. of meshfile.h say, or die with
 * the reason. */
void load_soup(const char *path, unsigned what, Soup *s);

/* The same from n bytes that were read already from the file `path`. */
void load_bytes(const char *path, const char *bytes, size_t n, unsigned what, Soup *s);

/* Dies if a vertex that a face has is out of range (range.h). */
void load_range(const char *name, const Soup *s);

/* Sets d to the disk made from s, or dies.  Repairs are printed as a note. */
void load_disk(const char *name, const Soup *s, Disk *d);

/* As load_disk, but a closed surface of genus 0 is taken, too; it has no loop. */
void load_disk_or_closed(const char *name, const Soup *s, Disk *d);

/* Dies if no mesh file begins with the n bytes at head.  For cmd_slurp_if (cmd.h). */
void load_look(const char *name, const char *head, size_t n);

#endif
