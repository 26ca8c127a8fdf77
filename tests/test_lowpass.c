/* test_lowpass.c - multigrid and the filters in the metric of a surface, against dense matrices and
 * waves that they must multiply by known numbers, on all charts. */
#include "cmock.h"

#include "../lib/scales/borderpart.h"
#include "../lib/scales/relief.h"
#include "charts.h"
#include "surfaces.h"

enum { NU = 10, NV = 7, N = NU*NV };
static const double ACCURATE = 1e-4;    /* the tolerance of the systems is 1e-6, in energy */

static int
on_open_side(Chart g, int axis, int i)
{
	const int *joined = g.kind->joined[axis];

	return (i == 0 && !joined[0]) || (i == (axis ? g.nv : g.nu) - 1 && !joined[1]);
}

/* Whether the field is held at node p. */
static int
is_held(Chart g, int held, int p)
{
	return held && (on_open_side(g, 0, p%g.nu) || on_open_side(g, 1, p/g.nu));
}

/* K and M by their definition: K x = sum over the neighbours q of p of w (x_p - x_q), with half the
 * weight for edges along a free side; M is the density times the area of the cell. */
static void
dense(Chart g, int held, const double *density, double *K, double *M)
{
	const double h = chart_h(g), k = chart_k(g);
	int n = g.nu*g.nv, p, q, a, way, at[2];
	double w;

	memset(K, 0, n*n*sizeof *K);
	for (p = 0; p < n; p++) {
		int u = on_open_side(g, 0, p%g.nu), v = on_open_side(g, 1, p/g.nu);

		M[p] = is_held(g, held, p) ? 0 : density[p]*h*k*(u ? 0.5 : 1)*(v ? 0.5 : 1);
		for (way = 0; way < 4 && !is_held(g, held, p); way++) {
			a = way/2;
			at[0] = p%g.nu;
			at[1] = p/g.nu;
			if (on_open_side(g, a, at[a]) && (way%2 ? at[a] > 0 : at[a] == 0))
				continue;
			at[a] += way%2 ? 1 : -1;
			if (at[a] < 0 || at[a] >= (a ? g.nv : g.nu))
				g.kind->beyond(g, &at[0], &at[1]);
			q = at[1]*g.nu + at[0];
			w = (a ? h/k : k/h)*((a ? u : v) && !held ? 0.5 : 1);
			K[p*n+p] += w;
			if (!is_held(g, held, q))
				K[p*n+q] -= w;
		}
	}
}

/* Solves A x = b by elimination; both are overwritten, b by x.  Rows of zeros give 0. */
static void
eliminate(int n, double *A, double *b)
{
	int p, q, r;

	for (p = 0; p < n; p++)
		for (q = 0; q < n; q++)
			if (q != p && A[p*n+p] != 0 && A[q*n+p] != 0) {
				double t = A[q*n+p]/A[p*n+p];

				for (r = p; r < n; r++)
					A[q*n+r] -= t*A[p*n+r];
				b[q] -= t*b[p];
			}
	for (p = 0; p < n; p++)
		b[p] = A[p*n+p] != 0 ? b[p]/A[p*n+p] : 0;
}

static void
random_lambda(int n, unsigned long long seed, double *lambda)
{
	int p;

	for (p = 0; p < n; p++)
		lambda[p] = exp(1.5*noise(&seed));
}

static void
random_field(Chart g, int held, unsigned long long seed, double *f)
{
	int p;

	for (p = 0; p < g.nu*g.nv; p++)
		f[p] = is_held(g, held, p) ? 0 : noise(&seed);
}

static double
largest_of(int n, const double *f)
{
	double most = 0;
	int p;

	for (p = 0; p < n; p++)
		most = fmax(most, fabs(f[p]));
	return most;
}

static double
inner(int n, const double *x, const double *y)
{
	double sum = 0;
	int p;

	for (p = 0; p < n; p++)
		sum += x[p]*y[p];
	return sum;
}

/* (M + s^6 K M^-1 K M^-1 K) f~ = M f, by dense matrices. */
static void
dense_lowpass(Chart g, int held, const double *lambda, double s, double *f)
{
	int n = g.nu*g.nv, p, q, r, times;
	double *K = malloc(n*n*sizeof *K), *A = malloc(n*n*sizeof *A), *B = malloc(n*n*sizeof *B), M[N], density[N];

	assert_true(K && A && B);
	for (p = 0; p < n; p++)
		density[p] = lambda[p]*lambda[p];
	dense(g, held, density, K, M);
	memcpy(A, K, n*n*sizeof *K);
	for (times = 0; times < 2; times++) {
		for (p = 0; p < n; p++)
			for (q = 0; q < n; q++)
				for (B[p*n+q] = r = 0; r < n; r++)
					B[p*n+q] += M[r] > 0 ? K[p*n+r]*A[r*n+q]/M[r] : 0;
		memcpy(A, B, n*n*sizeof *A);
	}
	for (p = 0; p < n; p++) {
		for (q = 0; q < n; q++)
			A[p*n+q] = pow(s, 6)*A[p*n+q] + (p == q ? M[p] : 0);
		f[p] *= M[p];
	}
	eliminate(n, A, f);
	free(K);
	free(A);
	free(B);
}

static void
cycle_is_symmetric_and_near_the_inverse(void **state)
{
	static const int sizes[][2] = { { 10, 7 }, { 33, 18 }, { 4, 40 }, { 33, 34 } };
	double density[1200], x[1200], y[1200], Vx[1200], Vy[1200], Ax[1200], VAx[1200], energy;
	int t, k, held;

	(void)state;
	for (t = 0; t < 4*4*2*3; t++) {
		Chart g = { sizes[t%4][0], sizes[t%4][1], 0.7, KINDS[t/4%4] };
		int n = g.nu*g.nv, p;
		Multigrid m;

		held = t/16%2;
		random_lambda(n, t, density);
		assert_int_equal(multigrid_init(&m, g, held, density), 0);
		multigrid_set(&m, (double[]){ 1e-5, 1e-2, 10 }[t/32]);
		random_field(g, held, 5, x);
		random_field(g, held, 6, y);
		multigrid_cycle(&m, x, Vx);
		multigrid_cycle(&m, y, Vy);
		assert_true(fabs(inner(n, Vx, y) - inner(n, x, Vy)) < 1e-12*inner(n, Vx, x));

		/* V A is near 1 in the norm of A */
		for (k = 0; k < 3; k++) {
			multigrid_stiffness(&m, x, Ax);
			for (p = 0; p < n; p++)
				Ax[p] = m.t*Ax[p] + m.mass[p]*x[p];
			energy = inner(n, x, Ax);
			multigrid_cycle(&m, Ax, VAx);
			assert_in_range(1e6*inner(n, VAx, Ax)/energy, 700000, 1001000);
			for (p = 0; p < n; p++)         /* the component on which V A does worst grows */
				x[p] -= VAx[p];
		}
		multigrid_free(&m);
	}
}

static void
stiffness_is_that_of_the_chart(void **state)
{
	double density[N], K[N*N], M[N], x[N], y[N], Kx;
	int t, p;

	(void)state;
	for (t = 0; t < 8; t++) {
		Chart g = { NU, NV, 0.7, KINDS[t/2] };
		Multigrid m;

		random_lambda(N, t, density);
		dense(g, t%2, density, K, M);
		random_field(g, t%2, 3, x);
		assert_int_equal(multigrid_init(&m, g, t%2, density), 0);
		multigrid_stiffness(&m, x, y);
		for (p = 0; p < N; p++) {
			Kx = inner(N, K + p*N, x);
			assert_true(fabs(y[p] - Kx) < 1e-13);
			assert_true(fabs(m.mass[p] - M[p]) < 1e-15);
		}
		multigrid_free(&m);
	}
}

static void
lowpass_is_the_dense_solution(void **state)
{
	double lambda[N], f[N], exact[N], most;
	int t;

	(void)state;
	for (t = 0; t < 4*2*3; t++) {
		Chart g = { NU, NV, 0.7, KINDS[t%4] };
		int held = t/4%2;
		double s = (double[]){ 0.02, 0.2, 3 }[t/8];
		Lowpass l;

		random_lambda(N, t, lambda);
		random_field(g, held, t + 1, f);
		memcpy(exact, f, sizeof f);
		most = largest_of(N, f);
		dense_lowpass(g, held, lambda, s, exact);
		assert_int_equal(lowpass_init(&l, g, held, lambda), 0);
		lowpass(&l, s, f);
		assert_true(largest(N, f, exact) < ACCURATE*most);
		lowpass_free(&l);
	}
}

/* On a flat rectangle of size c, 1 + cos cos with free sides and sin sin with held ones are multiplied
 * by 1 and by 1/(1 + (s k)^6), with the wave number k of the differences. */
static void
wave_has_its_factor(void **state)
{
	const Chart g = { 41, 29, 0.6, &CHART_RECTANGLE };
	const double h = chart_h(g), k = chart_k(g), c = 250, s = 9;
	double lambda[41*29], f[41*29], wave[41*29], k2, factor;
	int held, m = 7, n = 4, p;
	Lowpass l;

	(void)state;
	k2 = ((2 - 2*cos(M_PI*m*h))/(h*h) + (2 - 2*cos(M_PI*n*k/g.T))/(k*k))/(c*c);
	factor = 1/(1 + pow(s*s*k2, 3));
	assert_true(factor > 0.2 && factor < 0.8);
	for (held = 0; held < 2; held++) {
		for (p = 0; p < g.nu*g.nv; p++) {
			double x = M_PI*m*h*(p%g.nu), y = M_PI*n*k/g.T*(p/g.nu);

			lambda[p] = c;
			wave[p] = held ? sin(x)*sin(y) : cos(x)*cos(y);
			f[p] = wave[p] + !held;
		}
		assert_int_equal(lowpass_init(&l, g, held, lambda), 0);
		assert_true(held || fabs(lowpass_root_area(&l) - c*sqrt(g.T)) < 1e-9);
		lowpass(&l, s, f);
		for (p = 0; p < g.nu*g.nv; p++)
			assert_true(fabs(f[p] - factor*wave[p] - !held) < ACCURATE);
		lowpass_heat(&l, s, f);
		for (p = 0; p < g.nu*g.nv; p++)
			assert_true(fabs(f[p] - factor*wave[p]/(1 + s*s*k2/2) - !held) < ACCURATE);
		lowpass_free(&l);
	}
}

/* The result belongs to the surface: not to the unit of length, nor to the order of u and v. */
static void
same_for_a_scaled_and_a_transposed_grid(void **state)
{
	const Chart g = { 22, 15, 0.7, &CHART_RECTANGLE }, turned = { 15, 22, 1/0.7, &CHART_RECTANGLE };
	double lambda[330], f[330], other[330], back[330];
	int held, p;
	Lowpass l;

	(void)state;
	for (held = 0; held < 2; held++) {
		random_lambda(330, 3, lambda);
		random_field(g, held, 4, f);
		assert_int_equal(lowpass_init(&l, g, held, lambda), 0);
		memcpy(other, f, sizeof f);
		lowpass(&l, 0.1, f);
		lowpass_free(&l);

		/* u and v exchanged, v backwards; 1e40 times as large */
		for (p = 0; p < 330; p++)
			back[p%22*15 + 14 - p/22] = other[p];
		random_lambda(330, 3, lambda);
		for (p = 0; p < 330; p++)
			other[p%22*15 + 14 - p/22] = lambda[p]*0.7e40;
		assert_int_equal(lowpass_init(&l, turned, held, other), 0);
		lowpass(&l, 0.1e40, back);
		lowpass_free(&l);
		for (p = 0; p < 330; p++)
			assert_true(fabs(back[p%22*15 + 14 - p/22] - f[p]) < ACCURATE);
	}
}

/* Cubics that are harmonic for the differences too. */
static void
border_part_is_harmonic(void **state)
{
	const Chart g = { 13, 8, 0.7, &CHART_RECTANGLE };
	double f[3][104], h[3][104], exact[3][104];
	int p, c;

	(void)state;
	for (p = 0; p < 104; p++) {
		double u = p%13*chart_h(g), v = p/13*chart_k(g);

		exact[0][p] = u*u - v*v + 1e6;
		exact[1][p] = u*u*u - 3*u*v*v;
		exact[2][p] = u*v;
		for (c = 0; c < 3; c++)
			f[c][p] = exact[c][p] + (is_held(g, 1, p) ? 0 : 5 + p%7);
	}
	assert_int_equal(border_part(g, 3, (const double *const[]){ f[0], f[1], f[2] },
	    (double *const[]){ h[0], h[1], h[2] }), 0);
	for (c = 0; c < 3; c++)
		assert_true(largest(104, h[c], exact[c]) < (c ? 1e-13 : 1e-8));
}

/* On a flat square of side 1, waves .001 and .01 high: a threshold of .001 for their root mean square
 * removes the first, and keeps at least four fifths of the second. */
static void
relief_keeps_what_is_high(void **state)
{
	enum { SIDE = 65, ALL = SIDE*SIDE };
	const Chart g = { SIDE, SIDE, 1, &CHART_RECTANGLE };
	double *f = malloc(6*ALL*sizeof *f), *H = f + ALL, *place[3] = { H + ALL, H + 2*ALL, H + 3*ALL }, *z = H + 4*ALL;
	double u, high, low = 0, lost = 0;
	Lowpass free_sides, held;
	int p;

	(void)state;
	for (p = 0; p < ALL; p++) {
		u = p%SIDE*chart_h(g);
		high = u < 0.5 ? 0.001 : 0.01;
		f[p] = 1;
		z[p] = place[2][p] = is_held(g, 1, p) ? 0 : high*sin(20*M_PI*u)*sin(20*M_PI*(p/SIDE)*chart_k(g));
		place[0][p] = place[1][p] = 0;
		H[p] = z[p];
	}
	assert_int_equal(lowpass_init(&free_sides, g, 0, f), 0);
	assert_int_equal(lowpass_init(&held, g, 1, f), 0);
	assert_int_equal(relief(&free_sides, &held, 0.0025, 0.001, H, place), 0);
	for (p = 0; p < ALL; p++) {
		u = p%SIDE*chart_h(g);
		if (u > 0.1 && u < 0.35)
			low = fmax(low, fabs(place[2][p]));
		if (u > 0.65 && u < 0.9)
			lost = fmax(lost, fabs(place[2][p] - z[p]));
	}
	assert_true(low < 0.00001);
	assert_true(lost < 0.002);
	lowpass_free(&free_sides);
	lowpass_free(&held);
	free(f);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(stiffness_is_that_of_the_chart),
		cmocka_unit_test(cycle_is_symmetric_and_near_the_inverse),
		cmocka_unit_test(lowpass_is_the_dense_solution),
		cmocka_unit_test(wave_has_its_factor),
		cmocka_unit_test(same_for_a_scaled_and_a_transposed_grid),
		cmocka_unit_test(border_part_is_harmonic),
		cmocka_unit_test(relief_keeps_what_is_high),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
