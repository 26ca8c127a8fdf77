/* meshpriv.h - what the parts of the mesh reader share.  Private to lib/. */
#ifndef MESHPRIV_H
#define MESHPRIV_H

#include "../mesh/fail.h"
#include "../mesh/mesh.h"

/* Reading position in a file and the soup that comes of it.  The counts s->nv and
 * s->nf are always those of whole records, so they number the one being read. */
typedef struct Reader {
	const char *p, *end;    /* what is left */
	long   line;            /* of p, from 1 */
	int    hash;            /* # begins a comment */
	int    wantuv;          /* read MESH_UV and s->T */
	double *uv;             /* the values of MESH_UV, once uv_start made it */
	Soup  *s;
	size_t ni;              /* corners, those of the open face included */
	size_t capv, capf, capi;
} Reader;

typedef struct Token {
	const char *s;
	size_t n;
} Token;

enum { SCAN_SHOW = 40 };

/* The next word, on any line or on this one only.  Returns 1, or 0 when there is none. */
int scan_token(Reader *r, Token *t);
int scan_word(Reader *r, Token *t);
void scan_skipline(Reader *r);

/* Is t that word, in any case? */
int scan_is(Token t, const char *word);

/* The value of t.  Returns 1, or 0 if t is no decimal number; nan, inf and what exceeds
 * a double are numbers here.  scan_int: 0 also when it exceeds a long long.
 *
 * strtod obeys LC_NUMERIC, and no lhgrid program calls setlocale: they stay in the C
 * locale.  In another one a point would be refused, never misread. */
int scan_number(Token t, double *x);
int scan_int(Token t, long long *i);

/* t, short and printable, for a message; returns buf. */
char *scan_show(Token t, char buf[SCAN_SHOW]);

size_t scan_left(const Reader *r);

/* Append to the soup; a face is the corners since the one before.  Each returns 0 or a
 * MESH_E code with the reason in r->s->err.  soup_corner takes a number from 0. */
int soup_reserve(Reader *r, size_t nv, size_t nf, size_t ni);
int soup_vertex(Reader *r, const double x[3]);
int soup_corner(Reader *r, long long i);
int soup_face(Reader *r);

/* Give back the room for faces and corners that was reserved and not used. */
void soup_trim(Reader *r);

/* Refuse a promise of more records than the bytes left could hold: 0 or MESH_EFORMAT.
 * room is how many those could be.  soup_cut: the file ends in this record. */
int soup_promise(Reader *r, const char *what, long long count, size_t room);
int soup_cut(Reader *r, const char *what, long long i, long long count);

/* What follows the # or the word comment: "lhgrid T 0.91" sets s->T, all else is left.
 * Returns 0 or MESH_EVALUE. */
int uv_modulus(Reader *r);

/* Give all s->nv or nv vertices, whichever is more, (-1,-1).  0 or MESH_ENOMEM. */
int uv_start(Reader *r, size_t nv);

/* Is every (u,v) finite?  0 or MESH_EVALUE. */
int uv_check(const Reader *r);

/* What is known of a file before it is read: its first n bytes, its first word without the
 * comments before it, and bounds on its size, both n when all of it is here. */
typedef struct MeshStart {
	const char *p;
	size_t n, least, most;
	Token  word;
} MeshStart;

/* How likely a file is of a format.  The likeliest is taken, of equally likely ones the first
 * of the table. */
enum { MESHSTART_NO, MESHSTART_MAYBE, MESHSTART_LIKELY, MESHSTART_SURE };

/* For each format: one of these; and all of the file, behind a byte order mark, into r->s. */
int off_recognise(const MeshStart *m);
int off_read(Reader *r);
int obj_recognise(const MeshStart *m);
int obj_read(Reader *r);
int ply_recognise(const MeshStart *m);
int ply_read(Reader *r);
int stl_recognise(const MeshStart *m);
int stl_read(Reader *r);

/* Inflate gzip members into malloc'd *out, at most `most` bytes.  Returns 0, MESH_ENOMEM or
 * MESH_EFORMAT. */
int gunzip(const char *in, size_t n, size_t most, char **out, size_t *nout, char err[MESH_ERRLEN]);

/* The first bytes that gzip data unpack to, in out, of room for fewer than 4 GiB; returns how many,
 * 0 also if the data are damaged or memory is short. */
size_t gunzip_head(const char *in, size_t n, char *out, size_t room);

/* An unsigned number of n bytes. */
unsigned long long scan_bytes(const char *p, int n, int big);
double scan_float(const char *p, int n, int big);

#endif
