/* xml.h - the elements of an XML file (expat), and the arrays of numbers in them.  Private to lib/. */
#ifndef XML_H
#define XML_H

#include "meshpriv.h"

/* An XML file being read.  start is called at each start tag, end at each end tag.  Both return 0 or a
 * MESH_E code with the reason in r->s->err, which ends reading. */
typedef struct Xml {
	Reader *r;
	void   *arg;            /* for start and end */
	int   (*start)(struct Xml *, const char *name, const char **attr);
	int   (*end)(struct Xml *, const char *name);
	Token   text;           /* in start: the text before this tag, in end: the text of the element; as the
	                         * file has it, empty if another element is between */
	void   *parser;
	const char *from;       /* where the text of the innermost open element begins; NULL: after a child */
	int     e;
} Xml;

/* Reads the elements of the bytes from r->p to end.  whole: they are a whole XML file.  Entities other than
 * those of XML itself are refused.  Returns 0, MESH_ENOMEM, MESH_EFORMAT, or what start or end returned. */
int xml_read(Xml *x, const char *end, int whole);

/* The value of an attribute, or "" if it is missing. */
const char *xml_attribute(const char **attr, const char *name);

/* The value of an attribute as a whole number >= 0.  Returns 0 or MESH_EFORMAT. */
int xml_count(Xml *x, const char **attr, const char *name, long long *n);

/* The text without blanks at its ends and without <![CDATA[ ]]> round it. */
Token xml_plain(Token t);

/* Whether the file is XML that has this start of a tag near its beginning: MESHSTART_NO, LIKELY, or MAYBE if
 * the bytes at hand are too few to say. */
int xml_recognise(const MeshStart *m, const char *root);

enum { XML_ASCII, XML_BASE64, XML_RAW };        /* codings */
enum { XML_PLAIN, XML_ZLIB, XML_BLOCKS };       /* how bytes are packed: not; a zlib stream; VTK's blocks */

/* An array of numbers in the file. */
typedef struct XmlArray {
	Token text;             /* where the array begins, and all bytes that may belong to it */
	int   coding, packing;
	int   head;             /* VTK: size of the integers before the bytes, 4 or 8; 0: none */
	int   size, kind;       /* of a number: 4 or 8; 'i' signed, 'u' unsigned, 'f' floating; size 0, or text.s NULL: no array */
	int   big;
	char *own;              /* the bytes of text if they are malloc'd: in another file */
} XmlArray;

/* The n numbers of the array a, malloc'd; an array of other length is refused.  `what` names it in messages.
 * NULL, with *e set to MESH_ENOMEM or MESH_EFORMAT and the reason in r->s->err, if it fails.  Packed
 * data may unpack to at most 4 KiB plus 1100 bytes for each of theirs, and r->most bytes. */
double *xmlarray_numbers(Reader *r, const XmlArray *a, const char *what, long long n, int *e);

/* GIFTI: sets the text of a, of which size is set, to the bytes of n numbers in another file, by the attributes
 * ExternalFileName and ExternalFileOffset of a DataArray, which is number i of them.  Returns 0 or a MESH_E code; 0:
 * a->own is to be freed. */
int xmlarray_external(Xml *x, const char **attr, long long i, long long n, XmlArray *a);

#endif
