/* gridfile.h - a grid as the bytes of a mesh file, for grid2mesh. */
#ifndef CMD_GRIDFILE_H
#define CMD_GRIDFILE_H

#include "../../lib/meshfile/meshformat.h"
#include "../../lib/meshfile/fieldfile.h"
#include "../shared/cmd.h"
#include "fields.h"

/* How the offsets of the mesh of --on are used. */
enum { OFFSETS_KEEP, OFFSETS_DROP, OFFSETS_SMOOTH };

/* The mesh of --on; name is NULL if the option is not given. */
typedef struct OnMesh {
	const char *name;
	int    offsets;
	Soup   s;
} OnMesh;

/* Reads the mesh of --on with its (u,v), or dies.  offsets is an OFFSETS_ value, or -1 if --detail is
 * not given.  Prints a note if vertices have no (u,v), and if --detail is given, but there are no
 * offsets.  The faces that fill holes are dropped, with the vertices that only they have, and this is
 * noted, unless keep_filled is not 0. */
void gridfile_read_mesh(const char *path, int offsets, int keep_filled, OnMesh *on);

/* Adds the fields of such a file to c, or dies. */
void gridfile_fields(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields, const FieldFormat *format,
	Channels *c);

/* Makes the bytes of a file of fields alone, at the vertices of the mesh of --on or at the nodes. */
void gridfile_field_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields,
	const FieldFormat *format, char **bytes, size_t *n);

/* Makes the bytes of a mesh file of that format, with the fields, or dies.  Positions are x y z of the grid, or
 * with fields place.x place.y place.z.  Without a mesh in `on`, the mesh has the
 * nodes of the grid and two triangles for each cell.  Otherwise it has the faces of that mesh, with
 * the vertices at their (u,v) on the grid and moved by their offsets. */
void gridfile_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields,
	const MeshFormat *format, char **bytes, size_t *n);

/* The same as a soup, to be freed by gridfile_soup_free.  single: coordinates will be rounded to floats; kind names the
 * file in notes. */
void gridfile_soup(const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields, int single,
	const char *kind, Soup *s);
void gridfile_soup_free(const OnMesh *on, Soup *s);

#endif
