/* meshfile.h - mesh files as bytes: any format of meshformat.h, plain or gzipped.
 *
 * The format is recognised from the content, not from the name, so a pipe can be read, too.
 */
#ifndef MESHFILE_H
#define MESHFILE_H

#include "../mesh/mesh.h"
#include "meshformat.h"

#define MESHFILE_MOST ((size_t)1 << 32) /* largest file, packed or not: 4 GiB */

/* Parses a mesh file of n bytes (no final NUL is needed).
 *
 * OFF  ASCII (also COFF, NOFF, STOFF..: the extra numbers are skipped; records and counts may be
 *      broken over lines; the first count may follow OFF without a blank; "off"; # comments) and OFF
 *      BINARY (big-endian as Geomview writes it, little-endian as pmp does)
 * OBJ  v and f lines; f a, a/b, a//c, a/b/c; negative indices; the rest is skipped
 * PLY  ascii, binary_little_endian, binary_big_endian; any properties and extra
 *      elements; faces as vertex_indices or vertex_index lists, or tristrips
 * STL  ASCII and binary; every triangle has three vertices of its own
 * XYZ  a point on each line, x y z; more numbers are skipped; no faces
 * MNI OBJ     polygons, ASCII
 * Hoppe M     lines Vertex and Face; attributes are skipped
 * FreeSurfer  surfaces of triangles, binary and ASCII; the volume geometry becomes facts (facts.h)
 * VTK  legacy files of versions 1 to 5.1, ASCII and binary: POLYDATA, polygons and triangle strips; attributes
 *      are skipped
 * VTP  VTK XML files of PolyData: ASCII, base64, appended; plain or packed by zlib
 * GIFTI       surfaces: ASCII, Base64Binary, GZipBase64Binary, ExternalFileBinary; transforms are not applied
 * glTF 2  .glb and .gltf, with their data inside or in files beside them: triangles, strips and fans of all meshes of the scene, placed by
 *      the transforms of their nodes; vertices are not welded; a scene that needs more than 8 bytes for each byte
 *      of the file, as a mesh that many nodes use can, is refused
 *
 * most  in  the most bytes that gzip data may unpack to
 *
 * Returns 0; or MESH_ENOMEM, MESH_EFORMAT, MESH_EINDEX or MESH_EVALUE, with the reason and the
 * place in s->err and nothing in s to free.  For a truncated file the place is the record: "file
 * ends in face 12 of 100".
 *
 * The memory used is at most 1 KiB plus 16 bytes for each byte of input, whatever counts the file
 * announces.  Gzip data, recognised by their first bytes, are unpacked first, and the limit of 16
 * bytes holds for each unpacked byte.  The buffer of unpacked bytes comes on top: while it grows, at
 * most 3 bytes for each unpacked byte plus 4 for each byte of input.  zlib takes 64 KiB more.  Data
 * that unpack to more than `most` bytes are refused.  So are data that unpack to more than 4 KiB
 * plus 1100 bytes for each byte of input: they are damaged, as deflate compresses by at most
 * 1030:1.  Data packed inside a VTP or GIFTI file count as unpacked bytes by the number that the file
 * announces, with the same two limits.  GIFTI and glTF with a part in other files are refused. */
int meshfile_parse(Soup *s, const void *bytes, size_t n, size_t most);

/* Reads files beside a mesh file that hold a part of it. */
typedef struct MeshBeside {
	/* Reads `want` bytes of the file `name`, the first being number `from`; fewer if the file ends earlier.  Sets
	 * *bytes, malloc'd, to them and *n to their number.  The name is relative to the folder of the mesh, and has no folder "..".  Returns 0, or
	 * MESH_ENOMEM or MESH_EFORMAT with the reason in err and nothing to free. */
	int (*read)(const void *arg, const char *name, unsigned long long from, size_t want, char **bytes, size_t *n,
		char err[MESH_ERRLEN]);
	const void *arg;
} MeshBeside;

/* MESHFILE_UV: also reads the (u,v) of every vertex into the channel MESH_UV, the
 * height T of their chart into s->T (0 if the file does not have it) and its kind into s->chart (the
 * rectangle if only T is there, NULL if neither is), and the offsets, if the file has them, into the channel
 * MESH_OFFSET:
 *
 * OBJ  (u,v) from vt lines and corners a/b or a/b/c; T from a line "# lhgrid T 0.91"; offsets from
 *      lines "# lhgrid offset 0.01 0 -0.002 0.03", one for each vertex, in the order of the vertices;
 *      the chart from a line "# lhgrid chart sock" before the faces.  On a sock vertex k has vt k, and
 *      corners of a face across seam or fold have images of it (../base/sheet.h), to draw the face in one piece
 * PLY  (u,v) from vertex properties s t, or u v, or texture_u texture_v; T from a line "comment
 *      lhgrid T 0.91", the chart from "comment lhgrid chart sock"; offsets from vertex properties
 *      offset_u offset_v offset_n offset_r
 *
 * In an OBJ, a vertex that belongs to no face gets (-1,-1).  Returns MESH_EFORMAT also if the
 * format has no (u,v), if (u,v) are missing, or if only some vertices have offsets.  Returns
 * MESH_EVALUE also if a (u,v) or an offset is not finite, if the fourth number of an offset is
 * negative, if T is not positive, or if a vertex has two different (u,v).
 *
 * MESHFILE_LOOSE: for callers that check the result.  Coordinates may be NaN or infinite, and corners
 * may be numbers of vertices that do not exist; a number beyond an int becomes one below 0.  Returns 0,
 * MESH_ENOMEM or MESH_EFORMAT.
 *
 * MESHFILE_FIELDS: every other number that PLY has at the vertices becomes a channel of its name and type: colours,
 * quality, but not normals and texture coordinates.  Values may be infinite or nan.  A channel has the type of the
 * file, or CHANNEL_DOUBLE if text has a number that this type cannot hold.  s->left_out lists lists and what else cannot
 * be a channel, also of faces.
 *
 * MESHFILE_NORMALS, with MESHFILE_FIELDS: normals and texture coordinates, too, as nx ny nz s t .., unless they are the
 * (u,v) of a map, to which offsets belong. */
enum { MESHFILE_UV = 1, MESHFILE_LOOSE = 2, MESHFILE_FIELDS = 4, MESHFILE_NORMALS = 8 };

/* How to parse a mesh file. */
typedef struct MeshParse {
	size_t most;            /* as for meshfile_parse; files beside the mesh have at most as many bytes, too, together */
	unsigned what;          /* flags from above */
	const MeshBeside *beside;       /* NULL: the mesh comes from a pipe, and files beside it are refused */
} MeshParse;

/* As meshfile_parse, which is this with no flags and no files beside the mesh.  The bytes read of these count as
 * bytes of input. */
int meshfile_parse_as(Soup *s, const void *bytes, size_t n, const MeshParse *how);

/* Checks whether a file can be a mesh.  It has at most `most` bytes, and the first n are at head.
 * Returns 0, also if n bytes are too few to decide, or MESH_EFORMAT with the reason in err.  An
 * endless pipe can thus be refused early. */
int meshfile_plausible(const void *head, size_t n, size_t most, char err[MESH_ERRLEN]);

/* Writes the vertices and polygons of s, unchanged, as a mesh file in memory; also the channels
 * MESH_UV and MESH_OFFSET, the facts, and T, if s has them and the format can store them.  OFF and OBJ are
 * text from which every double is read back exactly, PLY is binary_little_endian double, STL is
 * binary float, VTP base64 double, GIFTI and FreeSurfer float.  PLY and VTP hold all other channels, too;
 * in PLY, colours red green blue alpha are bytes, rounded to 0 .. 255.
 * *bytes is malloc'd, *n its length; on failure there is nothing to free.  Returns 0,
 * MESH_ENOMEM, MESH_EVALUE if a coordinate is too large for the format, or MESH_EFACE if a face is
 * no triangle and the format has only triangles. */
int meshfile_write(const Soup *s, const MeshFormat *format, char **bytes, size_t *n);
int meshfile_write_mesh(const Mesh *m, const MeshFormat *format, char **bytes, size_t *n);

#endif
