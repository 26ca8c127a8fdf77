/* meshfile.h - mesh files as bytes: OFF, OBJ, PLY and STL, plain or gzipped.
 *
 * Reading goes by content, never by name, so that a pipe serves as well as a file.
 */
#ifndef MESHFILE_H
#define MESHFILE_H

#include "../mesh/mesh.h"

enum { MESHFILE_OFF, MESHFILE_OBJ, MESHFILE_PLY, MESHFILE_STL };

/* Parse n bytes (they need no final NUL).
 *
 * OFF  ASCII (also COFF, NOFF, STOFF..: the extra numbers are skipped; records may be
 *      broken over lines; # comments) and OFF BINARY (big-endian as
 *      Geomview writes it, little-endian as pmp does)
 * OBJ  v and f lines; f a, a/b, a//c, a/b/c; negative indices; the rest is skipped
 * PLY  ascii, binary_little_endian, binary_big_endian; any properties and extra
 *      elements; faces as vertex_indices or vertex_index lists, or tristrips
 * STL  ASCII and binary; three own vertices for every triangle
 *
 * Returns 0, MESH_ENOMEM, MESH_EFORMAT, MESH_EINDEX or MESH_EVALUE, with the reason
 * and the place in s->err (a truncation names the record, "file ends in face 12 of
 * 100"); s then holds nothing to free.
 *
 * Takes at most 1 KiB and 16 bytes for each byte given, whatever counts the file promises.
 * Gzip data, known by their first bytes, are unpacked first; deflate reaches 1030:1, so what
 * they may unpack to is bounded by 1100 bytes for each byte given, and by 4 GiB.  The 16 are
 * then for each byte unpacked, beside the buffer that holds these (at most 3 for each while
 * it grows, 4 for each byte given, 64 KiB for zlib). */
int meshfile_parse(Soup *s, const void *bytes, size_t n);

/* The same, with the (u,v) of every vertex in s->uv and the T they belong to in s->T, 0 if
 * the file does not say it:
 *
 * OBJ  vt lines and corners a/b or a/b/c; T from a line "# lhgrid T 0.91"
 * PLY  vertex properties s t, or u v, or texture_u texture_v; T from "comment lhgrid T 0.91"
 *
 * A vertex of no face of an OBJ has (-1,-1).  Refused besides: other kinds (MESH_EFORMAT),
 * (u,v) missing (MESH_EFORMAT), not finite or two of them at one vertex (MESH_EVALUE). */
int meshfile_parse_uv(Soup *s, const void *bytes, size_t n);

/* The kind by the end of a file name (.off .obj .ply .stl, any case), or -1. */
int meshfile_kind(const char *name);

/* m as a file of that kind: OFF and OBJ as text that gives back every double, PLY
 * binary_little_endian double, STL binary float.  *bytes is malloc'd, *n its length.
 * Returns 0, MESH_ENOMEM, or MESH_EVALUE: STL, and a coordinate exceeds a float. */
int meshfile_format(const Mesh *m, int kind, char **bytes, size_t *n);

/* The same of a soup: its vertices and polygons as they are, and when s->uv is there its
 * (u,v) and T in OBJ and PLY, as meshfile_parse_uv reads them.  Not for MESHFILE_STL.
 * Returns 0 or MESH_ENOMEM. */
int meshfile_format_soup(const Soup *s, int kind, char **bytes, size_t *n);

#endif
