/* test_matching.c - matching.h: matching two borders by landmarks and arc length, and the borders
 * between them; coons.h: Coons patches. */
#include "cmock.h"

#include <math.h>

#include "../lib/grid/coons.h"
#include "../lib/morph/matching.h"
#include "../lib/synth/rng.h"

#define assert_near(x, want, error) assert_true(fabs((x) - (want)) <= (error))

enum { NU = 19, NV = 13 };

/* A closed space curve without symmetry, whose nodes are unevenly spaced. */
static void
curve(Border *b, int nu, int nv, double phase, double size)
{
	double s;
	int k;

	assert_int_equal(border_init(b, (Chart){ nu, nv, 1, &CHART_RECTANGLE }), 0);
	for (k = 0; k < b->n; k++) {
		s = 2*M_PI*border_place(b, k)/4;
		s += 0.6*sin(s + phase);
		b->x[3*k] = size*(3*cos(s) + 0.3*sin(2*s));
		b->x[3*k+1] = size*(2*sin(s) + 0.4*cos(2*s) + phase);
		b->x[3*k+2] = size*(0.5*cos(3*s) + 0.2*sin(s));
	}
	assert_int_equal(border_measure(b), 0);
}

static double
wrap(double r)
{
	r = fmod(r, 4);
	return r < 0 ? r + 4 : r;
}

static void
assert_point(const Matching *m, double t, double r, const double want[3])
{
	double x[3];
	int c;

	matching_at(m, t, wrap(r), x);
	for (c = 0; c < 3; c++)
		assert_near(x[c], want[c], 1e-9);
}

static void
order(void **state)
{
	static const double good[] = { 3.5, 3.9, 0, 1, 3.4999 }, back[] = { 0.5, 1, 0.9, 2 },
	    twice[] = { 0.5, 1, 1, 2 }, over[] = { 1, 2, 3, 1.5 }, again[] = { 1, 2, 1 };

	(void)state;
	assert_int_equal(matching_order(5, good), 5);
	assert_int_equal(matching_order(1, good), 1);
	assert_int_equal(matching_order(4, back), 2);
	assert_int_equal(matching_order(4, twice), 2);
	assert_int_equal(matching_order(4, over), 3);
	assert_int_equal(matching_order(3, again), 2);
}

/* The place on b at the fraction f of the arc length from place q to place q2, found by bisection. */
static double
by_share(const Border *b, double q, double q2, double f)
{
	double lo = q, hi = q2 > q ? q2 : q2 + 4, mid, s, way, L = b->s[b->n];
	int i;

	way = border_arc(b, q2) - border_arc(b, q) + (q2 > q ? 0 : L);
	for (i = 0; i < 60; i++) {
		mid = (lo + hi)/2;
		s = border_arc(b, wrap(mid)) - border_arc(b, q) + (mid >= 4 ? L : 0);
		if (s < f*way)
			lo = mid;
		else
			hi = mid;
	}
	return lo;
}

static const double P[3][5] = { { 0.3, 1.25, 2.6, 3, 3.8 }, { 3.2, 0.1, 0.5, 1.9, 2.5 }, { 1 } };
static const double Q[3][5] = { { 0, 1.5, 2, 2.9, 3.7 }, { 2.9, 3.9, 0.7, 2, 2.1 }, { 0.75 } };
static const int COUNT[3] = { 5, 5, 1 };

/* Between two landmarks, points at equal fractions of the arc length are matched, equation (34).
 * The borders between a and b satisfy (20), and are a itself at t = 0 and b at t = 1. */
static void
shares_of_length(void **state)
{
	double a_x[3], b_x[3], want[3], f, t, ra, rb, p, p2;
	int s, i, k, c, n, at;
	Border a, b;
	Matching m;

	(void)state;
	curve(&a, NU, NV, 0, 1);
	curve(&b, NU, NV, 1, 2);
	for (s = 0; s < 3; s++) {
		n = COUNT[s];
		assert_int_equal(matching_init(&m, &a, &b, n, P[s], Q[s], &at), 0);
		for (k = 0; k < a.n; k++) {
			assert_point(&m, 0, border_place(&a, k), a.x + 3*k);
			assert_point(&m, 1, border_place(&b, k), b.x + 3*k);
		}
		for (k = 0; k + 1 < m.n; k++)
			assert_true(m.r[0][k] <= m.r[0][k+1] && m.r[1][k] <= m.r[1][k+1]);
		for (i = 0; i < n; i++)
			for (f = 0; f < 1; f += 0.0625) {
				p = P[s][i], p2 = P[s][(i+1)%n];
				ra = by_share(&a, p, p2, f);
				rb = by_share(&b, Q[s][i], Q[s][(i+1)%n], f);
				border_at(&a, wrap(ra), a_x);
				border_at(&b, wrap(rb), b_x);
				rb += rb > ra + 2 ? -4 : rb < ra - 2 ? 4 : 0;
				for (t = 0; t <= 1; t += 0.25) {
					for (c = 0; c < 3; c++)
						want[c] = (1 - t)*a_x[c] + t*b_x[c];
					assert_point(&m, t, (1 - t)*ra + t*rb, want);
				}
			}
		matching_free(&m);
	}
	border_free(&a);
	border_free(&b);
}

/* If a landmark is just after corner 0 on one border and just before it on the other, the borders
 * are matched across this corner, not the long way round. */
static void
across_the_corner(void **state)
{
	const double p = 0.1, q = 3.9;
	Border a, b;
	Matching m;
	int k, at;

	(void)state;
	curve(&a, NU, NV, 0, 1);
	curve(&b, NU, NV, 0, 1);
	assert_int_equal(matching_init(&m, &a, &b, 1, &p, &q, &at), 0);
	for (k = 0; k < m.n; k++)
		assert_true(fabs(m.r[0][k] - m.r[1][k]) < 1);
	matching_free(&m);
	assert_int_equal(matching_init(&m, &a, &b, 1, &q, &p, &at), 0);
	for (k = 0; k < m.n; k++)
		assert_true(fabs(m.r[0][k] - m.r[1][k]) < 1);
	matching_free(&m);
	border_free(&a);
	border_free(&b);
}

static void
equal_places(void **state)
{
	double want[3], w[2*(NU + NV)], sum = 0;
	Border a, b;
	Matching m;
	int k, c;

	(void)state;
	curve(&a, NU, NV, 0, 1);
	curve(&b, NU, NV, 1, 2);
	assert_int_equal(matching_conformal(&m, &a, &b), 0);
	assert_int_equal(m.n, a.n + 1);
	for (k = 0; k < a.n; k++) {
		for (c = 0; c < 3; c++)
			want[c] = 0.7*a.x[3*k+c] + 0.3*b.x[3*k+c];
		assert_point(&m, 0.3, border_place(&a, k), want);
	}
	matching_weights(&m, w);
	for (k = 0; k < m.n; k++)
		sum += w[k];
	assert_near(sum, 2, 1e-12);
	assert_near(w[5], (a.s[6] - a.s[4])/a.s[a.n]/2 + (b.s[6] - b.s[4])/b.s[b.n]/2, 1e-12);
	matching_free(&m);
	border_free(&a);
	border_free(&b);
}

static void
no_length(void **state)
{
	double p[3] = { 0.5, 1 + 1.0/(NV - 1), 1 + 2.0/(NV - 1) }, q[3] = { 0.5, 1.2, 1.4 };
	Border a, b;
	Matching m;
	int at = -1;

	(void)state;
	curve(&a, NU, NV, 0, 1);
	curve(&b, NU, NV, 1, 2);
	memcpy(a.x + 3*(NU + 1), a.x + 3*NU, 3*sizeof(double));
	assert_int_equal(border_measure(&a), 0);
	assert_int_equal(matching_init(&m, &a, &b, 3, p, q, &at), MATCHING_ELENGTH);
	assert_int_equal(at, 1);
	assert_int_equal(matching_init(&m, &b, &a, 3, q, p, &at), MATCHING_ELENGTH);
	p[2] += 0.01;           /* an edge of length 0 among others is allowed */
	assert_int_equal(matching_init(&m, &a, &b, 3, p, q, &at), 0);
	matching_free(&m);
	border_free(&a);
	border_free(&b);
}

/* A Coons patch reproduces bilinear functions and sums of a function of u and a function of v, and
 * has the given values on the border. */
static void
coons_patches(void **state)
{
	double d[3*2*(NU + NV)], f[3], u, v;
	uint64_t seed = 1;
	int i, j, k, n = 2*(NU + NV) - 4;

	(void)state;
	for (k = 0; k < n; k++) {
		border_node(NU, NV, k, &i, &j);
		u = (double)i/(NU - 1), v = (double)j/(NV - 1);
		d[3*k] = 1 + 2*u - 3*v + 4*u*v;
		d[3*k+1] = u*u + v*v*v;
		d[3*k+2] = rng_unit(&seed);
	}
	for (j = 0; j < NV; j++)
		for (i = 0; i < NU; i++) {
			u = (double)i/(NU - 1), v = (double)j/(NV - 1);
			coons((Chart){ NU, NV, 1, &CHART_RECTANGLE }, d, i, j, f);
			assert_near(f[0], 1 + 2*u - 3*v + 4*u*v, 1e-13);
			assert_near(f[1], u*u + v*v*v, 1e-13);
			if (i == 0 || j == 0 || i == NU - 1 || j == NV - 1)
				assert_true(f[2] == d[3*border_index(NU, NV, i, j) + 2]);
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(order), cmocka_unit_test(shares_of_length),
		cmocka_unit_test(across_the_corner), cmocka_unit_test(equal_places),
		cmocka_unit_test(no_length), cmocka_unit_test(coons_patches)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
