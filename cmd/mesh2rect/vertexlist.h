/* vertexlist.h - vertices in the arguments of mesh2rect: by number or by place. */
#ifndef VERTEXLIST_H
#define VERTEXLIST_H

#include "../../lib/mesh/mesh.h"

enum { VERTEXLIST_MOST = 13 };

/* What separates the numbers of a list. */
#define VERTEXLIST_MARKS ",; \t\r\n"

/* Vertex numbers, or points of three numbers. */
typedef struct VertexList {
	int    n;
	double x[VERTEXLIST_MOST];
} VertexList;

/* Reads numbers and nothing else: `count` of them, at most four, or three times as many with a point
 * ending after every third.  Returns 0 for anything else. */
int vertexlist(const char *s, int count, VertexList *g);

/* The vertex of d for x, a vertex number of the file; or dies.  `what` names it, as corner, and `of` says of what
 * it should be a vertex: the boundary, a face. */
int vertexlist_number(const Disk *d, const char *what, const char *of, double x);

#endif
