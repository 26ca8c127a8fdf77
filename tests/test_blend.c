/* test_blend.c - blend.h, blendmetric.h and cap.h: metrics between surfaces, and the part of K above H^2. */
#include "cmock.h"

#include <math.h>

#include "../lib/grid/lambdah.h"
#include "../lib/grid/stencil.h"
#include "../lib/morph/blend.h"
#include "../lib/morph/blendmetric.h"
#include "../lib/morph/cap.h"
#include "sockcap.h"

enum { MOST = 130*130 };

typedef struct Fields {
	double phi[3][MOST], lambda[MOST], H[MOST], nu[2][MOST], tau[2][MOST];
} Fields;

static Fields of[3], to;

static Metric
metric(Chart g, Fields *f)
{
	return (Metric){ g, f->lambda, f->H, { f->nu[0], f->nu[1] }, { f->tau[0], f->tau[1] } };
}

static void
measure(Chart g, Fields *f)
{
	const double *const phi[3] = { f->phi[0], f->phi[1], f->phi[2] };
	double *const nu[2] = { f->nu[0], f->nu[1] }, *const tau[2] = { f->tau[0], f->tau[1] };

	lambdah(g, phi, LAMBDAH_NORMAL, f->lambda, f->H);
	lambdah_residue(g, phi, f->lambda, nu, tau);
}

static double
inner_distance(Chart g, const double *a, const double *b)
{
	double most = 0;
	int p;

	for (p = 0; p < g.nu*g.nv; p++)
		if (stencil_is_inner(g, p%g.nu, p/g.nu))
			most = fmax(most, fabs(a[p] - b[p]));
	return most;
}

static Chart
rectangle(int nu, int nv)
{
	return (Chart){ nu, nv, 0.7, &CHART_RECTANGLE };
}

static void
weighted_sums(void **state)
{
	static const double a[3] = { 1, -0.0, 3 }, b[3] = { 7, 5, -2 }, c[3] = { 0.5, 1e300, 4 };
	static const double *const f[3] = { a, b, c };
	static const double half[3] = { 0.5, 0.75, -0.25 }, one[3] = { 1, 0, 0 }, two[3] = { 2, 0, 0 };
	double x[3];

	(void)state;
	blend(3, 2, half, f, x);
	assert_true(x[0] == 5.75 && x[1] == 3.75 && x[2] == 0);
	blend(3, 3, half, f, x);
	assert_true(x[0] == 5.625 && x[2] == -1);
	blend(3, 3, one, f, x);
	assert_memory_equal(x, a, sizeof a);
	blend(3, 3, two, f, x);
	assert_true(x[0] == 2 && blend_single(3, two) < 0 && blend_single(3, one) == 0);
}

/* The integral of exp(r/2) from 0 to s, r = a sin(2x) + b x, by Simpson's rule. */
static double
stretched(double a, double b, double s)
{
	double sum = 0, x;
	int k;

	for (k = 0; k <= 64; k++) {
		x = s*k/64;
		sum += (k == 0 || k == 64 ? 1 : k%2 ? 4 : 2)*exp((a*sin(2*x) + b*x)/2);
	}
	return sum*s/192;
}

/* The plane with the metric diag(exp(r), exp(q)) in coordinates turned by an angle: such metrics commute, and
 * their blends are metrics of the plane again, with r and q linear. */
static void
sample_plane(Chart g, double a, double b, double c, Fields *f)
{
	int p;

	for (p = 0; p < g.nu*g.nv; p++) {
		double u = chart_u(g, p%g.nu), v = chart_v(g, p/g.nu), s = 0.8*u + 0.6*v, t = 0.8*v - 0.6*u;

		f->phi[0][p] = 0.8*stretched(a, b, s);
		f->phi[1][p] = 0.8*stretched(c, -b, t);
		f->phi[2][p] = 0.1;
	}
}

/* The largest error of lambda, nu and tau, at all inner nodes, against those of the blended plane. */
static double
plane_error(int nu, int nv)
{
	static const double w[3] = { 0.7, 0.6, -0.3 }, a[3] = { 0.5, -0.4, 0.3 }, b[3] = { 0.6, 0.2, -0.5 },
	    c[3] = { 0.1, 0.7, -0.6 };
	Chart g = rectangle(nu, nv);
	double wa = 0, wb = 0, wc = 0, most = 0;
	Metric m[3], out = metric(g, &to);
	static Fields want;
	int k;

	for (k = 0; k < 3; k++) {
		sample_plane(g, a[k], b[k], c[k], &of[k]);
		measure(g, &of[k]);
		m[k] = metric(g, &of[k]);
		wa += w[k]*a[k];
		wb += w[k]*b[k];
		wc += w[k]*c[k];
	}
	blendmetric(3, w, m, NULL, &out);
	sample_plane(g, wa, wb, wc, &want);
	measure(g, &want);
	most = inner_distance(g, to.lambda, want.lambda);
	for (k = 0; k < 2; k++) {
		most = fmax(most, inner_distance(g, to.nu[k], want.nu[k]));
		most = fmax(most, inner_distance(g, to.tau[k], want.tau[k]));
	}
	assert_true(inner_distance(g, to.tau[1], of[0].tau[1]) > 0.1);
	return most;
}

static void
metrics_of_the_plane(void **state)
{
	double coarse = plane_error(33, 29), fine = plane_error(65, 57), finest = plane_error(129, 113);

	(void)state;
	assert_true(finest < 2e-4 && fine < coarse/3.5 && finest < fine/3.5);
}

/* A sock that is not conformal: a cap, stretched in one direction.  The fold passes tau on with its sign. */
static double
sock_error(int nu, int nv)
{
	Chart g = { nu, nv, 0.4, &CHART_SOCK };
	double *const phi[3] = { of->phi[0], of->phi[1], of->phi[2] }, most = 0, tau[2], size = 0;
	Metric m = metric(g, of);
	int p, c;

	sample_sockcap(g, 0.5, phi, NULL, NULL);
	for (p = 0; p < nu*nv; p++)
		of->phi[0][p] *= 1.5;
	measure(g, of);
	for (p = 0; p < nu*nv; p++) {
		int i = p%nu, j = p/nu;

		/* all stencils are wrong within some nodes of a cone, where lambda goes to 0 */
		if (!stencil_is_inner(g, i, j) || chart_from_cone(g, 0, p) < 0.1 || chart_from_cone(g, 1, p) < 0.1)
			continue;
		blendmetric_tau(&m, i, j, tau);
		for (c = 0; c < 2; c++) {
			most = fmax(most, fabs(tau[c] - of->tau[c][p]));
			size = fmax(size, fabs(tau[c]));
		}
	}
	assert_true(size > 1);
	return most/size;
}

static void
metrics_of_a_sock(void **state)
{
	double coarse = sock_error(64, 26), fine = sock_error(128, 52);

	(void)state;
	assert_true(coarse < 0.03 && fine < coarse/3);
}

/* Without residues: log lambda and lambda^2 H; with them, one weight of 1 copies, and equal surfaces stay. */
static void
simple_blends(void **state)
{
	static const double w[2] = { 0.25, 0.75 }, one[2] = { 0, 1 };
	Chart g = rectangle(20, 23);
	Metric m[2] = { metric(g, &of[0]), metric(g, &of[1]) }, out = metric(g, &to);
	double l, c;
	int p, k;

	(void)state;
	sample_plane(g, 0.5, 0.6, 0.1, &of[0]);
	for (p = 0; p < g.nu*g.nv; p++)
		of[0].phi[2][p] = sin(of[0].phi[0][p]);
	measure(g, &of[0]);
	of[1] = of[0];
	blendmetric(2, w, m, NULL, &out);
	assert_true(inner_distance(g, to.H, of[0].H) < 1e-13 && inner_distance(g, to.tau[0], of[0].tau[0]) < 1e-12);
	for (p = 0; p < g.nu*g.nv; p++) {
		of[1].lambda[p] *= 2 + sin(p);
		of[1].H[p] = cos(p);
	}
	blendmetric(2, one, m, NULL, &out);
	assert_memory_equal(to.tau[1], of[1].tau[1], g.nu*g.nv*sizeof(double));
	for (k = 0; k < 2; k++)
		m[k].nu[0] = NULL;
	out.nu[0] = NULL;
	blendmetric(2, w, m, NULL, &out);
	for (p = 0; p < g.nu*g.nv; p++) {
		l = pow(of[0].lambda[p], 0.25)*pow(of[1].lambda[p], 0.75);
		c = (0.25*pow(of[0].lambda[p], 2)*of[0].H[p] + 0.75*pow(of[1].lambda[p], 2)*of[1].H[p])/(l*l);
		assert_true(fabs(to.lambda[p] - l) < 1e-13*l && fabs(to.H[p] - c) < 1e-12*(1 + fabs(c)));
	}
}

/* A sphere has hardly any excess; with H = 0 it has its area, but for four rings. */
static void
excess_of_spheres(void **state)
{
	static double x[MOST], none[MOST];
	Chart chart[2] = { rectangle(97, 101), { 96, 70, 0.4, &CHART_SOCK } };
	double area;
	int k, p, i, j;

	(void)state;
	for (k = 0; k < 2; k++) {
		Chart g = chart[k];
		Range u = stencil_apart(g, 0, 4), v = stencil_apart(g, 1, 4);

		if (k)
			sample_sockcap(g, 0.5, NULL, of->lambda, of->H);
		else
			sample_immersion(stereo, g, 1, NULL, of->lambda, of->H);
		for (area = 0, j = v.from; j < v.to; j++)
			for (i = u.from; i < u.to; i++)
				area += pow(of->lambda[j*g.nu+i], 2)*chart_h(g)*chart_k(g);
		memset(none, 0, sizeof none);
		assert_int_equal(cap_excess(g, of->lambda, of->H, x), 0);
		assert_true(cap_integral(g, x) < 0.01*area);
		assert_int_equal(cap_excess(g, of->lambda, none, x), 0);
		/* the mean spreads -Delta log lambda over the rings, and over the cones of the sock, where it is
		 * -2 pi for an angle of pi */
		assert_true(fabs(cap_integral(g, x) - area) < (k ? 0.2 : 0.1)*area);
		for (p = 0; p < g.nu; p++)
			assert_true(x[(g.nv - 1)*g.nu + p] == 0);
	}
}

/* Half of x is taken off lambda^2 K, to rounding, and lambda^2 H is kept. */
static void
lowered(void **state)
{
	static double x[MOST], before[MOST], after[MOST], H[MOST];
	Chart chart[2] = { rectangle(60, 53), { 64, 50, 0.4, &CHART_SOCK } };
	int k, p;

	(void)state;
	for (k = 0; k < 2; k++) {
		Chart g = chart[k];

		if (k)
			sample_sockcap(g, 0.5, NULL, of->lambda, of->H);
		else
			sample_immersion(torus, g, 1, NULL, of->lambda, of->H);
		for (p = 0; p < g.nu*g.nv; p++) {
			x[p] = stencil_is_inner(g, p%g.nu, p/g.nu) ? 1 + sin(p*0.1) : 0;
			before[p] = log(of->lambda[p]);
			H[p] = pow(of->lambda[p], 2)*of->H[p];
		}
		assert_int_equal(cap_lower(g, x, of->lambda, of->H), 0);
		for (p = 0; p < g.nu*g.nv; p++) {
			after[p] = log(of->lambda[p]);
			assert_true(after[p] <= before[p] && fabs(pow(of->lambda[p], 2)*of->H[p] - H[p]) < 1e-12);
		}
		for (p = 0; p < g.nu*g.nv; p++) {
			const double *const f[3] = { before, after, after };
			double lap[3];

			if (!stencil_is_inner(g, p%g.nu, p/g.nu)) {
				assert_true(after[p] == before[p]);
				continue;
			}
			stencil_laplacian(g, f, p%g.nu, p/g.nu, lap);
			assert_true(fabs(lap[1] - lap[0] - x[p]/2) < 1e-8);
		}
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(weighted_sums),
		cmocka_unit_test(metrics_of_the_plane),
		cmocka_unit_test(metrics_of_a_sock),
		cmocka_unit_test(simple_blends),
		cmocka_unit_test(excess_of_spheres),
		cmocka_unit_test(lowered),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
