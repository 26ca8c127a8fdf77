/* meshformat.h - the table of mesh formats, one row for each.
 *
 * Readers, writers, usage texts and messages use this table.  To add a format: a file with its
 * three functions, their prototypes in meshpriv.h and writepriv.h, and a row in meshformat.c.
 */
#ifndef MESHFORMAT_H
#define MESHFORMAT_H

#include <stddef.h>

#include "../mesh/mesh.h"

struct MeshStart;
struct Reader;
struct Text;

enum {
	MESHFORMAT_UV     = 1,  /* (u,v) can be read and written */
	MESHFORMAT_SHARED = 2,  /* faces share vertices, which keep their number and order */
	MESHFORMAT_WRITE  = 4,  /* can be written, not only read */
	MESHFORMAT_SINGLE = 8,  /* coordinates are written as floats */
	MESHFORMAT_FIELDS = 16  /* channels other than (u,v) are written */
};

typedef struct MeshFormat {
	const char *name;       /* "OFF" */
	const char *ends;       /* the endings of file names, separated by blanks: ".off" */
	unsigned    can;        /* flags from above */
	int       (*recognise)(const struct MeshStart *);       /* meshpriv.h */
	int       (*read)(struct Reader *);                     /* meshpriv.h */
	int       (*write)(struct Text *, const Soup *);        /* writepriv.h; NULL unless MESHFORMAT_WRITE */
} MeshFormat;

/* Row i, or NULL after the last.  Row 0 is the format that programs write to stdout. */
const MeshFormat *meshformat(int i);

/* The format to write to a file of this name, by the ending of the name, in upper or lower case;
 * NULL if no format that can be written has that ending. */
const MeshFormat *meshformat_of(const char *file);

/* Lists, for usage texts and messages, of the formats that have all flags of can.
 * meshformat_names gives their names: "OFF, OBJ or PLY" if word is "or".  meshformat_ends gives the
 * endings of their file names: ".off .obj or .ply".  Both write the list to buf and return buf. */
enum { MESHFORMAT_LIST = 160 };
char *meshformat_names(unsigned can, const char *word, char buf[MESHFORMAT_LIST]);
char *meshformat_ends(unsigned can, char buf[MESHFORMAT_LIST]);

#endif
