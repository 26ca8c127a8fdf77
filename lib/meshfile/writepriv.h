/* writepriv.h - shared by the mesh writers: a file that grows in memory.  Private to lib/. */
#ifndef WRITEPRIV_H
#define WRITEPRIV_H

#include <stddef.h>
#include <stdint.h>

#include "../mesh/mesh.h"

/* A file that grows in memory. */
typedef struct Text Text;
struct Text {
	char  *p;
	size_t n, cap;
};

enum { TEXT_MAX = 400 };        /* bytes; fewer are appended after each call of text_room */

/* Make room for TEXT_MAX bytes, to be called before they are appended.  Returns 1, or 0 if memory
 * runs out. */
int text_room(Text *t);

/* Append the n low bytes of w, least significant first; the string s; the integer i >= 0. */
void text_bytes(Text *t, uint64_t w, int n);
void text_words(Text *t, const char *s);
void text_int(Text *t, int i);

/* Append x[nv][n] as nv lines, each beginning with the string `before`.  Returns 0 or
 * MESH_ENOMEM. */
int text_lines(Text *t, const double *x, int nv, int n, const char *before);

/* Append n bytes as base64 text, one run with = at its end.  Returns 0 or MESH_ENOMEM. */
int text_base64(Text *t, const void *bytes, size_t n);

/* If s has (u,v) and T, append the comment line "lhgrid T 0.91", and on a chart other than the rectangle
 * "lhgrid chart sock".  `before` is what begins a comment in the format. */
void text_modulus(Text *t, const Soup *s, const char *before);

/* Append a comment line "lhgrid fact space tkras" for each of the facts of s.  Returns 0 or MESH_ENOMEM. */
int text_facts(Text *t, const Soup *s, const char *before);

/* Sets *v to the corners of face f and returns their number.  s->first may be NULL if all faces are
 * triangles. */
int text_corners(const Soup *s, int f, const int **v);

/* The writer of each format: appends the whole file.  Returns 0, MESH_ENOMEM, MESH_EVALUE or
 * MESH_EFACE. */
int off_write(Text *t, const Soup *s);
int obj_write(Text *t, const Soup *s);
int ply_write(Text *t, const Soup *s);
int stl_write(Text *t, const Soup *s);
int fsbinary_write(Text *t, const Soup *s);
int vtp_write(Text *t, const Soup *s);
int gifti_write(Text *t, const Soup *s);

#endif
