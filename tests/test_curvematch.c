/* test_curvematch.c - curvematch.h, the shift of a closed curve that fits another curve best:
 * compared with a rigid fit for each shift, and on curves with a known shift. */
#include "cmock.h"

#include <math.h>

#include "../lib/morph/curvematch.h"
#include "../lib/base/procrustes.h"
#include "../lib/synth/rng.h"

#define assert_near(x, want, error) assert_true(fabs((x) - (want)) <= (error))

enum { N = 120 };

/* n points of a closed space curve without symmetry; the first has parameter `from`. */
static void
curve(int n, double from, double *x)
{
	double s;
	int i;

	for (i = 0; i < n; i++) {
		s = 2*M_PI*(i + from)/n;
		x[3*i] = 3*cos(s) + 0.3*sin(2*s);
		x[3*i+1] = 2*sin(s) + 0.4*cos(2*s);
		x[3*i+2] = 0.5*cos(3*s) + 0.2*sin(s);
	}
}

static void
disturb(uint64_t *seed, double size, int n, double *x)
{
	int i;

	for (i = 0; i < 3*n; i++)
		x[i] += size*(2*rng_unit(seed) - 1);
}

static const Rigid MOVE = { { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } },
	{ 5, -7, 11 } };

/* The rms of every shift is that of the best rigid motion (procrustes) for the pairs of points that
 * this shift makes. */
static void
against_brute_force(void **state)
{
	static const int size[] = { 1, 2, 3, 16, 31, N };
	double a[3*N], b[3*N], c[3*N], rms[N], angle[N], want;
	uint64_t seed = 1;
	Rigid r;
	int i, k, s, n;

	(void)state;
	for (k = 0; k < 6; k++) {
		n = size[k];
		memset(a, 0, sizeof a);
		memset(b, 0, sizeof b);
		disturb(&seed, 3, n, a);
		disturb(&seed, 2, n, b);
		rigid_move(&MOVE, n, b);
		assert_int_equal(curvematch(n, a, b, rms, angle), 0);
		for (s = 0; s < n; s++) {
			for (i = 0; i < n; i++)
				memcpy(c + 3*i, b + 3*((i + s)%n), 3*sizeof *c);
			assert_int_equal(procrustes(n, NULL, a, c, &r, &want), 0);
			assert_near(rms[s], want, n > 3 ? 1e-12 : 2e-6);
		}
	}
}

static void
known_shifts(void **state)
{
	static const double size[] = { 0, 0.02, 0.1 };
	double a[3*N], b[3*N], rms[N], angle[N];
	uint64_t seed = 2;
	int s, k;

	(void)state;
	for (k = 0; k < 3; k++)
		for (s = 0; s < N; s += 7) {
			curve(N, 0, a);
			curve(N, -s, b);
			rigid_move(&MOVE, N, b);
			disturb(&seed, size[k], N, b);
			assert_int_equal(curvematch(N, a, b, rms, angle), 0);
			assert_int_equal(curvematch_choose(N, rms, angle, 1), s);
			assert_true(rms[s] < 1e-6 + 1.2*size[k]);
		}
}

/* On a circle all shifts fit equally well; the one without rotation is chosen. */
static void
circle(void **state)
{
	double a[3*N] = { 0 }, rms[N], angle[N];
	int i;

	(void)state;
	for (i = 0; i < N; i++)
		a[3*i] = 1e6*cos(2*M_PI*i/N), a[3*i+1] = 1e6*sin(2*M_PI*i/N);
	assert_int_equal(curvematch(N, a, a, rms, angle), 0);
	assert_int_equal(curvematch_choose(N, rms, angle, 1), 0);
}

/* An ellipse fits itself in two positions, half a turn apart: the fit with the smaller rotation is
 * chosen, and curvematch_next returns the rms of the other. */
static void
two_fits(void **state)
{
	double a[3*N] = { 0 }, b[3*N], rms[N], angle[N], turn;
	uint64_t seed = 5;
	int i;

	(void)state;
	for (turn = -3; turn < 3.1; turn += 0.4) {
		for (i = 0; i < N; i++) {
			a[3*i] = 2*cos(2*M_PI*i/N);
			a[3*i+1] = sin(2*M_PI*i/N);
			b[3*i] = 2*cos(2*M_PI*(i - 20)/N)*cos(turn) - sin(2*M_PI*(i - 20)/N)*sin(turn);
			b[3*i+1] = 2*cos(2*M_PI*(i - 20)/N)*sin(turn) + sin(2*M_PI*(i - 20)/N)*cos(turn);
			b[3*i+2] = 0;
		}
		disturb(&seed, 0.1, N, b);
		assert_int_equal(curvematch(N, a, b, rms, angle), 0);
		i = curvematch_choose(N, rms, angle, 1.25);
		assert_in_range(i, fabs(turn) < M_PI/2 ? 18 : 78, fabs(turn) < M_PI/2 ? 22 : 82);
		assert_true(curvematch_next(N, rms, i) < 1.25*rms[i]);
		assert_true(angle[i] < M_PI/2 + 0.1);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(against_brute_force), cmocka_unit_test(known_shifts),
		cmocka_unit_test(circle), cmocka_unit_test(two_fits)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
