/* mindegree.c - approximate minimum degree, by CHOLMOD's AMD. */
#include <suitesparse/cholmod.h>

#include "mindegree.h"

/* The pattern of the matrix of g above the diagonal. */
static cholmod_sparse *
pattern(const Graph *g, cholmod_common *c)
{
	cholmod_sparse *a = cholmod_allocate_sparse(g->n, g->n, g->first[g->n]/2, 0, 1, 1, CHOLMOD_PATTERN, c);
	int i, k, n = 0, *first, *row;

	if (!a)
		return NULL;
	first = a->p, row = a->i;
	for (i = 0; i < g->n; i++) {
		first[i] = n;
		for (k = g->first[i]; k < g->first[i+1]; k++)
			if (g->adj[k] < i)
				row[n++] = g->adj[k];
	}
	first[g->n] = n;
	return a;
}

int
mindegree(const Graph *g, int *order)
{
	cholmod_common c;
	cholmod_sparse *a;
	int e = MINDEGREE_ENOMEM;

	cholmod_start(&c);
	c.print = 0;
	a = pattern(g, &c);
	if (a && cholmod_amd(a, NULL, 0, order, &c))
		e = 0;
	cholmod_free_sparse(&a, &c);
	cholmod_finish(&c);
	return e;
}
