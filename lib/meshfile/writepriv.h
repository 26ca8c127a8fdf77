/* writepriv.h - shared by the mesh writers: text that grows, and the formats.  Private to lib/. */
#ifndef WRITEPRIV_H
#define WRITEPRIV_H

#include <stddef.h>
#include <stdint.h>

#include "../mesh/mesh.h"

/* A file that grows in memory. */
typedef struct Text {
	char  *p;
	size_t n, cap;
} Text;

enum { TEXT_MAX = 400 };        /* more than any piece appended at once */

/* Make room for one more piece.  Returns 1, or 0 if memory runs out. */
int text_room(Text *t);

/* Append the n low bytes of w, least significant first; a word; an integer >= 0. */
void text_bytes(Text *t, uint64_t w, int n);
void text_words(Text *t, const char *s);
void text_int(Text *t, int i);

/* Append nv lines of n numbers each, with a word before them.  Returns 0 or MESH_ENOMEM. */
int text_lines(Text *t, const double *x, int nv, int n, const char *before);

/* Append "lhgrid T 0.91" after the word that begins a comment, if s has (u,v) and T. */
void text_modulus(Text *t, const Soup *s, const char *before);

/* The corners of face f in *v; returns their number.  s->first is NULL where all faces are
 * triangles. */
int text_corners(const Soup *s, int f, const int **v);

/* For each format: append all of the file.  Returns 0, MESH_ENOMEM, MESH_EVALUE or MESH_EFACE. */
int off_write(Text *t, const Soup *s);
int obj_write(Text *t, const Soup *s);
int ply_write(Text *t, const Soup *s);
int stl_write(Text *t, const Soup *s);

#endif
