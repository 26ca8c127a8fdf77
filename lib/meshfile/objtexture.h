/* objtexture.h - texture coordinates of faces across the seam or the fold of a chart.  Private to lib/. */
#ifndef OBJTEXTURE_H
#define OBJTEXTURE_H

#include "../base/sheet.h"
#include "writepriv.h"

/* An image of the (u,v) of a vertex, other than that in the chart. */
typedef struct ObjImage {
	int   vertex, far;      /* far: 1: the sheet is one of (u,T-v), at the fold v = T of a pillow */
	Sheet sheet;
} ObjImage;

/* The images that faces have at their corners: sorted, each once. */
typedef struct ObjTexture {
	size_t    n, cap;
	ObjImage *image;
} ObjTexture;

/* Collects the images for all faces of s that the straight edges of the chart would tear apart; none on
 * a chart that is not folded, or without (u,v).  Returns 0, or MESH_ENOMEM with nothing to free. */
int  objtexture_init(ObjTexture *x, const Soup *s);
void objtexture_free(ObjTexture *x);

/* Appends a vt line for each image, to follow those of the vertices. */
int  objtexture_lines(const ObjTexture *x, Text *t, const Soup *s);

/* Sets vt[k] to the number, counted from 0, of the vt of corner k of face f, which has n corners v. */
enum { OBJTEXTURE_CORNERS = 64 };       /* faces of more corners have no images */
void objtexture_face(const ObjTexture *x, const Soup *s, int n, const int *v, int *vt);

#endif
