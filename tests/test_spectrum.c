/* test_spectrum.c - Fourier coefficients and what dropping them does. */
#include "cmock.h"

#include "../lib/blend.h"
#include "../lib/spectrum.h"
#include "surfaces.h"

enum { NU = 30, NV = 21, N = NU*NV, HALF = (NU/2 + 1)*NV };

static void
random_field(double *f, unsigned long long seed)
{
	int p;

	for (p = 0; p < N; p++)
		f[p] = noise(&seed);
}

static void
inverse_undoes_forward(void **state)
{
	double f[N], g[N];
	double complex C[HALF];

	(void)state;
	random_field(f, 1);
	assert_int_equal(spectrum_forward(NU, NV, f, C), 0);
	assert_int_equal(spectrum_inverse(NU, NV, C, g), 0);
	assert_true(largest(N, f, g) < 1e-14);
}

/* <F f, c> = <f, F^H c>, and the inverse is F^H over nu nv: in the half spectrum, columns
 * that stand for a conjugate pair count twice. */
static void
adjoint(void **state)
{
	double f[N], g[N], h[N], left = 0, right = 0;
	double complex C[HALF], D[HALF];
	int q, p;

	(void)state;
	random_field(f, 2);
	random_field(h, 3);
	spectrum_forward(NU, NV, f, C);
	spectrum_forward(NU, NV, h, D);
	spectrum_inverse(NU, NV, D, g);
	for (q = 0; q < HALF; q++) {
		int m = q%(NU/2 + 1);

		left += (m == 0 || m == NU/2 ? 1 : 2)*creal(C[q]*conj(D[q]));
	}
	for (p = 0; p < N; p++)
		right += f[p]*g[p]*N;
	assert_true(fabs(left - right) < 1e-10*fabs(left));
}

/* cos(2 pi (3 i/nu + 2 j/nv)) has two coefficients of nu nv/2 at (3,2) and (-3,-2). */
static void
wave(double *f, double mean, double amplitude)
{
	int p;

	for (p = 0; p < N; p++)
		f[p] = mean + amplitude*cos(2*M_PI*(3.0*(p%NU)/NU + 2.0*(p/NU)/NV));
}

static void
a_wave_is_two_coefficients(void **state)
{
	double f[N];
	double complex C[HALF];
	int q;

	(void)state;
	wave(f, 5, 2);
	spectrum_forward(NU, NV, f, C);
	for (q = 0; q < HALF; q++)
		assert_true(cabs(C[q] - (q == 0 ? 5*N : q == 2*(NU/2 + 1) + 3 ? N : 0)) < 1e-9);
}

/* |C|/(n rms) of the wave above is 1/sqrt(27): 19.245 percent. */
static void
percent_of_the_root_mean_square(void **state)
{
	double f[N], flat[N];
	size_t kept;
	int p;

	(void)state;
	for (p = 0; p < N; p++)
		flat[p] = 5;
	wave(f, 5, 2);
	spectrum_filter(NU, NV, f, SPECTRUM_PERCENT, 19.24, &kept);
	assert_int_equal(kept, 3);
	wave(f, 5, 2);
	spectrum_filter(NU, NV, f, SPECTRUM_PERCENT, 19.25, &kept);
	assert_int_equal(kept, 1);
	assert_true(largest(N, f, flat) < 1e-13);
	wave(f, 5e6, 2e6);
	spectrum_filter(NU, NV, f, SPECTRUM_PERCENT, 19.24, &kept);
	assert_int_equal(kept, 3);
}

static void
raw_bound_and_count(void **state)
{
	double f[N];
	size_t kept;

	(void)state;
	wave(f, 5, 2);
	spectrum_filter(NU, NV, f, SPECTRUM_RAW, N - 1, &kept);
	assert_int_equal(kept, 3);
	wave(f, 5, 2);
	spectrum_filter(NU, NV, f, SPECTRUM_RAW, N + 1, &kept);
	assert_int_equal(kept, 1);
	random_field(f, 4);
	spectrum_filter(NU, NV, f, SPECTRUM_KEEP, 101, &kept);
	assert_true(kept == 101 || kept == 102);
	spectrum_filter(NU, NV, f, SPECTRUM_KEEP, 1, &kept);
	assert_int_equal(kept, 1);
}

/* Dropping is a projection: a second time changes nothing, and what was dropped is
 * orthogonal to what was kept. */
static void
filter_projects(void **state)
{
	double f[N], g[N], h[N], dot = 0;
	size_t kept, again;
	int p;

	(void)state;
	random_field(f, 5);
	memcpy(g, f, sizeof f);
	spectrum_filter(NU, NV, g, SPECTRUM_KEEP, 200, &kept);
	memcpy(h, g, sizeof g);
	spectrum_filter(NU, NV, h, SPECTRUM_KEEP, kept, &again);
	assert_int_equal(kept, again);
	assert_true(largest(N, g, h) < 1e-13);
	for (p = 0; p < N; p++)
		dot += g[p]*(f[p] - g[p]);
	assert_true(fabs(dot) < 1e-11);
}

static void
bound_zero_keeps_every_bit(void **state)
{
	double f[N], g[N];
	size_t kept;

	(void)state;
	random_field(f, 6);
	memcpy(g, f, sizeof f);
	spectrum_filter(NU, NV, g, SPECTRUM_PERCENT, 0, &kept);
	assert_int_equal(kept, N);
	assert_memory_equal(f, g, sizeof f);
}

static void
blend_meets_its_ends(void **state)
{
	double a[N], b[N], f[N];

	(void)state;
	random_field(a, 7);
	random_field(b, 8);
	blend(N, 0, a, b, f);
	assert_true(largest(N, a, f) == 0);
	blend(N, 1, a, b, f);
	assert_true(largest(N, b, f) == 0);
	blend(N, 0.25, a, b, f);
	assert_true(fabs(f[9] - (0.75*a[9] + 0.25*b[9])) < 1e-15);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(inverse_undoes_forward),
		cmocka_unit_test(adjoint),
		cmocka_unit_test(a_wave_is_two_coefficients),
		cmocka_unit_test(percent_of_the_root_mean_square),
		cmocka_unit_test(raw_bound_and_count),
		cmocka_unit_test(filter_projects),
		cmocka_unit_test(bound_zero_keeps_every_bit),
		cmocka_unit_test(blend_meets_its_ends),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
