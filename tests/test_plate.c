/* test_plate.c - transform.h: transforms equal their defining sums; plate.h: plate_solve inverts the
 * operator P. */
#include "cmock.h"

#include <omp.h>

#include "../lib/base/field.h"
#include "../lib/grid/stencil.h"
#include "../lib/poisson/plate.h"
#include "surfaces.h"

typedef void Kernel(const Transform *t, double *f, double *work);

/* Checks a transform of n numbers, on N intervals, against the sum that defines it. */
static void
check_transform(Kernel *transform, int N, int n, double (*term)(int j, int k, int N))
{
	double f[60], F[60], *work, sum;
	unsigned long long seed = 1;
	Transform t;
	int j, k;

	assert_int_equal(transform_init(&t, N), 0);
	work = fftw_alloc_real(transform_room(&t));
	for (j = 0; j < n; j++)
		F[j] = f[j] = noise(&seed);
	transform(&t, F, work);
	for (k = 0; k < n; k++) {
		for (sum = 0, j = 0; j < n; j++)
			sum += f[j]*term(j, k, N);
		assert_true(fabs(F[k] - sum) < 1e-12);
	}
	fftw_free(work);
	transform_free(&t);
}

/* A pair of lines is transformed as one after the other. */
static void
pairs_are_two_transforms(void **state)
{
	static const int steps[] = { 2, 3, 4, 5, 8, 13, 32, 59 };
	double f[2][60], pair[2][60], *one, *work;
	unsigned long long seed = 1;
	Transform t;
	int q, l, cosine;

	(void)state;
	for (q = 0; q < 16; q++) {
		assert_int_equal(transform_init(&t, steps[q/2]), 0);
		assert_int_equal(transform_init_pair(&t), 0);
		one = fftw_alloc_real(transform_room(&t));
		work = fftw_alloc_real(transform_pair_room(&t));
		cosine = q%2;
		for (l = 0; l < 120; l++)
			f[l/60][l%60] = pair[l/60][l%60] = noise(&seed);
		for (l = 0; l < 2; l++)
			(cosine ? transform_cosine : transform_sine)(&t, f[l], one);
		(cosine ? transform_cosine_pair : transform_sine_pair)(&t, pair[0], pair[1], work);
		assert_true(largest(120, f[0], pair[0]) < 1e-12);
		fftw_free(one);
		fftw_free(work);
		transform_free(&t);
	}
}

static double
sine_term(int j, int k, int N)
{
	return sin(M_PI*(j + 1)*(k + 1)/N);
}

static double
cosine_term(int j, int k, int N)
{
	return (j == 0 || j == N ? 0.5 : 1)*cos(M_PI*j*k/N);
}

static void
transforms_are_sums(void **state)
{
	static const int steps[] = { 1, 2, 3, 4, 5, 7, 8, 12, 13, 31, 32, 59 };
	size_t q;

	(void)state;
	for (q = 0; q < sizeof steps/sizeof *steps; q++) {
		check_transform(transform_cosine, steps[q], steps[q] + 1, cosine_term);
		if (steps[q] > 1)
			check_transform(transform_sine, steps[q], steps[q] - 1, sine_term);
	}
}

/* 42 = 2 3 7, 26 = 2 13, 286 = 2 11 13 and 242 = 2 11 11; 451 = 11 41, 449 and 453 = 3 151. */
static void
fast_sizes_have_small_factors(void **state)
{
	(void)state;
	assert_int_equal(transform_fast_size(1, 2), 1);
	assert_int_equal(transform_fast_size(42, 2), 42);
	assert_int_equal(transform_fast_size(26, 2), 26);
	assert_int_equal(transform_fast_size(242, 2), 240);
	assert_int_equal(transform_fast_size(286, 2), 288);
	assert_int_equal(transform_fast_size(451, 2), 455);
	assert_int_equal(transform_fast_size(17, 1), 18);
}

/* y = -Delta x on the inner nodes; x must be 0 on the border. */
static void
minus_laplacian(Chart g, const double *x, double *y)
{
	double h2 = chart_h(g)*chart_h(g), k2 = chart_k(g)*chart_k(g);
	int i, j, p;

	for (j = 1; j < g.nv - 1; j++)
		for (i = 1; i < g.nu - 1; i++) {
			p = j*g.nu + i;
			y[p] = (2*x[p] - x[p-1] - x[p+1])/h2 + (2*x[p] - x[p-g.nu] - x[p+g.nu])/k2;
		}
}

static void
plate_inverts(void **state)
{
	static const Chart charts[] = { { 18, 13, 0.7, &CHART_RECTANGLE }, { 13, 18, 1.6, &CHART_RECTANGLE }, { 3, 3, 1, &CHART_RECTANGLE }, { 4, 3, 2, &CHART_RECTANGLE }, { 3, 30, 2, &CHART_RECTANGLE } };
	double x[3*234], z[3*234], y[234], yy[234];
	unsigned long long seed = 7;
	int q, c, i, j, p, n;
	Plate plate;

	(void)state;
	for (q = 0; q < 5; q++) {
		Chart g = charts[q];

		n = g.nu*g.nv;
		memset(x, 0, sizeof x);
		for (c = 0; c < 3; c++)
			for (j = 1; j < g.nv - 1; j++)
				for (i = 1; i < g.nu - 1; i++)
					x[c*n + j*g.nu + i] = noise(&seed);
		memcpy(z, x, sizeof x);
		assert_int_equal(plate_init(&plate, g, 0), 0);
		plate_solve(&plate, 0.3, 50, 0, z);
		for (c = 0; c < 3; c++) {
			memset(y, 0, sizeof y);
			memset(yy, 0, sizeof yy);
			minus_laplacian(g, z + c*n, y);
			minus_laplacian(g, y, yy);
			for (p = 0; p < n; p++)
				assert_true(fabs(0.3*yy[p] + 50*y[p] - x[c*n+p]) < 1e-9);
		}
		plate_free(&plate);
	}
}

static int
mirrored(int i, int n)
{
	return i < 0 ? -i : i >= n ? 2*(n - 1) - i : i;
}

/* y = -Delta x on all nodes; beyond the border x is continued by reflection. */
static void
minus_laplacian_mirrored(Chart g, const double *x, double *y)
{
	double h2 = chart_h(g)*chart_h(g), k2 = chart_k(g)*chart_k(g);
	int i, j, p;

	for (p = j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++, p++)
			y[p] = (2*x[p] - x[j*g.nu + mirrored(i-1, g.nu)] - x[j*g.nu + mirrored(i+1, g.nu)])/h2
			    + (2*x[p] - x[mirrored(j-1, g.nv)*g.nu + i] - x[mirrored(j+1, g.nv)*g.nu + i])/k2;
}

static void
free_plate_inverts(void **state)
{
	static const Chart charts[] = { { 18, 13, 0.7, &CHART_RECTANGLE }, { 13, 18, 1.6, &CHART_RECTANGLE }, { 3, 3, 1, &CHART_RECTANGLE }, { 4, 3, 2, &CHART_RECTANGLE }, { 3, 30, 2, &CHART_RECTANGLE } };
	double x[3*234], z[3*234], y[234], yy[234], least, weight;
	unsigned long long seed = 7;
	int q, c, i, j, p, n;
	Plate plate;

	(void)state;
	for (q = 0; q < 5; q++) {
		Chart g = charts[q];

		n = g.nu*g.nv;
		least = fmin((2 - 2*cos(M_PI/(g.nu - 1)))/(chart_h(g)*chart_h(g)),
		    (2 - 2*cos(M_PI/(g.nv - 1)))/(chart_k(g)*chart_k(g)));
		for (p = 0; p < 3*n; p++)
			z[p] = x[p] = noise(&seed);
		assert_int_equal(plate_init(&plate, g, 1), 0);
		plate_solve(&plate, 0.3, 50, 0, z);
		for (c = 0; c < 3; c++) {
			minus_laplacian_mirrored(g, z + c*n, y);
			minus_laplacian_mirrored(g, y, yy);
			for (p = 0; p < n; p++) {
				i = p%g.nu, j = p/g.nu;
				weight = (i == 0 || i == g.nu - 1 ? 0.5 : 1)*(j == 0 || j == g.nv - 1 ? 0.5 : 1);
				assert_true(fabs(weight*(0.3*yy[p] + 50*y[p] + 50*least*z[c*n+p]) - x[c*n+p]) < 1e-9);
			}
		}
		plate_free(&plate);
	}
}

/* y = -Delta x on the sock g; beyond the boundary x is continued by reflection (free), or y is 0 there. */
static void
minus_laplacian_sock(Chart g, int free, const double *x, double *y)
{
	double h2 = chart_h(g)*chart_h(g), k2 = chart_k(g)*chart_k(g);
	int i, j, p, sign = 1;

	for (p = j = 0; j < g.nv; j++)
		for (i = 0; i < g.nu; i++, p++) {
			if (j == g.nv - 1 && !free) {
				y[p] = 0;
				continue;
			}
			y[p] = (2*x[p] - x[stencil_node(g, i-1, j, &sign)] - x[stencil_node(g, i+1, j, &sign)])/h2
			    + (2*x[p] - x[stencil_node(g, i, j-1, &sign)] - x[mirrored(j+1, g.nv)*g.nu + i])/k2;
		}
}

static void
plate_inverts_on_the_sock(void **state)
{
	static const Chart charts[] = { { 18, 13, 0.7, &CHART_SOCK }, { 12, 19, 1.6, &CHART_SOCK },
		{ 4, 3, 1, &CHART_SOCK }, { 26, 4, .1, &CHART_SOCK } };
	double x[3*234], z[3*234], y[234], yy[234], least, weight;
	unsigned long long seed = 7;
	int q, c, p, n, free, last;
	Plate plate;

	(void)state;
	for (q = 0; q < 8; q++) {
		Chart g = charts[q/2];

		free = q%2;
		n = g.nu*g.nv;
		least = fmin((2 - 2*cos(2*M_PI/g.nu))/(chart_h(g)*chart_h(g)),
		    (2 - 2*cos(2*M_PI/(2*g.nv - 1)))/(chart_k(g)*chart_k(g)));
		for (p = 0; p < 3*n; p++)
			z[p] = x[p] = !free && p%n >= n - g.nu ? 0 : noise(&seed);
		assert_int_equal(plate_init(&plate, g, free), 0);
		plate_solve(&plate, 0.3, 50, 0, z);
		for (c = 0; c < 3; c++) {
			minus_laplacian_sock(g, free, z + c*n, y);
			minus_laplacian_sock(g, free, y, yy);
			for (p = 0; p < n; p++) {
				last = p >= n - g.nu;
				weight = last ? 0.5 : 1;
				if (!free && last)
					assert_true(z[c*n+p] == 0);
				else
					assert_true(fabs((free ? weight : 1)*(0.3*yy[p] + 50*y[p] +
					    (free ? 50*least*z[c*n+p] : 0)) - x[c*n+p]) < 1e-8);
			}
		}
		plate_free(&plate);
	}
}

static void
threads_change_no_bit(void **state)
{
	static double x[3*70*50], one[3*70*50], three[3*70*50];
	Chart g = { 70, 50, 0.7, &CHART_RECTANGLE };
	unsigned long long seed = 7;
	double dot[2];
	int threads = omp_get_max_threads(), p;
	Plate plate;

	(void)state;
	for (p = 0; p < 3*70*50; p++)
		x[p] = p%70 && p%70 < 69 && p/70%50 && p/70%50 < 49 ? noise(&seed) : 0;
	memcpy(one, x, sizeof x);
	memcpy(three, x, sizeof x);
	omp_set_num_threads(1);
	assert_int_equal(plate_init(&plate, g, 0), 0);
	plate_solve(&plate, 1, 1, 0, one);
	dot[0] = field_dot(3*70*50, x, one);
	plate_free(&plate);
	omp_set_num_threads(3);
	assert_int_equal(plate_init(&plate, g, 0), 0);
	plate_solve(&plate, 1, 1, 0, three);
	dot[1] = field_dot(3*70*50, x, three);
	plate_free(&plate);
	omp_set_num_threads(threads);
	assert_memory_equal(one, three, sizeof one);
	assert_memory_equal(&dot[0], &dot[1], sizeof dot[0]);
}

static void
plate_inverts_on_the_pillow(void **state)
{
	static const Chart charts[] = { { 18, 13, 0.7, &CHART_PILLOW }, { 12, 19, 1.6, &CHART_PILLOW },
		{ 4, 3, 1, &CHART_PILLOW }, { 26, 4, .1, &CHART_PILLOW }, { 6, 16, 3, &CHART_PILLOW } };
	double x[3*234], z[3*234], least, y[234], yy[234], h2, k2;
	unsigned long long seed = 7;
	int q, c, p, n, twice, sign = 1;
	Plate plate;

	(void)state;
	for (q = 0; q < 5; q++) {
		Chart g = charts[q];

		n = g.nu*g.nv;
		h2 = chart_h(g)*chart_h(g), k2 = chart_k(g)*chart_k(g);
		least = fmin((2 - 2*cos(2*M_PI/g.nu))/h2, (2 - 2*cos(M_PI/g.nv))/k2);
		for (p = 0; p < 3*n; p++)
			z[p] = x[p] = noise(&seed);
		assert_int_equal(plate_init(&plate, g, 0), 0);
		plate_solve(&plate, 0.3, 50, 0, z);
		for (c = 0; c < 3; c++) {
			for (twice = 0; twice < 2; twice++) {
				const double *from = twice ? y : z + c*n;
				double *to = twice ? yy : y;

				for (p = 0; p < n; p++) {
					int i = p%g.nu, j = p/g.nu;

					to[p] = (2*from[p] - from[stencil_node(g, i-1, j, &sign)] -
					    from[stencil_node(g, i+1, j, &sign)])/h2 + (2*from[p] -
					    from[stencil_node(g, i, j-1, &sign)] - from[stencil_node(g, i, j+1, &sign)])/k2;
				}
			}
			for (p = 0; p < n; p++)
				assert_true(fabs(0.3*yy[p] + 50*y[p] + 50*least*z[c*n+p] - x[c*n+p]) < 1e-8);
		}
		plate_free(&plate);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(transforms_are_sums),
		cmocka_unit_test(pairs_are_two_transforms),
		cmocka_unit_test(fast_sizes_have_small_factors),
		cmocka_unit_test(plate_inverts),
		cmocka_unit_test(free_plate_inverts),
		cmocka_unit_test(plate_inverts_on_the_pillow),
		cmocka_unit_test(plate_inverts_on_the_sock),
		cmocka_unit_test(threads_change_no_bit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
