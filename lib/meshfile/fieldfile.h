/* fieldfile.h - files of numbers at the vertices of a mesh, without the mesh. */
#ifndef FIELDFILE_H
#define FIELDFILE_H

#include <stddef.h>

#include "meshfile.h"

struct Text;

/*
 * .shape.gii .func.gii  GIFTI: an array of floats for each channel, with its name
 * .curv .sulc .thickness  FreeSurfer: floats, one channel
 */
typedef struct FieldFormat {
	const char *name;       /* "GIFTI shape" */
	const char *ends;       /* the endings of file names, separated by blanks */
	int         most;       /* channels; 0: any number */
	int       (*write)(struct Text *, const Channels *, int nv, int nf);    /* private */
} FieldFormat;

/* The format for a file of this name, by its ending, in upper or lower case; NULL if it is none. */
const FieldFormat *fieldformat_of(const char *file);

/* All endings: ".shape.gii .func.gii .curv .." */
enum { FIELDFORMAT_LIST = 80 };
char *fieldformat_ends(char buf[FIELDFORMAT_LIST]);

/* Writes channels of one number at each of nv vertices of a mesh of nf faces.  *bytes is malloc'd; on failure
 * there is nothing to free.  Returns 0 or MESH_ENOMEM. */
int fieldfile_write(const Channels *c, int nv, int nf, const FieldFormat *format, char **bytes, size_t *n);

/* What a file of numbers at vertices has. */
typedef struct FieldFile {
	int      nv;
	long long nf;           /* faces, as a FreeSurfer curvature file says; 0: not known */
	double  *xyz;           /* [nv][3] the vertices of a PLY, else NULL */
	Channels c;
} FieldFile;

/* Reads the channels of a FreeSurfer curvature file (named `name`), a GIFTI file (named by their metadatum Name, or
 * name, name_1 ..) or a PLY mesh (the numbers at its vertices but x y z, normals and texture coordinates), nv numbers
 * each.  beside reads external arrays of GIFTI; NULL: they are refused (meshfile.h).  Returns 0; or
 * MESH_ENOMEM, MESH_EFORMAT, or MESH_EVALUE if a number is not finite, with the reason in err and nothing to free. */
int fieldfile_parse(const char *bytes, size_t n, const char *name, const MeshBeside *beside, FieldFile *f,
	char err[MESH_ERRLEN]);
void fieldfile_free(FieldFile *f);

/* The writers: giftiwrite.c, fswrite.c. */
int giftifields_write(struct Text *t, const Channels *c, int nv, int nf);
int fscurv_write(struct Text *t, const Channels *c, int nv, int nf);

#endif
