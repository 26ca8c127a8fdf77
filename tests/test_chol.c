/* test_chol.c - chol.h, sparse Cholesky solves: the solution must be the vector from which the
 * right-hand side was computed, and the pivot that fails must be the one of dense elimination. */
#include "cmock.h"

#include <math.h>
#include <omp.h>

#include "../lib/sparse/chol.h"
#include "surfaces.h"

/* A matrix, its graph and its order of elimination. */
typedef struct System {
	Graph   g;
	int    *order;
	double *diagonal, *off;
} System;

static void *
room(size_t n, size_t size)
{
	void *p = calloc(n + 1, size);

	assert_non_null(p);
	return p;
}

/* Gives the off-diagonal entries random values, and sets each diagonal entry to the sum of |a_ij| over
 * its row plus 0.1, so that the matrix is positive definite. */
static void
set_values(System *s, unsigned long long *seed)
{
	int i, k, l;

	s->off = room(s->g.first[s->g.n], sizeof *s->off);
	s->diagonal = room(s->g.n, sizeof *s->diagonal);
	for (i = 0; i < s->g.n; i++)
		for (k = s->g.first[i]; k < s->g.first[i+1]; k++) {
			int j = s->g.adj[k];

			for (l = s->g.first[j]; s->g.adj[l] != i; l++)
				;
			if (j > i)
				s->off[k] = s->off[l] = noise(seed);
		}
	for (i = 0; i < s->g.n; i++)
		for (s->diagonal[i] = 0.1, k = s->g.first[i]; k < s->g.first[i+1]; k++)
			s->diagonal[i] += fabs(s->off[k]);
}

/* A random graph in which each pair of vertices is an edge with probability `chance`, and a random
 * order of elimination. */
static System
random_system(int n, double chance, unsigned long long *seed)
{
	System s = { .g = { .n = n } };
	char *edge = room((size_t)n*n, 1);
	int i, j, m = 0;

	s.g.first = room(n + 1, sizeof *s.g.first);
	s.g.adj = room((size_t)n*n, sizeof *s.g.adj);
	s.order = room(n, sizeof *s.order);
	for (i = 0; i < n; i++)
		for (j = 0; j < i; j++)
			edge[i*n + j] = edge[j*n + i] = fabs(noise(seed)) < chance;
	for (i = 0; i < n; i++) {
		for (j = 0; j < n; j++)
			if (edge[i*n + j])
				s.g.adj[m++] = j;
		s.g.first[i+1] = m;
		j = (int)(fabs(noise(seed))*(i + 1))%(i + 1);
		s.order[i] = s.order[j];
		s.order[j] = i;
	}
	free(edge);
	set_values(&s, seed);
	return s;
}

/* The graph of a triangulated square of n x n vertices, ordered by nested dissection. */
static System
square_system(int n, unsigned long long *seed)
{
	static const int step[6][2] = { { -1, -1 }, { 0, -1 }, { -1, 0 }, { 1, 0 }, { 0, 1 }, { 1, 1 } };
	System s = { .g = { .n = n*n } };
	int i, k, x, y, m = 0;

	s.g.first = room(n*n + 1, sizeof *s.g.first);
	s.g.adj = room(6*(size_t)n*n, sizeof *s.g.adj);
	s.order = room((size_t)n*n, sizeof *s.order);
	for (i = 0; i < n*n; i++) {
		for (k = 0; k < 6; k++) {
			x = i%n + step[k][0], y = i/n + step[k][1];
			if (x >= 0 && x < n && y >= 0 && y < n)
				s.g.adj[m++] = y*n + x;
		}
		s.g.first[i+1] = m;
	}
	assert_int_equal(order_graph(&s.g, s.order), 0);
	set_values(&s, seed);
	return s;
}

static void
drop(System *s)
{
	free(s->g.first), free(s->g.adj), free(s->order), free(s->off), free(s->diagonal);
}

/* y = A x, where the rows and columns of held vertices are replaced by those of the identity. */
static void
multiply(const System *s, const unsigned char *held, const double *x, double *y)
{
	int i, k;

	for (i = 0; i < s->g.n; i++) {
		y[i] = held && held[i] ? x[i] : s->diagonal[i]*x[i];
		for (k = s->g.first[i]; k < s->g.first[i+1]; k++)
			if (!held || (!held[i] && !held[s->g.adj[k]]))
				y[i] += s->off[k]*x[s->g.adj[k]];
	}
}

/* Checks that chol_solve and then chol_again with right-hand sides A x return x, for random x, up to bound. */
static void
check_solution(const System *s, const unsigned char *held, unsigned long long *seed, double bound)
{
	double *x = room(s->g.n, sizeof *x), *y = room(s->g.n, sizeof *y);
	CholMatrix a = { s->diagonal, s->off, held };
	int i, at = -7;
	Chol c;

	for (i = 0; i < s->g.n; i++)
		x[i] = noise(seed);
	multiply(s, held, x, y);
	assert_int_equal(chol_init(&c, &s->g, s->order), 0);
	assert_int_equal(chol_solve(&c, &a, y, &at), 0);
	assert_int_equal(at, -7);
	for (i = 0; i < s->g.n; i++)
		assert_true(fabs(y[i] - x[i]) < bound);
	for (i = 0; i < s->g.n; i++)
		x[i] = noise(seed);
	multiply(s, held, x, y);
	assert_int_equal(chol_again(&c, y), 0);
	for (i = 0; i < s->g.n; i++)
		assert_true(fabs(y[i] - x[i]) < bound);
	chol_free(&c);
	free(x), free(y);
}

/* The solution is right for random graphs, among them empty graphs, single vertices, disconnected
 * graphs and full matrices. */
static void
random_patterns(void **state)
{
	unsigned long long seed = 1;
	System s;
	int n, k;

	(void)state;
	for (n = 0; n < 90; n++)
		for (k = 0; k < 5; k++) {
			s = random_system(n, (double[]){ 0, 0.02, 0.08, 0.3, 1 }[k], &seed);
			check_solution(&s, NULL, &seed, 1e-11);
			drop(&s);
		}
}

static void
held_vertices(void **state)
{
	unsigned long long seed = 2;
	unsigned char held[80];
	System s;
	int n, i;

	(void)state;
	for (n = 1; n < 80; n++) {
		s = random_system(n, 0.1, &seed);
		for (i = 0; i < n; i++)
			held[i] = noise(&seed) < 0;
		check_solution(&s, held, &seed, 1e-11);
		drop(&s);
	}
}

/* The solution is also right if fronts are so large that several tasks factor one of them: a full
 * matrix is a single front, a square mesh has several. */
static void
large_fronts(void **state)
{
	unsigned long long seed = 3;
	System s = random_system(701, 1, &seed);

	(void)state;
	check_solution(&s, NULL, &seed, 1e-10);
	drop(&s);
	s = square_system(260, &seed);
	check_solution(&s, NULL, &seed, 1e-10);
	drop(&s);
}

/* One symbolic analysis serves several matrices, and no solve depends on the matrices before it. */
static void
solved_again(void **state)
{
	unsigned long long seed = 4;
	System s = square_system(40, &seed);
	double *x = room(1600, sizeof *x), *y = room(1600, sizeof *y), *z = room(1600, sizeof *z);
	unsigned char *held = room(1600, 1);
	CholMatrix a = { s.diagonal, s.off, NULL }, b = { s.diagonal, s.off, held };
	int i, at;
	Chol c;

	(void)state;
	for (i = 0; i < 1600; i++) {
		y[i] = z[i] = x[i] = noise(&seed);
		held[i] = i%40 == 0;
	}
	assert_int_equal(chol_init(&c, &s.g, s.order), 0);
	assert_int_equal(chol_solve(&c, &a, x, &at), 0);
	assert_int_equal(chol_solve(&c, &b, y, &at), 0);
	assert_int_equal(chol_solve(&c, &a, z, &at), 0);
	assert_memory_equal(x, z, 1600*sizeof *x);
	assert_true(memcmp(x, y, 1600*sizeof *x) != 0);
	chol_free(&c);
	free(x), free(y), free(z), free(held);
	drop(&s);
}

/* A^-1 is symmetric: <A^-1 x, y> = <x, A^-1 y>. */
static void
inverse_is_its_own_adjoint(void **state)
{
	unsigned long long seed = 5;
	System s = square_system(70, &seed);
	int n = s.g.n, i, at;
	double *x = room(n, sizeof *x), *y = room(n, sizeof *y), left = 0, right = 0;
	double *Ax = room(n, sizeof *x), *Ay = room(n, sizeof *y);
	CholMatrix a = { s.diagonal, s.off, NULL };
	Chol c;

	(void)state;
	for (i = 0; i < n; i++) {
		x[i] = Ax[i] = noise(&seed);
		y[i] = Ay[i] = noise(&seed);
	}
	assert_int_equal(chol_init(&c, &s.g, s.order), 0);
	assert_int_equal(chol_solve(&c, &a, Ax, &at), 0);
	assert_int_equal(chol_solve(&c, &a, Ay, &at), 0);
	for (i = 0; i < n; i++) {
		left += Ax[i]*y[i];
		right += x[i]*Ay[i];
	}
	assert_true(fabs(left - right) < 1e-11*n);
	chol_free(&c);
	free(x), free(y), free(Ax), free(Ay);
	drop(&s);
}

/* Eliminates the matrix in this order as a dense matrix.  Returns the vertex of the first pivot that
 * is not positive, or -1 if all are positive. */
static int
first_to_fail(const System *s, const int *order)
{
	int n = s->g.n, *place = room(n, sizeof *place), i, j, k, bad = -1;
	double *a = room((size_t)n*n, sizeof *a);

	for (i = 0; i < n; i++)
		place[order[i]] = i;
	for (i = 0; i < n; i++) {
		a[place[i]*n + place[i]] = s->diagonal[i];
		for (k = s->g.first[i]; k < s->g.first[i+1]; k++)
			a[place[i]*n + place[s->g.adj[k]]] = s->off[k];
	}
	for (k = 0; k < n && bad < 0; k++) {
		if (!(a[k*n + k] > 0))
			bad = order[k];
		for (i = k + 1; i < n; i++)
			for (j = k + 1; j < n; j++)
				a[i*n + j] -= a[i*n + k]*a[k*n + j]/a[k*n + k];
	}
	free(a), free(place);
	return bad;
}

/* Diagonal entries are made smaller one after the other until the matrix is indefinite: chol_solve
 * must report the same failing vertex as dense elimination. */
static void
indefinite_matrix_is_reported_at_its_pivot(void **state)
{
	unsigned long long seed = 6;
	int n, k, at, expected, found = 0;
	System s;
	Chol c;

	(void)state;
	for (n = 1; n < 60; n++) {
		s = random_system(n, 0.12, &seed);
		assert_int_equal(chol_init(&c, &s.g, s.order), 0);
		for (k = 0; k < n; k++) {
			double *x = room(n, sizeof *x);
			CholMatrix a = { s.diagonal, s.off, NULL };

			s.diagonal[(7*k)%n] *= 0.5*(noise(&seed) + 0.9);
			expected = first_to_fail(&s, c.order);
			at = -1;
			assert_int_equal(chol_solve(&c, &a, x, &at), expected < 0 ? 0 : CHOL_EINDEFINITE);
			assert_int_equal(at, expected);
			found += expected >= 0;
			free(x);
		}
		chol_free(&c);
		drop(&s);
	}
	assert_true(found > 500);
}

static void
nan_is_reported(void **state)
{
	static const double bad[] = { NAN, INFINITY, -INFINITY, 0 };
	unsigned long long seed = 7;
	System s = square_system(60, &seed);
	double *x = room(3600, sizeof *x), keep;
	CholMatrix a = { s.diagonal, s.off, NULL };
	int k, at;
	Chol c;

	(void)state;
	assert_int_equal(chol_init(&c, &s.g, s.order), 0);
	for (k = 0; k < 4; k++) {
		keep = s.diagonal[c.order[0]];
		s.diagonal[c.order[0]] = bad[k];
		at = -1;
		assert_int_equal(chol_solve(&c, &a, x, &at), CHOL_EINDEFINITE);
		assert_int_equal(at, c.order[0]);
		s.diagonal[c.order[0]] = keep;
	}
	chol_free(&c);
	free(x);
	drop(&s);
}

static void
check_threads(const System *s, unsigned long long *seed)
{
	int threads = omp_get_max_threads(), n = s->g.n, t, i, at;
	double *b = room(n, sizeof *b), *x = room(n, sizeof *x), *y = room(n, sizeof *y);
	CholMatrix a = { s->diagonal, s->off, NULL };
	Chol c;

	for (i = 0; i < n; i++)
		b[i] = noise(seed);
	assert_int_equal(chol_init(&c, &s->g, s->order), 0);
	for (t = 1; t <= 8; t *= 2) {
		omp_set_num_threads(t);
		memcpy(y, b, n*sizeof *y);
		assert_int_equal(chol_solve(&c, &a, y, &at), 0);
		if (t == 1)
			memcpy(x, y, n*sizeof *x);
		assert_memory_equal(x, y, n*sizeof *x);
	}
	omp_set_num_threads(threads);
	chol_free(&c);
	free(b), free(x), free(y);
}

static void
same_bits_for_any_threads(void **state)
{
	unsigned long long seed = 8;
	System s = square_system(200, &seed);

	(void)state;
	check_threads(&s, &seed);
	drop(&s);
	s = random_system(500, 0.9, &seed);
	check_threads(&s, &seed);
	drop(&s);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(random_patterns),
		cmocka_unit_test(held_vertices),
		cmocka_unit_test(large_fronts),
		cmocka_unit_test(solved_again),
		cmocka_unit_test(inverse_is_its_own_adjoint),
		cmocka_unit_test(indefinite_matrix_is_reported_at_its_pivot),
		cmocka_unit_test(nan_is_reported),
		cmocka_unit_test(same_bits_for_any_threads),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
