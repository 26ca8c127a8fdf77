/* test_procrustes.c - procrustes.h: known rigid motions are found, and the result is never a
 * reflection. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/procrustes.h"
#include "../lib/synth/rng.h"
#include "../lib/base/vec3.h"

#define assert_near(x, want, error) assert_true(fabs((x) - (want)) <= (error))

enum { N = 50 };

static void
noise(uint64_t *seed, int n, double *x)
{
	int i;

	for (i = 0; i < n; i++)
		x[i] = 2*rng_unit(seed) - 1;
}

/* A rotation about a random axis, by Rodrigues' formula. */
static void
rotation(uint64_t *seed, double angle, double R[3][3])
{
	double a[3], e[3], y[3], z[3], r;
	int i, k;

	noise(seed, 3, a);
	r = norm3(a);
	for (k = 0; k < 3; k++)
		a[k] /= r;
	for (i = 0; i < 3; i++) {
		e[0] = e[1] = e[2] = 0;
		e[i] = 1;
		cross3(a, e, y);
		cross3(a, y, z);
		for (k = 0; k < 3; k++)
			R[k][i] = e[k] + sin(angle)*y[k] + (1 - cos(angle))*z[k];
	}
}

static void
assert_rotation(double R[3][3])
{
	double c[3];
	int i, k;

	for (i = 0; i < 3; i++)
		for (k = 0; k < 3; k++)
			assert_near(dot3(R[i], R[k]), i == k, 1e-14);
	cross3(R[0], R[1], c);
	assert_near(dot3(c, R[2]), 1, 1e-14);
}

static void
known_motions(void **state)
{
	static const double unit[] = { 1, 1e-120, 1e120 };
	double a[3*N], b[3*N], w[N], rms, angle;
	Rigid truth, r;
	uint64_t seed = 1;
	int i, k, u;

	(void)state;
	for (i = 0; i < 30; i++)
		for (u = 0; u < 3; u++) {
			angle = i == 29 ? M_PI : 0.1*i;
			rotation(&seed, angle, truth.R);
			noise(&seed, 3, truth.t);
			noise(&seed, 3*N, b);
			for (k = 0; k < 3*N; k++)
				b[k] *= unit[u];
			for (k = 0; k < 3; k++)
				truth.t[k] *= 10*unit[u];
			for (k = 0; k < N; k++)
				w[k] = rng_unit(&seed);
			memcpy(a, b, sizeof a);
			rigid_move(&truth, N, a);
			assert_int_equal(procrustes(N, i%2 ? w : NULL, a, b, &r, &rms), 0);
			assert_rotation(r.R);
			assert_near(rigid_angle(&r), angle, 1e-7);
			assert_true(rms < 1e-13*unit[u]);
			for (k = 0; k < 9; k++)
				assert_near(r.R[k/3][k%3], truth.R[k/3][k%3], 1e-13);
			for (k = 0; k < 3; k++)
				assert_near(r.t[k]/unit[u], truth.t[k]/unit[u], 1e-12);
		}
}

static double
misfit(int n, const double *w, const double *a, const double *b, const Rigid *r)
{
	double sum = 0, d[3], x[3];
	int i;

	for (i = 0; i < n; i++) {
		memcpy(x, b + 3*i, sizeof x);
		rigid_move(r, 1, x);
		sub3(a + 3*i, x, d);
		sum += w[i]*dot3(d, d);
	}
	return sum;
}

/* The motion is a minimum: no small change of it gives a smaller rms.  The rms returned is that of
 * the motion returned. */
static void
minimum(void **state)
{
	double a[3*N], b[3*N], w[N], best, rms, sum;
	Rigid r, turn, q;
	uint64_t seed = 2;
	int i, k, l, m;

	(void)state;
	for (i = 0; i < 20; i++) {
		noise(&seed, 3*N, a);
		noise(&seed, 3*N, b);
		for (sum = 0, k = 0; k < N; k++)
			sum += w[k] = rng_unit(&seed);
		assert_int_equal(procrustes(N, w, a, b, &r, &rms), 0);
		assert_rotation(r.R);
		best = misfit(N, w, a, b, &r);
		assert_near(rms, sqrt(best/sum), 1e-13);
		for (m = 0; m < 20; m++) {
			rotation(&seed, 1e-3, turn.R);
			noise(&seed, 3, turn.t);
			q = r;
			for (k = 0; k < 3; k++) {
				q.t[k] += 1e-3*turn.t[k];
				for (l = 0; l < 3; l++)
					q.R[k][l] = turn.R[k][0]*r.R[0][l] + turn.R[k][1]*r.R[1][l] + turn.R[k][2]*r.R[2][l];
			}
			assert_true(misfit(N, w, a, b, &q) > best);
		}
	}
}

/* For a mirror image procrustes still returns a rotation.  It cannot fit points in space, but it fits
 * points in a plane exactly. */
static void
no_reflection(void **state)
{
	double a[3*N], b[3*N], rms;
	uint64_t seed = 3;
	Rigid r;
	int k;

	(void)state;
	noise(&seed, 3*N, b);
	for (k = 0; k < 3*N; k++)
		a[k] = k%3 == 2 ? -b[k] : b[k];
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), 0);
	assert_rotation(r.R);
	assert_true(rms > 0.1);
	for (k = 0; k < N; k++)
		a[3*k] = -(b[3*k]), a[3*k+1] = b[3*k+1], a[3*k+2] = b[3*k+2] = 0;
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), 0);
	assert_rotation(r.R);
	assert_true(rms < 1e-14);
}

/* Degenerate input: collinear points, a single point, and points that are not finite. */
static void
degenerate_points(void **state)
{
	double a[3*N] = { 0 }, b[3*N] = { 0 }, rms;
	Rigid r;
	int k;

	(void)state;
	for (k = 0; k < N; k++)
		a[3*k+1] = b[3*k] = k;
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), 0);
	assert_rotation(r.R);
	assert_true(rms < 1e-12);
	for (k = 0; k < 3*N; k++)
		a[k] = 7, b[k] = 5;
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), 0);
	assert_rotation(r.R);
	assert_near(rigid_angle(&r), 0, 0);
	assert_near(r.t[0], 2, 1e-14);
	a[4] = NAN;
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), PROCRUSTES_EVALUE);
	a[4] = 1e308;
	a[7] = a[10] = -1.5e308;
	assert_int_equal(procrustes(N, NULL, a, b, &r, &rms), PROCRUSTES_EVALUE);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(known_motions), cmocka_unit_test(minimum),
		cmocka_unit_test(no_reflection), cmocka_unit_test(degenerate_points)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
