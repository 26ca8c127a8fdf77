/* meshpriv.h - shared by the mesh readers: scanning text, growing a soup, the formats.  Private to
 * lib/. */
#ifndef MESHPRIV_H
#define MESHPRIV_H

#include "../mesh/fail.h"
#include "../mesh/mesh.h"

/* The position in the file being read, and the soup under construction.  s->nv and s->nf count
 * complete vertices and faces, so each is also the index of the one being read. */
typedef struct Reader {
	const char *p, *end;    /* the remaining bytes */
	long   line;            /* the line of p, counted from 1 */
	int    hash;            /* # begins a comment */
	int    read_uv, loose, fields, normals; /* MESHFILE_UV, LOOSE, FIELDS and NORMALS of meshfile.h */
	double *uv;             /* the values of MESH_UV, once uv_start made it */
	double (*offset)[4];    /* the values for MESH_OFFSET; noffset of them were read */
	size_t noffset, capoffset;
	size_t most;            /* the most bytes that packed data in the file may unpack to */
	size_t unused;          /* bytes of the file that arrays of XML may still take: each one once */
	const struct MeshBeside *beside;        /* reads files beside this one; NULL: there are none */
	size_t most_beside;     /* the most bytes that may still be read of them */
	Soup  *s;
	size_t ni;              /* corners read, including those of the unfinished face */
	size_t capv, capf, capi;        /* the allocated lengths of xyz/3, first and idx */
} Reader;

typedef struct Token {
	const char *s;
	size_t n;
} Token;

enum { SCAN_SHOW = 40 };

/* scan_token reads the next word of the file, scan_word the next word on the current line.  Both
 * return 1, or 0 if there is none. */
int scan_token(Reader *r, Token *t);
int scan_word(Reader *r, Token *t);
void scan_skipline(Reader *r);

/* Whether t is that word, in upper or lower case. */
int scan_is(Token t, const char *word);

/* Set *x or *i to the value of t.  Both return 1, or 0 if t is no decimal number.  scan_number also
 * accepts nan, inf and numbers too large for a double, and sets *x to an infinity.  scan_int returns
 * 0 also for numbers too large for a long long.
 *
 * strtod depends on LC_NUMERIC.  No program calls setlocale, so the locale is always C.  In another
 * locale a number with a decimal point would be refused, never misread. */
int scan_number(Token t, double *x);
int scan_int(Token t, long long *i);

/* t shortened and printable, for a message; returns buf. */
char *scan_show(Token t, char buf[SCAN_SHOW]);

size_t scan_left(const Reader *r);

/* Append to the soup.  soup_face ends a face, which consists of the corners appended since the
 * previous face.  In soup_corner, i counts vertices from 0.  soup_reserve allocates memory for so
 * many more vertices, faces and corners.  Each returns 0 or a MESH_E code with the reason in
 * r->s->err. */
int soup_reserve(Reader *r, size_t nv, size_t nf, size_t ni);
int soup_vertex(Reader *r, const double x[3]);
int soup_corner(Reader *r, long long i);
int soup_face(Reader *r);

/* A triangle strip being read: its last two corners, and how many it has so far. */
typedef struct Strip {
	long long a, b, turn;
} Strip;

/* Adds corner k of a triangle strip.  It makes a triangle with the two corners before it.  Every second
 * triangle has the opposite orientation.  k = -1 starts a new strip.  Triangles in which a vertex occurs
 * twice are left out, but count for the orientation.  Returns 0 or a MESH_E code. */
int soup_strip(Reader *r, Strip *t, long long k);

/* Frees the memory for faces and corners that was reserved but not used. */
void soup_trim(Reader *r);

/* soup_check_count checks that `count`, the number of records that a header announces, is at most
 * `room`, the number that the remaining bytes can hold.  Returns 0 or MESH_EFORMAT.  soup_truncated
 * returns MESH_EFORMAT with the message that the file ends in record i.  `what` names the records in
 * messages. */
int soup_check_count(Reader *r, const char *what, long long count, size_t room);
int soup_truncated(Reader *r, const char *what, long long i, long long count);

/* Reads the text of a comment: "lhgrid fact space tkras" is a fact; if (u,v) are read, "lhgrid T 0.91" sets
 * s->T, "lhgrid chart sock" s->chart, and "lhgrid offset 0 0 .1 .02" is the offset of the next vertex; any other is ignored.  Returns 0,
 * MESH_ENOMEM, MESH_EFORMAT or MESH_EVALUE. */
int uv_comment(Reader *r);

/* Appends an offset.  Returns 0 or MESH_ENOMEM. */
int offset_append(Reader *r, const double x[4]);

/* Make the channel MESH_UV for nv vertices, or s->nv if that is more, all (-1,-1).  Returns 0 or
 * MESH_ENOMEM. */
int uv_start(Reader *r, size_t nv);

/* Check that every (u,v) and every offset is finite, and that every vertex has an offset or none
 * has.  Make the channel MESH_OFFSET if there are offsets.  Returns 0, MESH_ENOMEM, MESH_EFORMAT or
 * MESH_EVALUE. */
int uv_check(Reader *r);

/* Read the next word as a coordinate or a whole number of record i of count.  `what` names the record in
 * messages, as in "face".  Return 0 or MESH_EFORMAT. */
int record_number(Reader *r, const char *what, long long i, long long count, double *x);
int record_int(Reader *r, const char *what, long long i, long long count, long long *x);

/* Read vertex s->nv of count; its three coordinates, the next words.  Returns 0 or a MESH_E code. */
int record_vertex(Reader *r, long long count);

/* Appends the fact (facts.h), unless the value is empty or FACTS_MOST bytes are full.  Returns 0 or
 * MESH_ENOMEM. */
int fact_add(Reader *r, const char *key, Token value);

/* Appends the fact on the rest of the line, after "lhgrid fact" in a comment, if its key is known. */
int fact_comment(Reader *r);

/* Decodes the next n bytes of base64 text from *p on, a run of its own with = at its end, and advances *p.
 * `what` names the data in messages.  Returns 0 or MESH_EFORMAT. */
int base64_read(Reader *r, const char *what, const char **p, const char *end, size_t n, char *out);

/* The beginning of a file, to recognise its format: its first n bytes, its first word after
 * comments, and its least and most size in bytes.  Both sizes are n if the whole file is at p. */
typedef struct MeshStart {
	const char *p;
	size_t n, least, most;
	Token  word;
} MeshStart;

/* How likely it is that a file has a certain format.  The likeliest format is chosen; among equally
 * likely ones, the first in the table. */
enum { MESHSTART_NO, MESHSTART_MAYBE, MESHSTART_LIKELY, MESHSTART_SURE };

/* For each format: x_recognise returns a MESHSTART value; x_read reads the file into r->s.  Both
 * are given the file without its byte order mark. */
int off_recognise(const MeshStart *m);
int off_read(Reader *r);
int obj_recognise(const MeshStart *m);
int obj_read(Reader *r);
int ply_recognise(const MeshStart *m);
int ply_read(Reader *r);
int stl_recognise(const MeshStart *m);
int stl_read(Reader *r);
int xyz_recognise(const MeshStart *m);
int xyz_read(Reader *r);
int mni_recognise(const MeshStart *m);
int mni_read(Reader *r);
int hoppe_recognise(const MeshStart *m);
int hoppe_read(Reader *r);
int fsbinary_recognise(const MeshStart *m);
int fsbinary_read(Reader *r);
int fsascii_recognise(const MeshStart *m);
int fsascii_read(Reader *r);
int vtk_recognise(const MeshStart *m);
int vtk_read(Reader *r);
int vtp_recognise(const MeshStart *m);
int vtp_read(Reader *r);
int gifti_recognise(const MeshStart *m);
int gifti_read(Reader *r);
int gltf_recognise(const MeshStart *m);
int gltf_read(Reader *r);

/* Whether a file begins with the n bytes of magic. */
int start_has(const MeshStart *m, const char *magic, size_t n);

/* The number of numbers from m->word to the end of its line; -1 if there is a word that is none. */
int start_numbers(const MeshStart *m);

/* Inflate gzip members into malloc'd *out, at most `most` bytes.  Returns 0, MESH_ENOMEM or
 * MESH_EFORMAT. */
int gunzip(const char *in, size_t n, size_t most, char **out, size_t *nout, char err[MESH_ERRLEN]);

/* Unpacks the beginning of gzip data to out, which has room for `room` bytes, fewer than 4 GiB.
 * Returns the number of unpacked bytes: those before the damage if the data are damaged, 0 if memory
 * runs out. */
size_t gunzip_head(const char *in, size_t n, char *out, size_t room);

/* An unsigned integer, or a float or double, of n bytes; big: most significant byte first. */
unsigned long long scan_bytes(const char *p, int n, int big);
double scan_float(const char *p, int n, int big);

#endif
