/* test_misfit.c - misfit.h: the energy, its gradient, and products with J'J, where J is the
 * Jacobian of the residuals. */
#include "cmock.h"

#include <omp.h>

#include "../lib/base/field.h"
#include "../lib/grid/lambdah.h"
#include "../lib/surface/misfit.h"
#include "charts.h"
#include "surfaces.h"

static Chart chart = { 34, 45, 0.8, &CHART_RECTANGLE };
enum { N = 34*45 };

static double phi[3*N], lambda[N], H[N], lambda2[N], l2H[N], nu[2][N], tau[2][N];
static double d[3*N], e[3*N], g[3*N], f[3*N], moved[3*N];
static Residue residue = { { nu[0], nu[1] }, { tau[0], tau[1] }, 1 };

/* Samples a torus patch, deformed by a wave so that it is neither symmetric nor conformal, and its
 * lambda, H and residues. */
static void
surface_of_size(double size)
{
	double *x[3] = { phi, phi + N, phi + 2*N }, *const nus[2] = { nu[0], nu[1] },
		*const taus[2] = { tau[0], tau[1] };
	int p;

	sample_immersion(torus, chart, size, x, NULL, NULL);
	for (p = 0; p < N; p++)
		phi[p] += size*0.05*sin(p%34*0.3)*cos(p/34*0.2 + 1);
	lambdah(chart, (const double *const *)x, LAMBDAH_NORMAL, lambda, H);
	lambdah_residue(chart, (const double *const *)x, lambda, nus, taus);
	for (p = 0; p < N; p++) {
		lambda2[p] = lambda[p]*lambda[p];
		l2H[p] = lambda2[p]*H[p];
	}
}

static int
inner(int p)
{
	return p%34 > 0 && p%34 < 33 && p/34%45 > 0 && p/34%45 < 44;
}

static int boundary_is_free;

static void
random_displacement(unsigned long long seed, double size, double *x)
{
	int p;

	for (p = 0; p < 3*N; p++)
		x[p] = boundary_is_free || inner(p%N) ? size*noise(&seed) : 0;
}

static Misfit
misfit_of(const Residue *r)
{
	Misfit m;

	assert_int_equal(misfit_init(&m, chart, lambda2, l2H, r), 0);
	m.w = 40;
	m.alpha = 0.6;
	if (boundary_is_free)
		misfit_set_free(&m);
	return m;
}

static double
energy_at(const Misfit *m, double t, const double *direction)
{
	memcpy(moved, phi, sizeof phi);
	field_add(3*N, t, direction, moved);
	return misfit_energy(m, moved);
}

/* On the surface from which lambda and H were computed, the energy is 0 with residue channels.
 * Without them the terms that measure how far the grid is from conformal remain. */
static void
energy_is_zero_at_the_surface(void **state)
{
	Misfit m;

	(void)state;
	surface_of_size(1);
	m = misfit_of(&residue);
	assert_true(misfit_energy(&m, phi) < 1e-18);
	misfit_free(&m);
	m = misfit_of(NULL);
	assert_true(misfit_energy(&m, phi) > 1);
	assert_true(misfit_scale_error(&m, phi) < 1e-14);
	misfit_free(&m);
}

/* With residues the area element is known, so each residual is a polynomial of degree 3 in phi, and E
 * is one of degree 6: its seventh differences are 0.  They are taken over multiples of phi, one of
 * which is 0, a surface without normals. */
static void
energy_with_residues_is_a_polynomial(void **state)
{
	static const int binomial[8] = { 1, -7, 21, -35, 35, -21, 7, -1 };
	double sum = 0, most = 0, E;
	Misfit m;
	int k;

	(void)state;
	surface_of_size(1);
	m = misfit_of(&residue);
	for (k = 0; k < 8; k++) {
		E = energy_at(&m, (k - 4)/4.0, phi);            /* at 0, 0.25, .., 1.75 times phi */
		sum += binomial[k]*E;
		most = fmax(most, fabs(binomial[k]*E));
	}
	assert_true(most > 1 && fabs(sum) < 1e-10*most);
	misfit_free(&m);
}

static void
gradient_is_the_derivative(void **state)
{
	double t = 1e-6, slope;
	Misfit m;
	int k;

	(void)state;
	surface_of_size(1);
	m = misfit_of(NULL);
	random_displacement(5, 0.001, e);               /* away from the surface */
	for (k = 0; k < 3*N; k++)
		phi[k] += e[k];
	misfit_gradient(&m, phi, g);
	for (k = 1; k < 5; k++) {
		random_displacement(10 + k, 1, d);
		slope = (energy_at(&m, t, d) - energy_at(&m, -t, d))/(2*t);
		assert_true(fabs(2*field_dot(3*N, g, d)/slope - 1) < 1e-5);
	}
	misfit_free(&m);
}

/* J'J is symmetric and, where the residuals are 0, it is the derivative of the gradient. */
static void
normal_matrix_is_that_of_the_gradient(void **state)
{
	double t = 1e-7, most = 0;
	Misfit m;
	int k;

	(void)state;
	surface_of_size(1);
	m = misfit_of(&residue);
	random_displacement(1, 1, d);
	random_displacement(2, 1, e);
	misfit_normal(&m, phi, d, f);
	misfit_normal(&m, phi, e, g);
	assert_true(fabs(field_dot(3*N, e, f)/field_dot(3*N, d, g) - 1) < 1e-12);
	assert_true(field_dot(3*N, d, f) > 0);
	memcpy(moved, phi, sizeof phi);
	field_add(3*N, t, d, moved);
	misfit_gradient(&m, moved, g);
	field_add(3*N, -2*t, d, moved);
	misfit_gradient(&m, moved, e);
	for (k = 0; k < 3*N; k++) {
		most = fabs(f[k]) > most ? fabs(f[k]) : most;
		g[k] = (g[k] - e[k])/(2*t);
	}
	assert_true(largest(3*N, f, g) < 1e-5*most);
	misfit_free(&m);
}

/* The gradient is also the derivative of the energy on charts with joined sides.  The residue channel
 * tau is included because it changes its sign across some joined sides. */
static void
gradient_beyond_joined_sides(void **state)
{
	double t = 1e-6, slope;
	Misfit m;
	int q, k;

	(void)state;
	boundary_is_free = 1;
	for (q = 1; q < 4; q++) {
		chart.kind = KINDS[q];
		surface_of_size(1);
		random_displacement(5, 0.001, e);
		for (k = 0; k < 3*N; k++)
			phi[k] += e[k];
		m = misfit_of(&residue);
		assert_int_equal(misfit_set_firm(&m, 0.05), 0);       /* matters on a chart with cones */
		misfit_gradient(&m, phi, g);
		for (k = 1; k < 5; k++) {
			random_displacement(10 + k, 1, d);
			slope = (energy_at(&m, t, d) - energy_at(&m, -t, d))/(2*t);
			assert_true(fabs(2*field_dot(3*N, g, d)/slope - 1) < 1e-5);
		}
		random_displacement(2, 1, e);
		misfit_normal(&m, phi, d, f);
		misfit_normal(&m, phi, e, g);
		assert_true(fabs(field_dot(3*N, e, f)/field_dot(3*N, d, g) - 1) < 1e-12);
		misfit_free(&m);
	}
	chart.kind = &CHART_RECTANGLE;
	boundary_is_free = 0;
}

/* How much E rises with an error of H at node (5,7): by its first line. */
static double
rise(Misfit *m)
{
	double before = misfit_energy(m, phi), H2 = m->l2H2[7*34 + 5], after;

	m->l2H2[7*34 + 5] = 2*H2;
	after = misfit_energy(m, phi);
	m->l2H2[7*34 + 5] = H2;
	return after - before;
}

/* misfit_set_firm multiplies the first two lines by 1 + (0.05/r)^2 on a sock, by 1 on the rectangle. */
static void
lines_are_firm_beside_cones(void **state)
{
	double plain, firm, u = 5.5/34, v = 7.5*0.8/44.5, want;
	Misfit m;
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		chart.kind = k ? &CHART_SOCK : &CHART_RECTANGLE;
		surface_of_size(1);
		m = misfit_of(&residue);
		plain = rise(&m);
		assert_int_equal(misfit_set_firm(&m, 0.05), 0);
		firm = rise(&m);
		want = k ? 1 + 0.0025/(u*u + v*v) : 1;
		assert_true(plain > 1e-6 && fabs(firm/plain - want) < 1e-6);
		misfit_free(&m);
	}
	chart.kind = &CHART_RECTANGLE;
}

/* The hold beyond that of all nodes falls by half with each ring, and the third line counts 1/100
 * (doc/mathematics.md 6.8).  At the nodes looked at the grid resolves the surface. */
static void
place_is_held_more_on_the_first_rings(void **state)
{
	int r, i = chart.nu/2;
	double more, next;
	Misfit m;

	(void)state;
	surface_of_size(1);
	m = misfit_of(NULL);
	assert_int_equal(misfit_hold(&m, &(MisfitPlace){ phi, 0.05 }), 0);
	assert_true(fabs(m.stretch - 0.01) < 1e-15);
	for (r = 1; r < 3; r++) {
		more = m.hold[r*chart.nu + i] - m.stiffness;
		next = m.hold[(r + 1)*chart.nu + i] - m.stiffness;
		assert_true(more > 0);
		assert_true(fabs(more/next - 2) < 1e-6);
	}
	misfit_free(&m);
}

/* With a place, on every kind of chart, the gradient is the derivative, J'J is symmetric, and both
 * gain kappa times the displacement: at inner nodes, positive, for no other reason than the place. */
static void
gradient_with_a_place(void **state)
{
	static double place[3*N], without[3*N];
	double t = 1e-6, slope;
	Misfit m;
	int q, k;

	(void)state;
	for (q = 0; q < 4; q++) {
		chart.kind = KINDS[q];
		boundary_is_free = q > 0;
		surface_of_size(1);
		random_displacement(5, 0.01, place);
		for (k = 0; k < 3*N; k++)
			place[k] += phi[k];
		m = misfit_of(NULL);
		random_displacement(10, 1, d);
		misfit_normal(&m, phi, d, without);
		assert_int_equal(misfit_hold(&m, &(MisfitPlace){ place, 0.05 }), 0);
		misfit_gradient(&m, phi, g);
		slope = (energy_at(&m, t, d) - energy_at(&m, -t, d))/(2*t);
		assert_true(fabs(2*field_dot(3*N, g, d)/slope - 1) < 1e-5);
		random_displacement(2, 1, e);
		misfit_normal(&m, phi, d, f);
		misfit_normal(&m, phi, e, g);
		assert_true(fabs(field_dot(3*N, e, f)/field_dot(3*N, d, g) - 1) < 1e-12);
		m.stretch = 1;
		misfit_normal(&m, phi, d, f);
		for (k = 0; k < 3*N; k++)
			assert_true(fabs(f[k] - without[k] - m.hold[k%N]*d[k]) < 1e-9*(1 + fabs(f[k])));
		assert_int_equal(misfit_hold(&m, NULL), 0);
		misfit_normal(&m, phi, d, f);
		assert_memory_equal(f, without, sizeof f);
		misfit_free(&m);
	}
	chart.kind = &CHART_RECTANGLE;
	boundary_is_free = 0;
}

/* The gradient is the derivative of the energy also if the border nodes are free. */
static void
free_gradient_is_the_derivative(void **state)
{
	boundary_is_free = 1;
	gradient_is_the_derivative(state);
	boundary_is_free = 0;
}

/* If the border nodes are free, J'J is symmetric and rigid motions are in its null space. */
static void
free_normal_matrix_is_symmetric(void **state)
{
	double most = 0, small = 0;
	Misfit m;
	int p;

	(void)state;
	surface_of_size(1);
	boundary_is_free = 1;
	m = misfit_of(NULL);
	random_displacement(1, 1, d);
	random_displacement(2, 1, e);
	misfit_normal(&m, phi, d, f);
	misfit_normal(&m, phi, e, g);
	assert_true(fabs(field_dot(3*N, e, f)/field_dot(3*N, d, g) - 1) < 1e-12);
	assert_true(field_dot(3*N, d, f) > 0);
	for (p = 0; p < 3*N; p++)
		most = fmax(most, fabs(f[p]));
	for (p = 0; p < N; p++) {               /* a rigid motion: (1,2,3) x phi + (4,5,6) */
		d[p] = 2*phi[2*N+p] - 3*phi[N+p] + 4;
		d[N+p] = 3*phi[p] - phi[2*N+p] + 5;
		d[2*N+p] = phi[N+p] - 2*phi[p] + 6;
	}
	misfit_normal(&m, phi, d, f);
	for (p = 0; p < 3*N; p++)
		small = fmax(small, fabs(f[p]));
	assert_true(small < 1e-9*most);
	misfit_free(&m);
	boundary_is_free = 0;
}

/* If the border is free, each border node has a term of its own in the energy.  It is 0 if the metric
 * at the node is lambda^2. */
static void
free_border_has_its_energy(void **state)
{
	double held, all;
	Misfit m;
	int p;

	(void)state;
	sample_immersion(plane, chart, 1, (double *[3]){ phi, phi + N, phi + 2*N }, lambda, H);
	for (p = 0; p < N; p++) {
		lambda2[p] = lambda[p]*lambda[p];
		l2H[p] = 0;
	}
	boundary_is_free = 1;
	m = misfit_of(NULL);
	assert_true(misfit_energy(&m, phi) < 1e-18);
	for (p = 0; p < N; p++) {
		if (inner(p))
			continue;
		m.lambda2[p] *= 1.5;
		m.free = 0;
		held = misfit_energy(&m, phi);
		m.free = 1;
		all = misfit_energy(&m, phi);
		assert_true(held < 1e-18 && all > 1e-3);
		assert_int_equal(misfit_worst(&m, phi), p);
		m.lambda2[p] /= 1.5;
	}
	misfit_free(&m);
	boundary_is_free = 0;
}

static void
energy_has_no_unit_of_length(void **state)
{
	double E[2];
	Misfit m;
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		surface_of_size(k ? 1000 : 1);
		random_displacement(3, k ? 1 : 0.001, d);
		m = misfit_of(NULL);
		E[k] = energy_at(&m, 1, d);
		misfit_free(&m);
	}
	assert_true(fabs(E[1]/E[0] - 1) < 1e-9);
}

/* A node where lambda is tiny or H huge has a weight of almost 0, so the energy stays small. */
static void
nodes_without_weight_do_no_harm(void **state)
{
	double E, clean;
	Misfit m;

	(void)state;
	surface_of_size(1);
	random_displacement(3, 0.001, d);
	m = misfit_of(NULL);
	clean = energy_at(&m, 1, d);
	misfit_free(&m);
	lambda2[20*34+15] *= 1e-6;
	l2H[30*34+9] = 1e9;
	m = misfit_of(NULL);
	E = energy_at(&m, 1, d);
	misfit_free(&m);
	assert_true(E < 2*clean);
}

static void
threads_change_no_bit(void **state)
{
	int threads = omp_get_max_threads();
	double E[2];
	Misfit m;

	(void)state;
	surface_of_size(1);
	random_displacement(3, 0.001, d);
	omp_set_num_threads(1);
	m = misfit_of(NULL);
	E[0] = energy_at(&m, 1, d);
	misfit_normal(&m, phi, d, f);
	omp_set_num_threads(4);
	E[1] = energy_at(&m, 1, d);
	misfit_normal(&m, phi, d, g);
	misfit_free(&m);
	omp_set_num_threads(threads);
	assert_memory_equal(&E[0], &E[1], sizeof E[0]);
	assert_memory_equal(f, g, sizeof f);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(energy_is_zero_at_the_surface),
		cmocka_unit_test(energy_with_residues_is_a_polynomial),
		cmocka_unit_test(gradient_is_the_derivative),
		cmocka_unit_test(normal_matrix_is_that_of_the_gradient),
		cmocka_unit_test(gradient_beyond_joined_sides),
		cmocka_unit_test(lines_are_firm_beside_cones),
		cmocka_unit_test(place_is_held_more_on_the_first_rings),
		cmocka_unit_test(gradient_with_a_place),
		cmocka_unit_test(free_gradient_is_the_derivative),
		cmocka_unit_test(free_normal_matrix_is_symmetric),
		cmocka_unit_test(free_border_has_its_energy),
		cmocka_unit_test(energy_has_no_unit_of_length),
		cmocka_unit_test(nodes_without_weight_do_no_harm),
		cmocka_unit_test(threads_change_no_bit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
