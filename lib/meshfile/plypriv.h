/* plypriv.h - the header of a PLY file.  Private to lib/. */
#ifndef PLYPRIV_H
#define PLYPRIV_H

#include "meshpriv.h"

enum { PLY_ASCII, PLY_LITTLE, PLY_BIG };
enum { PLY_OTHER, PLY_VERTEX, PLY_FACE, PLY_STRIP };    /* kinds of elements */
enum { PLY_SKIP = -1, PLY_CORNERS = 3, PLY_UV = 4, PLY_OFFSET = 10,
	PLY_SOURCE = 14, PLY_FILLED = 15, PLY_USES = 16 };
                                /* values of PlyProp.use: 0 1 2 are x y z; 4 5, 6 7 and 8 9 are u v
                                 * by their three pairs of names; 10 to 13 are the offset; 14 is the
                                 * number of a vertex in another file, 15 marks faces in holes */
enum { PLY_MAXELEM = 32, PLY_MAXPROP = 256 };

typedef struct PlyType {
	const char *name, *alias;
	int size, kind;         /* 'u' unsigned, 'i' signed, 'f' floating */
} PlyType;

typedef struct PlyProp {
	const PlyType *type, *count;    /* count: type of the length of a list; NULL: no list */
	int use;
	Token name;
	double *field;                  /* the values at the vertices, if they become a channel */
} PlyProp;

typedef struct PlyElem {
	Token name;
	int kind;
	long long n;            /* number of records, as the header says */
	int p0, p1;             /* properties p0 .. p1-1 */
} PlyElem;

typedef struct Ply {
	Reader *r;
	int format, ne, np;
	int uv;                 /* the use of the u that is read: 4, 6 or 8; 0: none */
	int offset;             /* offsets are read */
	double *source;         /* the values of MESH_SOURCE, if the vertices have them */
	PlyElem elem[PLY_MAXELEM];
	PlyProp prop[PLY_MAXPROP];
} Ply;

/* Read up to the first byte of the data.  Returns 0 or MESH_EFORMAT. */
int ply_header(Ply *p);

/* The type of a property as that of a channel, and the property type for a channel of a type other than CHANNEL_ANY. */
ChannelType ply_channel_type(const PlyType *t);
const PlyType *ply_type(ChannelType type);

/* Makes channels of the properties of the vertices e, with which q->field is set, and s->left_out.  Returns 0, MESH_ENOMEM,
 * or MESH_EFORMAT if two have one name. */
int ply_fields(Ply *p, const PlyElem *e);

/* Sets the types of these channels, once they are read: CHANNEL_DOUBLE if text had a number that the type in the header
 * cannot hold. */
void ply_field_types(const Ply *p, const PlyElem *e);

/* The use of a vertex property of (u,v) or an offset, when these are to be read, else PLY_SKIP. */
int ply_uv_use(Token name);

/* The least size of a record of e in bytes, with all lists empty.  In ASCII a value has at least
 * two bytes, a digit and a blank; only the last value of a file may have no blank. */
size_t ply_least(const Ply *p, const PlyElem *e);

#endif
