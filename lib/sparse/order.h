/* order.h - a fill-reducing order of the vertices of a triangulated surface.
 *
 * Nested dissection: a few vertices whose removal parts the graph in two go last, the two
 * parts before them, each ordered the same way.
 */
#ifndef ORDER_H
#define ORDER_H

enum { ORDER_ENOMEM = -1 };

/* Neighbours of vertex i: adj[first[i]] .. adj[first[i+1]-1], i not among them; the graph
 * is symmetric, and has no edge twice.  It need not be connected. */
typedef struct Graph {
	int  n;
	int *first;             /* [n+1] */
	int *adj;
} Graph;

/* order   out  [n] vertex order[0] is eliminated first
 *
 * Takes at most 14 numbers of memory per edge, time n log n; the same order for any number
 * of threads.  Returns 0 or ORDER_ENOMEM. */
int order_graph(const Graph *g, int *order);

#endif
