/* test_warp.c - maps between charts: gradient, minimum, bijectivity, a known map found again, quarter turns. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/morph/warpminimise.h"
#include "../lib/morph/warpturn.h"

enum { N = 65, M = 6 };
static const double T = 1.25;

/* A bumpy surface over the rectangle. */
static void
surface(double u, double v, double x[3])
{
	x[0] = u;
	x[1] = v;
	x[2] = 0.15*sin(9*u + 1)*cos(8*v) + 0.2*exp(-30*((u - 0.4)*(u - 0.4) + (v - 0.7)*(v - 0.7)))
	    + 0.12*exp(-60*((u - 0.75)*(u - 0.75) + (v - 0.35)*(v - 0.35)));
}

/* The map g: B is A's surface after g, so f is to be its inverse. */
static void
known(double u, double v, double g[2])
{
	g[0] = u + 0.05*sin(M_PI*u)*cos(M_PI*v/T);
	g[1] = v - 0.04*sin(M_PI*v/T)*(1 + cos(2*M_PI*u));
}

static void
sample(int mapped, double *phi[3])
{
	double g[2], x[3];
	int i, j, c;

	for (c = 0; c < 3; c++)
		phi[c] = malloc(N*N*sizeof(double));
	for (j = 0; j < N; j++)
		for (i = 0; i < N; i++) {
			g[0] = i/(N - 1.0);
			g[1] = j*T/(N - 1);
			if (mapped)
				known(g[0], g[1], g);
			surface(g[0], g[1], x);
			for (c = 0; c < 3; c++)
				phi[c][j*N+i] = x[c];
		}
}

/* The surfaces A and B. */
static void
surfaces(WarpSurface s[2])
{
	Chart g = { N, N, T, &CHART_RECTANGLE };
	double *phi[3];
	int k, c;

	for (k = 0; k < 2; k++) {
		sample(k, phi);
		assert_int_equal(warpsurface_init(&s[k], g, (const double *const *)phi, N, N), 0);
		for (c = 0; c < 3; c++)
			free(phi[c]);
	}
}

static const double P[3][2] = { { 0.4, 0.7 }, { 0.75, 0.35 }, { 0.2, 0.2 } }, Q[3][2] = { { 0.42, 0.66 }, { 0.7, 0.4 },
	{ 0.2, 0.25 } };

static void
gradient(void **state)
{
	double x[2*M*M], g[2*M*M], dump[2*M*M], most = 0;
	WarpSurface s[2];
	WarpEnergy e;
	int k;

	(void)state;
	surfaces(s);
	assert_int_equal(warpenergy_init(&e, N, N, T, M), 0);
	e.alpha = 0.3;
	e.beta = 30;
	e.a = s[0].normal;
	e.b = s[1].normal;
	e.marks = (WarpMarks){ 3, P, Q };
	e.distortion.stretch = 1.3;
	e.distortion.limit = warpdistortion_of(0.15);   /* exceeded in part of the cells */
	e.distortion.stiff = 5;
	for (k = 0; k < 2*M*M; k++)
		x[k] = 0.01*sin(7*k + 1)/(1 + k%M + k/M%M);
	assert_true(isfinite(warpenergy(&e, x, g)));
	for (k = 0; k < 2*M*M; k++)
		most = fmax(most, fabs(g[k]));
	for (k = 0; k < 2*M*M; k++) {
		double keep = x[k], d = 1e-7, up, down;

		x[k] = keep + d;
		up = warpenergy(&e, x, dump);
		x[k] = keep - d;
		down = warpenergy(&e, x, dump);
		x[k] = keep;
		if (fabs((up - down)/(2*d) - g[k]) > 1e-4*most)
			fail_msg("derivative %d: %g, differences give %g", k, g[k], (up - down)/(2*d));
	}
	warpenergy_free(&e);
	for (k = 0; k < 2; k++)
		warpsurface_free(&s[k]);
}

/* A displacement that folds the rectangle has no finite energy. */
static void
barrier(void **state)
{
	double x[2*M*M] = { 0 }, g[2*M*M];
	WarpEnergy e;

	(void)state;
	assert_int_equal(warpenergy_init(&e, N, N, T, M), 0);
	e.alpha = 1;
	assert_true(fabs(warpenergy(&e, x, g)) < 1e-12);
	x[1] = 0.3;                                     /* 1 - 0.3 pi > 0 */
	assert_true(isfinite(warpenergy(&e, x, g)));
	x[1] = 0.33;                                    /* 1 - 0.33 pi < 0 */
	assert_true(isinf(warpenergy(&e, x, g)));
	warpenergy_free(&e);
}

static double
norm(int n, const double *g)
{
	double sum = 0;
	int k;

	for (k = 0; k < n; k++)
		sum += g[k]*g[k];
	return sqrt(sum);
}

/* At the minimum the gradient is small and landmarks meet as far as the distortion lets them; from a folded
 * start the same minimum is found. */
static void
minimum(void **state)
{
	double x[2*M*M] = { 0 }, y[2*M*M] = { 0 }, g[2*M*M], start, first, least, again;
	WarpEnergy e;

	(void)state;
	assert_int_equal(warpenergy_init(&e, N, N, T, M), 0);
	e.alpha = 1;
	e.beta = 130;
	e.marks = (WarpMarks){ 3, P, Q };
	first = warpenergy(&e, x, g);
	start = norm(2*M*M, g);
	assert_int_equal(warpminimise(&e, x), 0);
	least = warpenergy(&e, x, g);
	print_message("energy %.5g to %.5g, gradient %.3g to %.3g\n", first, least, start, norm(2*M*M, g));
	assert_true(least < 0.1*first && norm(2*M*M, g) < 0.01*start);
	y[1] = 0.4;
	assert_true(isinf(warpenergy(&e, y, g)));
	assert_int_equal(warpminimise(&e, y), 0);
	again = warpenergy(&e, y, g);
	assert_true(fabs(again - least) < 1e-3*least);
	warpenergy_free(&e);
}

/* No cell of f is turned over, and sides lie on sides. */
static void
check_bijective(const Warp *w)
{
	enum { n = 100 };
	static double f[2*n*n];
	const double *x = f, *y = f + n*n;
	int i, j;

	assert_int_equal(warp_field(w, n, n, 1, f), 0);
	for (j = 0; j < n; j++)
		assert_true(x[j*n] == 0 && x[j*n+n-1] == 1 && y[j] == 0 && y[(n-1)*n+j] == T);
	for (j = 0; j < n - 1; j++)
		for (i = 0; i < n - 1; i++) {
			int p = j*n + i;

			assert_true((x[p+1] - x[p])*(y[p+n] - y[p]) - (y[p+1] - y[p])*(x[p+n] - x[p]) > 0);
		}
}

/* The largest |g(f(x)) - x|. */
static double
deviation(const Warp *w)
{
	double most = 0, f[2];
	int i, j;

	for (j = 0; j <= 20; j++)
		for (i = 0; i <= 20; i++) {
			warp_at(w, i/20.0, j*T/20, f);
			known(f[0], f[1], f);
			most = fmax(most, hypot(f[0] - i/20.0, f[1] - j*T/20));
		}
	return most;
}

static void
found_again(void **state)
{
	WarpSurface s[2];
	WarpTask t = { &s[0], &s[1], T, 1, 1, { 0, NULL, NULL }, 0.6 };
	WarpFit none, fit;
	Warp w;
	double before;

	(void)state;
	surfaces(s);
	assert_int_equal(warp_identity(&t, &w, &none), 0);
	before = deviation(&w);
	assert_int_equal(warp_find(&t, WARP_LEVELS, &w, &fit), 0);
	check_bijective(&w);
	print_message("deviation %.4f, without map %.4f; normals %.4f, %.4f; |mu| %.3f %.3f\n", deviation(&w), before,
	    fit.apart, none.apart, fit.mu_mean, fit.mu_max);
	assert_true(before > 0.07);
	assert_true(deviation(&w) < 0.3*before);
	assert_true(fit.apart < 0.05*none.apart);
	assert_true(fit.mu_max < 0.6);
	t.mumax = 0.05;
	assert_int_equal(warp_find(&t, WARP_LEVELS, &w, &fit), 0);
	assert_true(fit.mu_max < 0.05);
	warpsurface_free(&s[0]);
	warpsurface_free(&s[1]);
}

static void
by_landmarks(void **state)
{
	WarpSurface s[2];
	WarpTask t = { &s[0], &s[1], T, 1, 0, { 3, P, Q }, 0.6 };
	WarpFit fit;
	Warp w;

	(void)state;
	surfaces(s);
	assert_int_equal(warp_find(&t, WARP_LEVELS, &w, &fit), 0);
	check_bijective(&w);
	print_message("landmarks %.4f apart\n", fit.marks);
	assert_true(fit.marks < 0.01);
	warpsurface_free(&s[0]);
	warpsurface_free(&s[1]);
}

static void
quarters(void **state)
{
	Chart g = { 4, 3, 0.8, &CHART_RECTANGLE }, h;
	double u[12], v[12], tu[12], tv[12], x, y;
	int turns, i, j;

	(void)state;
	for (i = 0; i < 12; i++) {
		u[i] = chart_u(g, i % 4);
		v[i] = chart_v(g, i/4);
	}
	for (turns = 0; turns < WARPTURN_WAYS; turns++) {
		h = warpturn_chart(g, turns);
		warpturn_field(g, turns, u, tu);
		warpturn_field(g, turns, v, tv);
		for (j = 0; j < h.nv; j++)
			for (i = 0; i < h.nu; i++) {
				x = chart_u(h, i);
				y = chart_v(h, j);
				warpturn_back(g, turns, &x, &y);
				assert_true(fabs(x - tu[j*h.nu+i]) < 1e-12 && fabs(y - tv[j*h.nu+i]) < 1e-12);
				warpturn_point(g, turns, &x, &y);
				assert_true(fabs(x - chart_u(h, i)) < 1e-12 && fabs(y - chart_v(h, j)) < 1e-12);
			}
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(gradient),
		cmocka_unit_test(barrier),
		cmocka_unit_test(minimum),
		cmocka_unit_test(found_again),
		cmocka_unit_test(by_landmarks),
		cmocka_unit_test(quarters),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
