/* writepriv.h - what the mesh writers share.  Private to lib/. */
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

enum { TEXT_MAX = 400 };        /* more than any piece put at once */

/* Room for one more piece; 0 when there is no memory. */
int text_room(Text *t);

/* The n low bytes of w, least significant first. */
void text_bytes(Text *t, uint64_t w, int n);

void text_words(Text *t, const char *s);

/* An integer >= 0. */
void text_int(Text *t, int i);

/* nv lines of n numbers each, with a word before them.  0 or MESH_ENOMEM. */
int text_lines(Text *t, const double *x, int nv, int n, const char *before);

/* "lhgrid T 0.91" behind the word that begins a comment, if s has (u,v) and T. */
void text_modulus(Text *t, const Soup *s, const char *before);

/* The corners of face f in *v; returns their number.  s->first is NULL where all faces are
 * triangles. */
int text_corners(const Soup *s, int f, const int **v);

/* For each format: all of the file.  0, MESH_ENOMEM, MESH_EVALUE or MESH_EFACE. */
int off_write(Text *t, const Soup *s);
int obj_write(Text *t, const Soup *s);
int ply_write(Text *t, const Soup *s);
int stl_write(Text *t, const Soup *s);

#endif
