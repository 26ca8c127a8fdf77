/* test_spectrum.c - spectrum.h: Fourier coefficients; filter.h: filters that drop some of them. */
#include "cmock.h"

#include "../lib/scales/borderpart.h"
#include "../lib/scales/filter.h"
#include "surfaces.h"

enum { NU = 30, NV = 21, N = NU*NV };

static const Spectrum DCT = { SPECTRUM_DCT, { NU, NV, 0.7, &CHART_RECTANGLE } },
	DFT = { SPECTRUM_DFT, { NU, NV, 0.7, &CHART_RECTANGLE } },
	FOLD = { SPECTRUM_DCT, { NU, NV, 0.7, &CHART_SOCK } },
	CLOSED = { SPECTRUM_DCT, { NU, NV, 0.7, &CHART_PILLOW } };

static Spectrum
basis(int b)
{
	return b == 0 ? DCT : b == 1 ? DFT : b == 2 ? FOLD : CLOSED;
}

static void
random_field(double *f, unsigned long long seed)
{
	int p;

	for (p = 0; p < N; p++)
		f[p] = noise(&seed);
}

static void
filter(Spectrum s, FilterRule rule, double bound, int log, double *f, size_t *kept)
{
	assert_true(filter_field(s, &(Filter){ rule, bound, log }, f, kept) >= 0);
}

static void
inverse_undoes_forward(void **state)
{
	double f[N], g[N];
	double complex C[N];
	int b;

	(void)state;
	for (b = 0; b < 4; b++) {
		random_field(f, 1);
		assert_int_equal(spectrum_forward(basis(b), f, C), 0);
		assert_int_equal(spectrum_inverse(basis(b), C, g), 0);
		assert_true(largest(N, f, g) < 1e-14);
	}
}

/* Parseval: <F f, F h> = N <f, h>, where a coefficient that stands for a conjugate pair counts twice.
 * In the last column of the dft each coefficient counts once if nu is even, twice if nu is odd.  C_00
 * is the sum of f. */
static void
parseval(void **state)
{
	double f[N], h[N], left, right, sum;
	double complex C[N], D[N];
	int i, q, p, cols;

	(void)state;
	for (i = 0; i < 6; i++) {
		Spectrum s = { i%2 ? SPECTRUM_DFT : SPECTRUM_DCT, { i < 2 ? NU : NV, i < 2 ? NV : NU, 1,
			&CHART_RECTANGLE } };

		if (i >= 4)
			s = i == 4 ? FOLD : CLOSED;

		random_field(f, 2);
		random_field(h, 3);
		spectrum_forward(s, f, C);
		spectrum_forward(s, h, D);
		cols = spectrum_columns(s);
		for (left = q = 0; q < (int)spectrum_size(s); q++)
			left += spectrum_weight(s, q%cols)*creal(C[q]*conj(D[q]));
		for (right = sum = p = 0; p < N; p++) {
			right += f[p]*h[p]*N;
			sum += f[p];
		}
		assert_true(fabs(left - right) < 1e-10*fabs(left));
		assert_true(cabs(C[0] - sum) < 1e-11);
	}
}

/* A constant plus a wave of the basis of s, with frequency 3 in i and 2 in j.  The wave has the dft
 * coefficients nu nv amplitude/2 at (3,2) and (-3,-2), or the dct coefficient nu nv amplitude/2 at
 * (3,2). */
static void
wave(Spectrum s, double mean, double amplitude, double *f)
{
	int p;

	for (p = 0; p < N; p++) {
		int i = p%NU, j = p/NU;

		f[p] = mean + amplitude*(s.basis == SPECTRUM_DFT ? cos(2*M_PI*(3.0*i/NU + 2.0*j/NV))
			: cos(3*M_PI*(i + 0.5)/NU)*cos(2*M_PI*(j + 0.5)/NV));
	}
}

static void
a_wave_is_one_coefficient_or_a_pair(void **state)
{
	double f[N];
	double complex C[N];
	int b, q, cols;

	(void)state;
	for (b = 0; b < 2; b++) {
		Spectrum s = b ? DFT : DCT;

		wave(s, 5, 2, f);
		spectrum_forward(s, f, C);
		cols = spectrum_columns(s);
		for (q = 0; q < cols*NV; q++)
			assert_true(cabs(C[q] - (q == 0 ? 5*N : q == 2*cols + 3 ? N : 0)) < 1e-9);
	}
}

/* Checks that `rule` keeps the wave if the bound is just below `at`, and drops it if the bound is
 * just above. */
static void
straddle(Spectrum s, FilterRule rule, double at, double mean, double amplitude)
{
	double f[N], g[N], flat[N];
	size_t kept, both = s.basis == SPECTRUM_DFT ? 3 : 2;
	int p;

	wave(s, mean, amplitude, f);
	for (p = 0; p < N; p++)
		flat[p] = mean;
	memcpy(g, f, sizeof g);
	filter(s, rule, 0.9999*at, 0, g, &kept);
	assert_int_equal(kept, both);
	assert_true(largest(N, g, f) < 1e-12*flat[0]);
	filter(s, rule, 1.0001*at, 0, f, &kept);
	assert_int_equal(kept, 1);
	assert_true(largest(N, f, flat) < 1e-12*flat[0]);
}

/* FILTER_PERCENT compares 100 |C|/(n rms) with the bound.  For 5 + 2 wave, |C|/(n rms) is 1/sqrt(27)
 * in the dft, whose wave has mean square 1/2, and 1/sqrt(26) in the dct, whose wave has mean square
 * 1/4. */
static void
percent_of_the_root_mean_square(void **state)
{
	(void)state;
	straddle(DFT, FILTER_PERCENT, 100/sqrt(27), 5, 2);
	straddle(DCT, FILTER_PERCENT, 100/sqrt(26), 5, 2);
	straddle(DFT, FILTER_PERCENT, 100/sqrt(27), 5e6, 2e6);
}

static void
raw_bound(void **state)
{
	(void)state;
	straddle(DFT, FILTER_RAW, N, 5, 2);
	straddle(DCT, FILTER_RAW, N, 5, 2);
}

static void
keep_counts(void **state)
{
	double f[N];
	size_t kept;

	(void)state;
	random_field(f, 4);
	filter(DFT, FILTER_KEEP, 101, 0, f, &kept);
	assert_true(kept == 101 || kept == 102);
	filter(DFT, FILTER_KEEP, 1, 0, f, &kept);
	assert_int_equal(kept, 1);
	random_field(f, 4);
	filter(DCT, FILTER_KEEP, 101, 0, f, &kept);
	assert_int_equal(kept, 101);
	filter(DCT, FILTER_KEEP, 1, 0, f, &kept);
	assert_int_equal(kept, 1);
}

static double
variance(const double *f, const double *from)
{
	double mean = 0, sum = 0;
	int p;

	for (p = 0; p < N; p++)
		mean += (f[p] - (from ? from[p] : 0))/N;
	for (p = 0; p < N; p++)
		sum += pow(f[p] - (from ? from[p] : 0) - mean, 2)/N;
	return sum;
}

/* FILTER_ENERGY keeps the fewest coefficients that hold the given share of the energy: with one fewer
 * (in the dft, one conjugate pair fewer) they do not hold it. */
static void
energy_holds_the_share(void **state)
{
	double f[N], g[N], h[N];
	size_t kept, fewer;
	int b, p;

	(void)state;
	for (b = 0; b < 2; b++) {
		Spectrum s = b ? DFT : DCT;

		random_field(f, 10);
		for (p = 0; p < N; p++)
			f[p] += 7;
		memcpy(g, f, sizeof f);
		memcpy(h, f, sizeof f);
		filter(s, FILTER_ENERGY, 0.6, 0, g, &kept);
		assert_in_range(kept, N/20, N/2);
		assert_true(variance(g, NULL) >= 0.6*variance(f, NULL));
		assert_true(variance(f, g) <= 0.4*variance(f, NULL));
		filter(s, FILTER_KEEP, kept - (b ? 2 : 1), 0, h, &fewer);
		assert_true(variance(h, NULL) < 0.6*variance(f, NULL));
		for (p = 0; p < N; p++)         /* now most coefficients are below rounding */
			f[p] += 1e10*cos(2*M_PI*(p%NU + 0.5)/NU);
		filter(s, FILTER_ENERGY, 1, 0, f, &kept);
		assert_int_equal(kept, N);
		filter(s, FILTER_ENERGY, 0, 0, f, &kept);
		assert_int_equal(kept, 1);
	}
}

/* The low pass separates two cosines if its bound R is between their wave numbers in (u,v).  The
 * cosines fit the periods of the transform, nu h and nv k, which are one cell longer than the
 * sides of the chart. */
static void
low_pass_separates_waves(void **state)
{
	const double h = 1.0/(NU - 1), k = 0.7/(NV - 1), a = 3/(NU*h), b = 2/(NV*k);
	double f[N], low[N], slow, fast;
	size_t kept;
	int i, dft, p;

	(void)state;
	for (i = 0; i < 4; i++) {
		dft = i%2;
		for (p = 0; p < N; p++) {       /* low has the wave number slow; f also has fast */
			double u = (p%NU + 0.5)*h, v = (p/NU + 0.5)*k, w = dft ? 2*M_PI : M_PI;

			low[p] = 4 + cos(w*a*u);
			f[p] = low[p] + (i < 2 ? cos(w*a*u)*cos(w*b*v) : cos(w*1.5*b*v));
		}
		slow = a/(dft ? 1 : 2);
		fast = (i < 2 ? hypot(a, b) : 1.5*b)/(dft ? 1 : 2);
		filter(dft ? DFT : DCT, FILTER_LOWPASS, 1.0001*fast, 0, f, &kept);
		assert_true(largest(N, f, low) > 0.9);
		filter(dft ? DFT : DCT, FILTER_LOWPASS, 0.9999*fast, 0, f, &kept);
		assert_true(largest(N, f, low) < 1e-13);
		filter(dft ? DFT : DCT, FILTER_LOWPASS, 1.0001*slow, 0, f, &kept);
		assert_true(largest(N, f, low) < 1e-13);
		filter(dft ? DFT : DCT, FILTER_LOWPASS, 0.9999*slow, 0, f, &kept);
		assert_true(largest(N, f, low) > 0.9);
	}
}

/* Filtering with logarithms keeps the same waves whether a field of lengths is in metres or in
 * millimetres. */
static void
log_is_free_of_the_unit(void **state)
{
	double f[N], g[N];
	size_t kept, again;
	int b, p;

	(void)state;
	for (b = 0; b < 2; b++) {
		random_field(f, 9);
		for (p = 0; p < N; p++) {
			f[p] = exp(f[p]);
			g[p] = 1000*f[p];
		}
		filter(b ? DFT : DCT, FILTER_PERCENT, 3, 1, f, &kept);
		filter(b ? DFT : DCT, FILTER_PERCENT, 3, 1, g, &again);
		assert_int_equal(kept, again);
		assert_in_range(kept, N/10, 9*N/10);
		for (p = 0; p < N; p++) {
			assert_true(f[p] > 0);
			g[p] /= 1000;
		}
		assert_true(largest(N, f, g) < 1e-13);
	}
}

/* On the sock each wave that is the same on both sheets is one coefficient, at its numbers and with its
 * wave number. */
static void
a_wave_of_the_sock_is_one_coefficient(void **state)
{
	static const int number[][2] = { { 0, 0 }, { 3, 2 }, { 3, 5 }, { 0, 4 }, { NU/2, 1 }, { 7, 2*NV - 1 } };
	double f[N], h = chart_h(FOLD.g), k = chart_k(FOLD.g), x, y, square;
	double complex C[N];
	int t, p, q, m, n, found;

	(void)state;
	for (t = 0; t < 6; t++) {
		for (square = p = 0; p < N; p++) {
			x = 2*M_PI*number[t][0]*(p%NU + .5)*h;
			y = M_PI*number[t][1]*(p/NU + NV + .5)/(2*NV);
			f[p] = (number[t][1]%2 ? sin(x) : cos(x))*cos(y);
			square += f[p]*f[p];
		}
		spectrum_forward(FOLD, f, C);
		for (found = q = 0; q < N; q++) {
			spectrum_numbers(FOLD, q, &m, &n);
			if (m == number[t][0] && n == number[t][1]) {
				assert_true(fabs(creal(C[q]) - sqrt(square*N)) < 1e-9);
				assert_true(fabs(spectrum_wave(FOLD, q) - hypot(m, n/(4*NV*k))) < 1e-12);
				found++;
			} else
				assert_true(cabs(C[q]) < 1e-9);
		}
		assert_int_equal(found, 1);
	}
	assert_false(spectrum_exists((Spectrum){ SPECTRUM_DFT, FOLD.g }));
}

/* On the pillow each product of cosines and each of sines. */
static void
a_wave_of_the_pillow_is_one_coefficient(void **state)
{
	static const int number[][3] = { { 0, 0, 0 }, { 3, 2, 0 }, { 3, 2, 1 }, { 0, 4, 0 }, { NU/2, 1, 1 }, { 7, NV, 1 },
		{ NU/2, NV, 1 }, { 7, 0, 0 } };
	double f[N], x, y, square;
	double complex C[N];
	int t, p, q, m, n, sine, found;

	(void)state;
	for (t = 0; t < 8; t++) {
		for (square = p = 0; p < N; p++) {
			x = 2*M_PI*number[t][0]*chart_u(CLOSED.g, p%NU);
			y = M_PI*number[t][1]*chart_v(CLOSED.g, p/NU)/CLOSED.g.T;
			f[p] = number[t][2] ? sin(x)*sin(y) : cos(x)*cos(y);
			square += f[p]*f[p];
		}
		spectrum_forward(CLOSED, f, C);
		for (found = q = 0; q < N; q++) {
			spectrum_numbers(CLOSED, q, &m, &n);
			sine = q/(NU/2)%2;
			if (m == number[t][0] && n == number[t][1] && sine == number[t][2]) {
				assert_true(fabs(creal(C[q]) - sqrt(square*N)) < 1e-9);
				assert_true(fabs(spectrum_wave(CLOSED, q) - hypot(m, n/(2*CLOSED.g.T))) < 1e-12);
				found++;
			} else
				assert_true(cabs(C[q]) < 1e-9);
		}
		assert_int_equal(found, 1);
	}
	assert_false(spectrum_exists((Spectrum){ SPECTRUM_DFT, CLOSED.g }));
}

/* With logarithms it is d, log f less its border part, that is filtered, and percent are of the root
 * mean square of d minus its mean. */
static void
log_keeps_the_border_part(void **state)
{
	static const FilterRule rules[] = { FILTER_PERCENT, FILTER_RAW, FILTER_KEEP, FILTER_ENERGY, FILTER_LOWPASS };
	static const double bounds[] = { 4, 30, 50, 0.6, 4 };
	double f[N], d[N], h[N], mean = 0, rms = 0, raw;
	size_t kept, same;
	int t, p;

	(void)state;
	for (t = 0; t < 10; t++) {
		Spectrum s = t%2 ? DFT : DCT;
		FilterRule rule = rules[t/2];

		random_field(d, 11);
		for (p = 0; p < N; p++)
			f[p] = exp(d[p]);
		assert_int_equal(border_part(s.g, 1, (const double *const[]){ d }, (double *const[]){ h }), 0);
		for (mean = rms = p = 0; p < N; p++)
			mean += (d[p] -= h[p])/N;
		for (p = 0; p < N; p++)
			rms += (d[p] - mean)*(d[p] - mean)/N;
		raw = bounds[t/2]/100*N*sqrt(rms);
		filter(s, rule, bounds[t/2], 1, f, &kept);
		filter(s, rule == FILTER_PERCENT ? FILTER_RAW : rule, rule == FILTER_PERCENT ? raw : bounds[t/2], 0, d, &same);
		assert_int_equal(kept, same);
		assert_in_range(kept, 2, N - 1);
		for (p = 0; p < N; p++)
			assert_true(fabs(log(f[p]) - h[p] - d[p]) < 1e-12);
	}
}

/* Filtering is a projection: filtering again changes nothing, and what is dropped is orthogonal
 * to what is kept. */
static void
filter_projects(void **state)
{
	double f[N], g[N], h[N], dot;
	size_t kept, again;
	int b, p;

	(void)state;
	for (b = 0; b < 3; b++) {
		random_field(f, 5);
		memcpy(g, f, sizeof f);
		filter(basis(b), FILTER_KEEP, 200, 0, g, &kept);
		memcpy(h, g, sizeof g);
		filter(basis(b), FILTER_KEEP, kept, 0, h, &again);
		assert_int_equal(kept, again);
		assert_true(largest(N, g, h) < 1e-13);
		for (dot = p = 0; p < N; p++)
			dot += g[p]*(f[p] - g[p]);
		assert_true(fabs(dot) < 1e-11);
		assert_true(largest(N, f, g) > 0.1);
	}
}

/* A bound of 0 changes no bit of the field, with or without logarithms, even if some coefficients
 * are exactly 0 and so are not kept. */
static void
bound_zero_keeps_every_bit(void **state)
{
	double f[N], g[N];
	size_t kept;
	int i, p;

	(void)state;
	for (i = 0; i < 4; i++) {
		random_field(f, 6);
		for (p = 0; p < N; p++)
			f[p] += 1.1;
		memcpy(g, f, sizeof f);
		filter(i%2 ? DFT : DCT, FILTER_PERCENT, 0, i/2, g, &kept);
		assert_int_equal(kept, N);
		assert_memory_equal(f, g, sizeof f);
	}
	for (p = 0; p < N; p++)
		f[p] = p%NU < NU/2 ? 0.1 : -0.1;
	memcpy(g, f, sizeof f);
	filter(DCT, FILTER_PERCENT, 0, 0, g, &kept);
	assert_true(kept < N);
	assert_memory_equal(f, g, sizeof f);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(inverse_undoes_forward),
		cmocka_unit_test(parseval),
		cmocka_unit_test(a_wave_is_one_coefficient_or_a_pair),
		cmocka_unit_test(a_wave_of_the_sock_is_one_coefficient),
		cmocka_unit_test(a_wave_of_the_pillow_is_one_coefficient),
		cmocka_unit_test(percent_of_the_root_mean_square),
		cmocka_unit_test(raw_bound),
		cmocka_unit_test(keep_counts),
		cmocka_unit_test(energy_holds_the_share),
		cmocka_unit_test(low_pass_separates_waves),
		cmocka_unit_test(log_is_free_of_the_unit),
		cmocka_unit_test(log_keeps_the_border_part),
		cmocka_unit_test(filter_projects),
		cmocka_unit_test(bound_zero_keeps_every_bit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
