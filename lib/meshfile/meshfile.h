/* meshfile.h - mesh files as bytes: any format of meshformat.h, plain or gzipped.
 *
 * Reading goes by content, never by name, so that a pipe serves as well as a file.
 */
#ifndef MESHFILE_H
#define MESHFILE_H

#include "../mesh/mesh.h"
#include "meshformat.h"

#define MESHFILE_MOST ((size_t)1 << 32) /* no larger file is read: 4 GiB, also when unpacked */

/* Parse n bytes (they need no final NUL).
 *
 * OFF  ASCII (also COFF, NOFF, STOFF..: the extra numbers are skipped; records may be
 *      broken over lines; # comments) and OFF BINARY (big-endian as
 *      Geomview writes it, little-endian as pmp does)
 * OBJ  v and f lines; f a, a/b, a//c, a/b/c; negative indices; the rest is skipped
 * PLY  ascii, binary_little_endian, binary_big_endian; any properties and extra
 *      elements; faces as vertex_indices or vertex_index lists, or tristrips
 * STL  ASCII and binary; every triangle has three vertices of its own
 *
 * most  in  bytes that gzip data may unpack to
 *
 * Returns 0, MESH_ENOMEM, MESH_EFORMAT, MESH_EINDEX or MESH_EVALUE, with the reason
 * and the place in s->err (a truncation names the record, "file ends in face 12 of
 * 100"); s then holds nothing to free.
 *
 * The memory is at most 1 KiB and 16 bytes for each byte given, whatever counts the file
 * promises.  Gzip data, known by their first bytes, are unpacked first.  deflate reaches 1030:1,
 * so they may unpack to 1100 bytes for each byte given, and to no more than most.  The 16 bytes
 * then count for each byte unpacked.  The buffer of unpacked bytes is added: while it grows at
 * most 3 bytes for each of them, 4 for each byte given, and 64 KiB for zlib. */
int meshfile_parse(Soup *s, const void *bytes, size_t n, size_t most);

/* The same, with the (u,v) of every vertex in the channel MESH_UV, the T they belong to in
 * s->T, 0 if the file does not have it, and, if the file has them, the offsets in MESH_OFFSET:
 *
 * OBJ  vt lines and corners a/b or a/b/c; T from a line "# lhgrid T 0.91";
 *      lines "# lhgrid offset 0.01 0 -0.002 0.03", one for each vertex in their order
 * PLY  vertex properties s t, or u v, or texture_u texture_v; T from "comment lhgrid T 0.91";
 *      offset_u offset_v offset_n offset_r
 *
 * In an OBJ, a vertex of no face has (-1,-1).  Also refused: formats without (u,v) and missing
 * (u,v) or offsets of some vertices only (MESH_EFORMAT); (u,v) and offsets that are not finite, and two
 * different (u,v) at a vertex (MESH_EVALUE). */
int meshfile_parse_uv(Soup *s, const void *bytes, size_t n, size_t most);

/* Whether a file of at most `most` bytes that begins with these n can be a mesh: 0, or
 * MESH_EFORMAT with the reason in err.  So an endless pipe is refused before it is read. */
int meshfile_plausible(const void *head, size_t n, size_t most, char err[MESH_ERRLEN]);

/* s as a file: its vertices and polygons as they are, and its channels MESH_UV and MESH_OFFSET and T if
 * it has them and the format carries them.  OFF and OBJ are text that gives back every double, PLY is
 * binary_little_endian double, STL binary float.  *bytes is malloc'd, *n its length.
 * Returns 0, MESH_ENOMEM, MESH_EVALUE: a coordinate exceeds what the format holds, or
 * MESH_EFACE: the format holds triangles only. */
int meshfile_write(const Soup *s, const MeshFormat *format, char **bytes, size_t *n);
int meshfile_write_mesh(const Mesh *m, const MeshFormat *format, char **bytes, size_t *n);

#endif
