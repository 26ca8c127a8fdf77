/* test_order.c - orders of elimination: the same for any number of threads, with little fill. */
#include "cmock.h"

#include <math.h>
#include <omp.h>
#include <suitesparse/cholmod.h>

#include "../lib/map/cotangent.h"
#include "../lib/sparse/vertexcut.h"
#include "synthdisk.h"

static void
check_permutation(const Graph *g, const int *order)
{
	char *seen = calloc(g->n + 1, 1);
	int i;

	for (i = 0; i < g->n; i++) {
		assert_in_range(order[i], 0, g->n - 1);
		assert_false(seen[order[i]]++);
	}
	free(seen);
}

/* The graph of n vertices whose edges are the pairs for which has() is true. */
static Graph
graph_of(int n, int (*has)(int n, int i, int j))
{
	Graph g = { n, calloc(n + 1, sizeof(int)), NULL };
	int i, j, edges = 0, pass;

	for (pass = 0; pass < 2; pass++) {
		for (edges = 0, i = 0; i < n; i++) {
			g.first[i] = edges;
			for (j = 0; j < n; j++)
				if (i != j && has(n, i < j ? i : j, i < j ? j : i)) {
					if (pass)
						g.adj[edges] = j;
					edges++;
				}
		}
		g.first[n] = edges;
		if (!pass)
			g.adj = malloc(edges*sizeof *g.adj + 1);
	}
	return g;
}

static int none(int n, int i, int j) { (void)n, (void)i, (void)j; return 0; }
static int all(int n, int i, int j) { (void)n, (void)i, (void)j; return 1; }
static int path(int n, int i, int j) { (void)n; return j == i + 1; }
static int star(int n, int i, int j) { (void)n, (void)j; return i == 0; }
static int wheel(int n, int i, int j) { return i == 0 || j == i + 1 || (i == 1 && j == n - 1); }
static int pairs(int n, int i, int j) { (void)n; return i%2 == 0 && j == i + 1; }
static int two_paths(int n, int i, int j) { return j == i + 1 && j != n/3; }
static int grid(int n, int i, int j) { int w = (int)sqrt(n); return j == i + w || (j == i + 1 && j%w); }

static void
every_graph_is_ordered(void **state)
{
	static int (*const kind[])(int, int, int) = { none, all, path, star, wheel, pairs, two_paths, grid };
	static const int size[] = { 0, 1, 2, 64, 65, 200, 900 };
	size_t k, s;

	(void)state;
	for (k = 0; k < sizeof kind/sizeof *kind; k++)
		for (s = 0; s < sizeof size/sizeof *size; s++) {
			Graph g = graph_of(size[s], kind[k]);
			int *order = malloc((g.n + 1)*sizeof *order);

			assert_int_equal(order_graph(&g, order), 0);
			check_permutation(&g, order);
			free(order), free(g.first), free(g.adj);
		}
}

/* Number of entries of the factor; AMD's order if order is NULL. */
static double
fill(const Graph *g, const int *order)
{
	cholmod_common c;
	cholmod_triplet *t;
	cholmod_sparse *A;
	cholmod_factor *L;
	int i, k;
	double lnz;

	cholmod_start(&c);
	t = cholmod_allocate_triplet(g->n, g->n, g->first[g->n] + g->n, -1, CHOLMOD_REAL, &c);
	for (i = 0; i < g->n; i++)
		for (k = g->first[i] - 1; k < g->first[i+1]; k++) {
			int j = k < g->first[i] ? i : g->adj[k];

			if (j > i)
				continue;
			((int *)t->i)[t->nnz] = i;
			((int *)t->j)[t->nnz] = j;
			((double *)t->x)[t->nnz++] = 1;
		}
	A = cholmod_triplet_to_sparse(t, 0, &c);
	c.nmethods = 1;
	c.method[0].ordering = order ? CHOLMOD_GIVEN : CHOLMOD_AMD;
	L = cholmod_analyze_p(A, (int *)order, NULL, 0, &c);
	assert_non_null(L);
	lnz = c.lnz;
	cholmod_free_triplet(&t, &c);
	cholmod_free_sparse(&A, &c);
	cholmod_free_factor(&L, &c);
	cholmod_finish(&c);
	return lnz;
}

static void
mesh_graph(const char *kind, int n, Disk *d, Cotangent *C)
{
	Synth s;
	SynthDomain dom;

	synth_disk(kind, n, &s, &dom, d, NULL);
	assert_int_equal(cotangent_init(C, d), 0);
}

/* For a path or a tree, two entries a column are least, as when leaves are eliminated first.  A
 * separator in the middle may cost one more. */
static void
little_fill_on_a_path(void **state)
{
	Graph g = graph_of(900, path);
	int *order = malloc(900*sizeof *order);

	(void)state;
	assert_int_equal(order_graph(&g, order), 0);
	assert_true(fill(&g, order) < 3*900);
	free(order), free(g.first), free(g.adj);
}

/* Nested dissection has less fill than minimum degree on large surfaces, also folded ones; a
 * rolled up strip is long and narrow, which suits minimum degree best. */
static void
less_fill_than_minimum_degree(void **state)
{
	static const char *const kind[] = { "torus", "rectangle", "cortex", "spiral" };
	size_t k;

	(void)state;
	for (k = 0; k < sizeof kind/sizeof *kind; k++) {
		Disk d;
		Cotangent C;
		int *order;

		mesh_graph(kind[k], 40000, &d, &C);
		order = malloc(C.g.n*sizeof *order);
		assert_int_equal(order_graph(&C.g, order), 0);
		check_permutation(&C.g, order);
		assert_true(fill(&C.g, order) < (k < 3 ? 1 : 1.2)*fill(&C.g, NULL));
		free(order);
		cotangent_free(&C);
		disk_free(&d);
	}
}

static void
same_order_for_any_threads(void **state)
{
	int threads = omp_get_max_threads(), t, *one, *more;
	Disk d;
	Cotangent C;

	(void)state;
	mesh_graph("face", 30000, &d, &C);
	one = malloc(C.g.n*sizeof *one);
	more = malloc(C.g.n*sizeof *more);
	omp_set_num_threads(1);
	assert_int_equal(order_graph(&C.g, one), 0);
	for (t = 2; t <= 8; t *= 2) {
		omp_set_num_threads(t);
		assert_int_equal(order_graph(&C.g, more), 0);
		assert_memory_equal(one, more, C.g.n*sizeof *one);
	}
	omp_set_num_threads(threads);
	free(one), free(more);
	cotangent_free(&C);
	disk_free(&d);
}

/* Left and right thirds of a w x w grid, w = 30, with a passage of `gap` rows in the band
 * between: by Menger's theorem the smallest cut has gap vertices, and it must separate. */
static void
cut_is_smallest(void **state)
{
	enum { W = 30, N = W*W };
	Graph g = graph_of(N, grid);
	int *work = malloc(6*N*sizeof *work), i, k, gap, cut;
	signed char side[N];

	(void)state;
	for (gap = 1; gap <= W; gap += 7) {
		for (i = 0; i < N; i++)
			side[i] = i%W < 10 ? CUT_LEFT : i%W >= 20 ? CUT_RIGHT : CUT_SEPARATOR;
		for (i = 0; i < N; i++)         /* a wall: left below the passage, right beyond */
			if (i/W >= gap && side[i] == CUT_SEPARATOR)
				side[i] = i%W < 15 ? CUT_LEFT : CUT_RIGHT;
		for (i = 0; i < N; i++)         /* which leaves a single column of the band in between */
			if (i/W >= gap && i%W == 15)
				side[i] = CUT_SEPARATOR;
		vertexcut(&g, side, work);
		for (cut = 0, i = 0; i < N; i++) {
			cut += side[i] == CUT_SEPARATOR;
			for (k = g.first[i]; side[i] == CUT_LEFT && k < g.first[i+1]; k++)
				assert_int_not_equal(side[g.adj[k]], CUT_RIGHT);
		}
		assert_int_equal(cut, W);
	}
	free(work), free(g.first), free(g.adj);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(every_graph_is_ordered),
		cmocka_unit_test(little_fill_on_a_path),
		cmocka_unit_test(less_fill_than_minimum_degree),
		cmocka_unit_test(same_order_for_any_threads),
		cmocka_unit_test(cut_is_smallest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
