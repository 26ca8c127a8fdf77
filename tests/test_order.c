/* test_order.c - elimination orders of sparse Cholesky factors: they cause little fill and do not
 * depend on the number of threads. */
#include "cmock.h"

#include <math.h>
#include <omp.h>
#include <suitesparse/cholmod.h>

#include "../lib/map/cotangent.h"
#include "../lib/mesh/subdivision.h"
#include "../lib/sparse/etree.h"
#include "../lib/sparse/mindegree.h"
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

/* The graph of n vertices whose edges are the pairs i < j for which has(n, i, j) is true. */
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

/* The number of entries of the Cholesky factor for this order. */
static double
fill(const Graph *g, const int *order)
{
	double entries = 0;
	Etree t;
	int i;

	assert_int_equal(etree_init(&t, g, order), 0);
	for (i = 0; i < g->n; i++)
		entries += t.count[i];
	etree_free(&t);
	return entries;
}

static double
fill_of_minimum_degree(const Graph *g)
{
	int *order = malloc(g->n*sizeof *order);
	double entries;

	assert_int_equal(mindegree(g, order), 0);
	check_permutation(g, order);
	entries = fill(g, order);
	free(order);
	return entries;
}

/* The number of entries for the order of METIS, or INFINITY if CHOLMOD was built without METIS. */
static double
fill_of_metis(const Graph *g)
{
	int *order = malloc(g->n*sizeof *order), i, k, n = 0;
	double entries = INFINITY;
	cholmod_common c;
	cholmod_sparse *a;

	cholmod_start(&c);
	c.print = 0;
	a = cholmod_allocate_sparse(g->n, g->n, g->first[g->n]/2, 0, 1, 1, CHOLMOD_PATTERN, &c);
	for (i = 0; i < g->n; i++) {
		((int *)a->p)[i] = n;
		for (k = g->first[i]; k < g->first[i+1]; k++)
			if (g->adj[k] < i)
				((int *)a->i)[n++] = g->adj[k];
	}
	((int *)a->p)[g->n] = n;
	if (cholmod_metis(a, NULL, 0, 1, order, &c))
		entries = fill(g, order);
	else
		assert_int_equal(c.status, CHOLMOD_NOT_INSTALLED);
	cholmod_free_sparse(&a, &c);
	cholmod_finish(&c);
	free(order);
	return entries;
}

static void
mesh_graph(const char *kind, int n, Disk *d, Cotangent *C)
{
	Synth s;
	SynthDomain dom;

	synth_disk(kind, n, &s, &dom, d, NULL);
	assert_int_equal(cotangent_init(C, d), 0);
}

/* On a path or a tree the smallest factor has two entries in each column; it is reached if leaves are
 * eliminated first.  Nested dissection, which eliminates a separator in the middle last, may give
 * three. */
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

/* On large surfaces, also folded ones, nested dissection causes less fill than minimum degree.  The
 * spiral, a long narrow strip, suits minimum degree best; 1.2 times its fill is allowed there. */
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
		assert_true(fill(&C.g, order) < (k < 3 ? 1 : 1.2)*fill_of_minimum_degree(&C.g));
		free(order);
		cotangent_free(&C);
		disk_free(&d);
	}
}

/* A disk made of the cells (x,y) of a w x h array for which has(x,y) is true; each cell is cut into
 * two triangles. */
static void
disk_of_cells(int w, int h, int (*has)(int x, int y), Disk *d)
{
	Soup s = { 0 };
	int x, y, i;

	s.xyz = calloc(3*(w + 1)*(h + 1), sizeof *s.xyz);
	s.idx = malloc(6*w*h*sizeof *s.idx);
	s.first = malloc((2*w*h + 1)*sizeof *s.first);
	for (y = 0; y <= h; y++)
		for (x = 0; x <= w; x++, s.nv++)
			s.xyz[3*s.nv] = x, s.xyz[3*s.nv+1] = y;
	for (y = 0; y < h; y++)
		for (x = 0; x < w; x++)
			if (has(x, y)) {
				int p = y*(w + 1) + x, q = p + w + 1, c[6] = { p, p + 1, q + 1, p, q + 1, q };

				memcpy(&s.idx[3*s.nf], c, sizeof c);
				s.nf += 2;
			}
	for (i = 0; i <= s.nf; i++)
		s.first[i] = 3*i;
	assert_int_equal(disk_from_soup(d, &s), 0);
	free(s.xyz), free(s.idx), free(s.first);
}

/* n triangles around a central vertex, which lies at this height above the others. */
static void
disk_of_fan(int n, double height, Disk *d)
{
	Soup s = { 0 };
	int i;

	s.nv = n + 1, s.nf = n;
	s.xyz = calloc(3*s.nv, sizeof *s.xyz);
	s.idx = malloc(3*n*sizeof *s.idx);
	s.first = malloc((n + 1)*sizeof *s.first);
	s.xyz[2] = height;
	for (i = 0; i < n; i++) {
		s.xyz[3*(i+1)] = cos(2*M_PI*i/n), s.xyz[3*(i+1)+1] = sin(2*M_PI*i/n);
		s.idx[3*i] = 0, s.idx[3*i+1] = 1 + i, s.idx[3*i+2] = 1 + (i + 1)%n;
	}
	for (i = 0; i <= n; i++)
		s.first[i] = 3*i;
	assert_int_equal(disk_from_soup(d, &s), 0);
	free(s.xyz), free(s.idx), free(s.first);
}

enum { MAZE = 12, CELLS = 2*MAZE - 1 };         /* MAZE x MAZE rooms, with walls between them */

static unsigned char open_cell[CELLS][CELLS];

/* Opens doors between rooms so that rooms and doors form a random tree: the open cells are a
 * disk. */
static void
carve_maze(unsigned seed)
{
	int tree[MAZE*MAZE], wall[2*MAZE*MAZE], n = 0, i, k, a, b;

	memset(open_cell, 0, sizeof open_cell);
	for (i = 0; i < MAZE*MAZE; i++) {
		tree[i] = i;
		open_cell[i/MAZE*2][i%MAZE*2] = 1;
		wall[n++] = 2*i, wall[n++] = 2*i + 1;
	}
	for (i = n - 1; i > 0; i--) {
		seed = 1664525*seed + 1013904223;
		k = (seed >> 8)%(i + 1);
		a = wall[i], wall[i] = wall[k], wall[k] = a;
	}
	for (k = 0; k < n; k++) {
		a = wall[k]/2, b = wall[k]%2 ? a + MAZE : a + 1;
		if (b >= MAZE*MAZE || (wall[k]%2 == 0 && a%MAZE == MAZE - 1) || tree[a] == tree[b])
			continue;
		open_cell[a/MAZE + b/MAZE][a%MAZE + b%MAZE] = 1;
		for (b = tree[b], i = 0; i < MAZE*MAZE; i++)
			if (tree[i] == b)
				tree[i] = tree[a];
	}
}

/* Opens a spiral way from a corner to the middle. */
static void
carve_spiral(void)
{
	int x = 0, y = 0, dx = 1, dy = 0, length = CELLS - 1, side, i;

	memset(open_cell, 0, sizeof open_cell);
	open_cell[0][0] = 1;
	for (side = 0; length > 1; side++) {
		for (i = 0; i < length; i++)
			x += dx, y += dy, open_cell[y][x] = 1;
		if (side >= 2 && side%2 == 0)
			length -= 2;
		i = dx, dx = -dy, dy = i;
	}
}

static int is_open(int x, int y) { return open_cell[y][x]; }
static int strip(int x, int y) { (void)x, (void)y; return 1; }
static int comb(int x, int y) { return y == 0 || x%2 == 0; }

/* Splits triangles repeatedly until there are about n vertices.  Each time it splits all triangles
 * or, if not `everywhere`, a random quarter of them and all at vertices of more than 40 triangles. */
static void
split_to(int n, int everywhere, Subdivision *s)
{
	unsigned seed = 1;

	while (s->d.m.nv < n/(everywhere ? 2 : 1.3)) {
		const Mesh *m = &s->d.m;
		unsigned char *marked = malloc(m->nf);
		int *degree = calloc(m->nv, sizeof *degree), t, k;

		for (t = 0; t < 3*m->nf; t++)
			degree[m->tri[t]]++;
		for (t = 0; t < m->nf; t++) {
			seed = 1664525*seed + 1013904223;
			marked[t] = seed >> 30 == 0;
			for (k = 0; k < 3; k++)
				marked[t] |= degree[m->tri[3*t+k]] > 40;
		}
		assert_int_equal(subdivision_refine(s, everywhere ? NULL : marked, NULL, NULL), 0);
		free(marked), free(degree);
	}
}

/* Checks that the factor has less than 1.5 times as many entries as with the best method of
 * CHOLMOD. */
static void
check_fill(const char *name, const Graph *g)
{
	int *order = malloc(g->n*sizeof *order);
	double entries, least;

	assert_int_equal(order_graph(g, order), 0);
	check_permutation(g, order);
	entries = fill(g, order);
	least = fmin(fill_of_minimum_degree(g), fill_of_metis(g));
	if (!(entries < 1.5*least))
		fail_msg("%s, %d vertices: %.0f entries, %.0f are possible", name, g->n, entries, least);
	free(order);
}

/* Splits d in both ways of split_to and checks the fill.  Frees d. */
static void
check_split(const char *name, Disk *d)
{
	int everywhere;

	for (everywhere = 0; everywhere < 2; everywhere++) {
		Subdivision s;
		Cotangent C;

		assert_int_equal(subdivision_init(&s, d), 0);
		split_to(50000, everywhere, &s);
		assert_int_equal(cotangent_graph(&C, &s.d), 0);
		check_fill(name, &C.g);
		cotangent_free(&C);
		subdivision_free(&s);
	}
	disk_free(d);
}

static void
little_fill_on_split_meshes(void **state)
{
	static const char *const kind[] = { "torus", "face", "spiral" };
	unsigned k;
	Disk d;

	(void)state;
	for (k = 0; k < sizeof kind/sizeof *kind; k++) {
		Synth s;
		SynthDomain dom;

		synth_disk(kind[k], 1000, &s, &dom, &d, NULL);
		check_split(kind[k], &d);
	}
	disk_of_fan(500, 0, &d);
	check_split("fan", &d);
	disk_of_fan(100, 30, &d);
	check_split("spike", &d);
	disk_of_cells(31, 12, comb, &d);
	check_split("comb", &d);
	disk_of_cells(1000, 1, strip, &d);
	check_split("strip", &d);
	carve_spiral();
	disk_of_cells(CELLS, CELLS, is_open, &d);
	check_split("square spiral", &d);
	for (k = 0; k < 4; k++) {
		carve_maze(k);
		disk_of_cells(CELLS, CELLS, is_open, &d);
		check_split("maze", &d);
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

/* vertexcut must find a smallest separator between the left and the right third of a W x W grid.  In
 * the first `gap` rows the separator may lie anywhere in the middle third; by Menger's theorem it
 * needs one vertex in each row.  In the other rows it is fixed to one column.  So the smallest
 * separator has W vertices. */
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
		for (i = 0; i < N; i++)         /* in the other rows the two sides meet, */
			if (i/W >= gap && side[i] == CUT_SEPARATOR)
				side[i] = i%W < 15 ? CUT_LEFT : CUT_RIGHT;
		for (i = 0; i < N; i++)         /* with one column that separates them */
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
		cmocka_unit_test(little_fill_on_split_meshes),
		cmocka_unit_test(same_order_for_any_threads),
		cmocka_unit_test(cut_is_smallest),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
