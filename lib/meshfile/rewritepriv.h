/* rewritepriv.h - the parts of rewrite.h.  Private to lib/. */
#ifndef REWRITEPRIV_H
#define REWRITEPRIV_H

#include "meshpriv.h"
#include "writepriv.h"

/* A file being copied. */
typedef struct Copy {
	const char   *p, *end;
	const Soup   *s;        /* the mesh of the file */
	const double *xyz;      /* new positions */
	double       *normal;   /* [..][3], not normalized */
	Text          t;
	char         *err;
} Copy;

/* Twice the area vector of face f at the new positions. */
void rewrite_area(const Copy *c, int f, double n[3]);

/* Makes n a unit vector; a zero vector becomes (0,0,1). */
void rewrite_unit(double n[3]);

/* Append n bytes; a number in the fewest digits that give it back exactly.  Return 0 or MESH_ENOMEM. */
int rewrite_append(Copy *c, const char *p, size_t n);
int rewrite_number(Copy *c, double x);

/* The end of the line at p, behind its LF if it has one; the place behind the next word of the line that ends at
 * `end`. */
const char *rewrite_line(const Copy *c, const char *p);
const char *rewrite_word(const char *p, const char *end);

/* Returns MESH_EFORMAT, with the message that the file is laid out in a way that it cannot be copied. */
int rewrite_odd(const Copy *c);

/* Copy the file: rewriteobj.c, rewriteply.c.  Return 0, MESH_ENOMEM, or MESH_EFORMAT with the reason in c->err. */
int rewrite_obj(Copy *c);
int rewrite_ply(Copy *c);

#endif
