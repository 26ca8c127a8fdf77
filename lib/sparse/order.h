/* order.h - a fill-reducing order of the vertices of a triangulated surface.
 *
 * Nested dissection: a separator, a small set of vertices whose removal splits the graph in two,
 * comes last.  Before it come the two parts, each ordered the same way.  A part without a small
 * separator is ordered by minimum degree. */
#ifndef ORDER_H
#define ORDER_H

enum { ORDER_ENOMEM = -1 };

/* A symmetric graph without loops or double edges, connected or not.  The neighbours of vertex i
 * are adj[first[i]] .. adj[first[i+1]-1]. */
typedef struct Graph {
	int  n;
	int *first;             /* [n+1] */
	int *adj;
} Graph;

/* order   out  [n] vertex order[0] is eliminated first
 *
 * Takes memory for at most 14 ints for each edge, and time in proportion to n log n.  The order is
 * the same for any number of threads.  Returns 0 or ORDER_ENOMEM. */
int order_graph(const Graph *g, int *order);

#endif
