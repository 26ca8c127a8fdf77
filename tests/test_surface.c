/* test_surface.c - surface.h: the surface method reconstructs the surface from its lambda and H. */
#include "cmock.h"

#include <omp.h>

#include "../lib/grid/lambdah.h"
#include "../lib/base/procrustes.h"
#include "../lib/surface/surface.h"
#include "surfaces.h"

static const Chart ROUGH = { 25, 24, 0.8, &CHART_RECTANGLE }, MIDDLE = { 49, 47, 0.8, &CHART_RECTANGLE }, COARSE = { 70, 67, 0.8, &CHART_RECTANGLE }, FINE = { 139, 133, 0.8, &CHART_RECTANGLE }, LATTICE = { 12, 10, 0.8, &CHART_RECTANGLE };
enum { MOST = 139*133 };

static double truth[3*MOST], found[3*MOST], kept[3*MOST], lambda[MOST], H[MOST], start[3*12*10],
	fine_start[3*70*67];
static double again[3*MOST];
static double nu[2][MOST], tau[2][MOST];
static const FitOptions EXACT = { .tolerance = 1e-10, .most = 60, .sharpen = 1 };

static void
sample(Immersion *f, Chart g, double *phi)
{
	double *x[3] = { phi, phi + (size_t)g.nu*g.nv, phi + 2*(size_t)g.nu*g.nv };

	sample_immersion(f, g, 1, x, NULL, NULL);
}

/* The input of the method for a known surface: lambda, H, residue channels and the coarse lattice
 * of positions from which the method starts. */
static Surface
given(Immersion *f, Chart g)
{
	size_t n = (size_t)g.nu*g.nv;
	const double *phi[3] = { truth, truth + n, truth + 2*n };
	double *const nus[2] = { nu[0], nu[1] }, *const taus[2] = { tau[0], tau[1] };

	sample(f, g, truth);
	sample(f, LATTICE, start);
	lambdah(g, phi, LAMBDAH_NORMAL, lambda, H);
	lambdah_residue(g, phi, lambda, nus, taus);
	return (Surface){ .g = g, .lambda = lambda, .H = H, .start_chart = LATTICE, .start_end = { 1, 1 },
		.start = start };
}

/* Reconstructs the surface from the given fields and the outermost `rings` rings of nodes.  Returns
 * the largest difference from the exact surface. */
static double
reconstruct(const Surface *s, int rings, const FitOptions *o)
{
	int n = s->g.nu*s->g.nv, p, i, j;
	FitProgress at;

	for (p = 0; p < 3*n; p++) {
		i = p%n%s->g.nu;
		j = p%n/s->g.nu;
		found[p] = i < rings || j < rings || i >= s->g.nu - rings || j >= s->g.nv - rings ? truth[p] : NAN;
	}
	assert_int_equal(surface(s, o, found, &at), 1);
	return largest(3*n, found, truth);
}

static void
surfaces_come_back(void **state)
{
	Immersion *const of[] = { stereo, cylinder, catenoid, enneper, torus, plane };
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 6; k++) {
		s = given(of[k], COARSE);
		assert_true(reconstruct(&s, 1, &EXACT) < 3e-4);
	}
}

/* The error is of second order, since it comes only from replacing derivatives by differences. */
static void
error_is_of_second_order(void **state)
{
	Immersion *const of[] = { stereo, enneper, torus };
	double coarse;
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 3; k++) {
		s = given(of[k], COARSE);
		coarse = reconstruct(&s, 1, &EXACT);
		s = given(of[k], FINE);
		assert_true(reconstruct(&s, 1, &EXACT) < coarse/3.5);
	}
}

static void
residue_gives_the_surface_itself(void **state)
{
	const Residue residue = { { nu[0], nu[1] }, { tau[0], tau[1] }, 1 };
	Surface s = given(enneper, COARSE);

	(void)state;
	s.residue = &residue;
	assert_true(reconstruct(&s, 1, &EXACT) < 1e-9);
	s.exact = 1;
	assert_true(reconstruct(&s, 1, &EXACT) < 1e-9);
}

/* The start only selects one of several solutions.  The result is the same if the start is disturbed,
 * if it is given on the full grid, and if a band of three rings of nodes is given and no start. */
static void
start_does_not_change_the_result(void **state)
{
	Surface s = given(torus, COARSE);
	size_t n = 3*(size_t)COARSE.nu*COARSE.nv;
	unsigned long long seed = 5;
	int k;

	(void)state;
	reconstruct(&s, 1, &EXACT);
	memcpy(kept, found, n*sizeof *found);
	for (k = 0; k < 3*12*10; k++)
		start[k] += 0.05*noise(&seed);
	reconstruct(&s, 1, &EXACT);
	assert_true(largest(n, kept, found) < 1e-7);
	memcpy(fine_start, truth, n*sizeof *truth);
	s.start = fine_start;
	s.start_chart = COARSE;
	reconstruct(&s, 1, &EXACT);
	assert_true(largest(n, kept, found) < 1e-7);
	s.start = NULL;
	reconstruct(&s, 3, &EXACT);
	assert_true(largest(n, kept, found) < 1e-7);
}

/* If all lengths are multiplied by a power of two, the result is multiplied by it exactly: its
 * mantissas do not change. */
static void
unit_of_length_changes_nothing(void **state)
{
	static const int power[] = { 3, 900, -900 };
	size_t n = (size_t)COARSE.nu*COARSE.nv, p;
	Surface s = given(torus, COARSE);
	int k;

	(void)state;
	reconstruct(&s, 1, &EXACT);
	memcpy(kept, found, 3*n*sizeof *found);
	for (k = 0; k < 3; k++) {
		double unit = ldexp(1, power[k]);

		s = given(torus, COARSE);
		for (p = 0; p < 3*n; p++)
			truth[p] *= unit;
		for (p = 0; p < n; p++) {
			lambda[p] *= unit;
			H[p] /= unit;
		}
		for (p = 0; p < 3*12*10; p++)
			start[p] *= unit;
		reconstruct(&s, 1, &EXACT);
		for (p = 0; p < 3*n; p++)
			assert_true(found[p] == kept[p]*unit);
	}
}

static void
threads_change_no_bit(void **state)
{
	Surface s = given(enneper, COARSE);
	size_t n = 3*(size_t)COARSE.nu*COARSE.nv;
	int threads = omp_get_max_threads();

	(void)state;
	omp_set_num_threads(1);
	reconstruct(&s, 1, &EXACT);
	memcpy(kept, found, n*sizeof *found);
	omp_set_num_threads(3);
	reconstruct(&s, 1, &EXACT);
	omp_set_num_threads(threads);
	assert_memory_equal(kept, found, n*sizeof *found);
}

static const FitOptions PATIENT = { .tolerance = 1e-8, .most = 200, .sharpen = 1 };

/* Inversion in a sphere.  It maps Enneper's surface to a surface whose coordinates are conformal too
 * and whose H varies.  Enneper's surface itself does not suit a test with a free boundary, because its
 * associate surfaces have the same lambda and H.  Nor does a sphere suit it: it can be bent to first
 * order without a change of lambda and H. */
static Node
inverted(Node a)
{
	double x = a.x[0] - 0.3, y = a.x[1] + 0.4, z = a.x[2] - 2, r = x*x + y*y + z*z;

	return (Node){ { 4*x/r, 4*y/r, 4*z/r }, 0, 0 };
}

static Node
inverted_enneper(double u, double v)
{
	return inverted(enneper(u, v));
}

/* Reconstructs with a free boundary.  The outermost `rings` rings of nodes or, if rings is 0, the
 * start determine where the surface lies.  Returns the largest difference from the exact surface
 * after the best rigid motion. */
static double
reconstruct_free(Surface *s, int rings)
{
	size_t n = (size_t)s->g.nu*s->g.nv, p;
	double (*a)[3] = malloc(n*sizeof *a), (*b)[3] = malloc(n*sizeof *b), rms, error;
	Rigid r;
	int c;

	s->free = 1;
	s->adrift = !rings;
	assert_non_null(a);
	assert_non_null(b);
	reconstruct(s, rings, &PATIENT);
	for (p = 0; p < n; p++)
		for (c = 0; c < 3; c++) {
			a[p][c] = truth[c*n+p];
			b[p][c] = found[c*n+p];
		}
	assert_int_equal(procrustes((int)n, NULL, a[0], b[0], &r, &rms), 0);
	rigid_move(&r, (int)n, b[0]);
	error = largest(3*n, a[0], b[0]);
	free(a);
	free(b);
	return error;
}

/* With a free boundary the error is of second order too, on a surface that cannot be bent without
 * changing lambda or H. */
static void
free_surfaces_come_back_of_second_order(void **state)
{
	double coarse, fine;
	Surface s;

	(void)state;
	s = given(inverted_enneper, ROUGH);
	coarse = reconstruct_free(&s, 1);
	s = given(inverted_enneper, MIDDLE);
	fine = reconstruct_free(&s, 1);
	assert_true(coarse < 0.05 && fine < coarse/3);
}

static void
turn(size_t n, double *x)
{
	static const double R[3][3] = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } };
	static const double t[3] = { 3, -5, 2 };
	size_t p;
	int c;

	for (p = 0; p < n; p++) {
		double y[3] = { x[p], x[n+p], x[2*n+p] };

		for (c = 0; c < 3; c++)
			x[c*n+p] = R[c][0]*y[0] + R[c][1]*y[1] + R[c][2]*y[2] + t[c];
	}
}

/* The band determines where a surface with a free boundary lies; without a band the start does.  A
 * rigid motion of the band, or of the start without a band, moves the surface too.  A motion of the
 * start changes nothing if there is a band. */
static void
free_surface_moves_with_its_band_or_start(void **state)
{
	size_t n = (size_t)ROUGH.nu*ROUGH.nv;
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 3; k++) {               /* what moves: 0: the start; 1: the band; 2: the start,
	                                         * without a band */
		s = given(torus, ROUGH);
		if (k != 1)
			reconstruct_free(&s, k < 2);
		memcpy(kept, found, 3*n*sizeof *found);
		if (k != 1)
			turn(12*10, start);
		if (k > 0)
			turn(n, truth);
		if (k > 0)
			turn(n, kept);
		reconstruct_free(&s, k < 2);
		assert_true(largest(3*n, kept, found) < 1e-4);
	}
}

/* With three rings of nodes and no start, a free boundary gives the same surface as with a
 * start. */
static void
free_surface_starts_from_its_band(void **state)
{
	size_t n = (size_t)ROUGH.nu*ROUGH.nv;
	Surface s = given(torus, MIDDLE);

	(void)state;
	reconstruct_free(&s, 1);
	memcpy(kept, found, 3*n*sizeof *found);
	s.start = NULL;
	reconstruct_free(&s, 3);
	assert_true(largest(3*n, kept, found) < 1e-4);
}

static void
small_grids_with_free_boundary_are_solved(void **state)
{
	static const Chart charts[] = { { 3, 3, 1, &CHART_RECTANGLE }, { 4, 9, 2, &CHART_RECTANGLE } };
	FitProgress at;
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 2; k++) {
		sample(stereo, charts[k], truth);
		sample_immersion(stereo, charts[k], 1, NULL, lambda, H);
		sample(stereo, LATTICE, start);
		s = (Surface){ .g = charts[k], .lambda = lambda, .H = H, .start_chart = LATTICE,
		    .start_end = { 1, 1 }, .start = start, .free = 1, .adrift = 1 };
		assert_int_equal(surface(&s, &PATIENT, found, &at), 1);
		assert_true(largest(3*(size_t)charts[k].nu*charts[k].nv, truth, found) < 1);
	}
}

static void
small_grids_are_solved(void **state)
{
	const FitOptions usual = { .tolerance = 1e-6, .most = 60, .sharpen = 1 };
	static const Chart charts[] = { { 2, 2, 1, &CHART_RECTANGLE }, { 3, 3, 1, &CHART_RECTANGLE },
		{ 4, 9, 2, &CHART_RECTANGLE } };
	FitProgress at;
	Surface s;
	int k;

	(void)state;
	for (k = 0; k < 3; k++) {
		sample(stereo, charts[k], truth);
		sample_immersion(stereo, charts[k], 1, NULL, lambda, H);
		sample(stereo, LATTICE, start);
		s = (Surface){ .g = charts[k], .lambda = lambda, .H = H, .start_chart = LATTICE,
		    .start_end = { 1, 1 }, .start = start };
		memcpy(found, truth, sizeof truth);
		s.detail = again;
		again[0] = NAN;
		assert_int_equal(surface(&s, &usual, found, &at), 1);
		assert_true(isfinite(again[0]));
	}
}

static Misfit
misfit_of(const Surface *s)
{
	static double lambda2[MOST], l2H[MOST];
	Misfit m;
	int p;

	for (p = 0; p < s->g.nu*s->g.nv; p++) {
		lambda2[p] = lambda[p]*lambda[p];
		l2H[p] = lambda2[p]*H[p];
	}
	assert_int_equal(misfit_init(&m, s->g, lambda2, l2H, NULL), 0);
	return m;
}

/* The weights of fit.h are sharp after the first step if the metric of the start is close to
 * lambda^2, even if E still decreases fast.  They are not sharp if that metric is far off. */
static void
weights_are_sharp_once_the_metric_fits(void **state)
{
	const FitOptions one = { .tolerance = 1e-10, .most = 1, .sharpen = 1 };
	unsigned long long seed = 2;
	FitProgress at;
	Surface s;
	Misfit m;
	int far, p;

	(void)state;
	for (far = 0; far < 2; far++) {
		s = given(torus, COARSE);
		m = misfit_of(&s);
		for (p = 0; p < 3*COARSE.nu*COARSE.nv; p++)
			truth[p] = (far ? 2 : 1)*truth[p] + 2e-4*noise(&seed);
		assert_int_equal(fit(&m, &one, truth, &at), 0);
		assert_true(fabs(m.w*sqrt(COARSE.T)/(far ? 30 : 100) - 1) < 1e-15 && m.alpha == (far ? 1 : 0.1));
		misfit_free(&m);
	}
}

/* If the detail that the finest grid adds to the coarser grids is given, the method needs hardly
 * any step. */
static void
known_detail_needs_hardly_a_step(void **state)
{
	static double detail[3*MOST];
	Surface s = given(torus, FINE);
	size_t n = 3*(size_t)FINE.nu*FINE.nv;
	FitProgress at;
	double size = 0;
	size_t p;

	(void)state;
	for (p = 0; p < 3*12*10; p++)
		start[p] *= 1024;
	for (p = 0; p < n; p++)
		truth[p] *= 1024;
	for (p = 0; p < n/3; p++) {
		lambda[p] *= 1024;
		H[p] /= 1024;
	}
	s.detail = detail;
	reconstruct(&s, 1, &EXACT);
	memcpy(kept, found, n*sizeof *found);
	for (p = 0; p < n; p++)
		size = fmax(size, fabs(detail[p]));
	assert_true(size > 1e-2);
	s.forecast = detail;
	s.detail = again;
	memcpy(found, truth, n*sizeof *found);
	assert_int_equal(surface(&s, &EXACT, found, &at), 1);
	assert_true(at.step <= 2);
	assert_true(largest(n, kept, found) < 1e-4 && largest(n, detail, again) < 1e-4);
}

typedef struct Falls {
	double E;
	int    steps, fell;
} Falls;

static void
count_falls(void *ctx, const FitProgress *at)
{
	Falls *f = ctx;

	f->fell += at->energy < f->E;
	f->steps++;
	f->E = at->energy;
}

/* From a start so rough that full steps overshoot, the steps are shortened, so that each of them
 * lowers E. */
static void
steps_that_overshoot_are_shortened(void **state)
{
	Falls f = { HUGE_VAL, 0, 0 };
	FitOptions eight = { .tolerance = 1e-10, .most = 8, .report = count_falls, .ctx = &f };
	Surface s = given(torus, COARSE);
	Misfit m = misfit_of(&s);
	unsigned long long seed = 3;
	FitProgress at;
	int p, n = COARSE.nu*COARSE.nv;

	(void)state;
	for (p = 0; p < 3*n; p++)
		if (p%n%COARSE.nu%69 && p%n/COARSE.nu%66)
			truth[p] += 0.05*noise(&seed);
	fit(&m, &eight, truth, &at);
	assert_int_equal(f.steps, 8);
	assert_int_equal(f.fell, 8);
	misfit_free(&m);
}

/* lambda and H of a torus, and a place that differs from it by a long wave and by a short one, eight
 * times as long as a cell and shorter than the scale: the result has the first and hardly the second. */
static void
place_holds_long_waves(void **state)
{
	static double place[3*MOST];
	Surface s = given(torus, FINE);
	size_t n = (size_t)FINE.nu*FINE.nv, p;
	double is[2] = { 0, 0 }, all[2] = { 0, 0 }, wave[2], window;
	int c;

	(void)state;
	for (p = 0; p < n; p++) {
		double u = p%FINE.nu*chart_h(FINE), v = p/FINE.nu*chart_k(FINE)/FINE.T;

		window = sin(M_PI*u)*sin(M_PI*v);
		for (c = 0; c < 3; c++)
			place[c*n+p] = truth[c*n+p] + (c == 2)*(1e-3*window + 1e-4*window*sin(2*M_PI*u/(4*chart_h(FINE))));
	}
	s.place = &(MisfitPlace){ place, 0.1 };
	reconstruct(&s, 1, &EXACT);
	for (p = 0; p < n; p++) {
		double u = p%FINE.nu*chart_h(FINE), v = p/FINE.nu*chart_k(FINE)/FINE.T;

		wave[0] = sin(M_PI*u)*sin(M_PI*v);
		wave[1] = wave[0]*sin(2*M_PI*u/(4*chart_h(FINE)));
		for (c = 0; c < 2; c++) {
			is[c] += wave[c]*(found[2*n+p] - truth[2*n+p]);
			all[c] += wave[c]*wave[c]*(c ? 1e-4 : 1e-3);
		}
	}
	assert_true(is[0]/all[0] > 0.9 && is[0]/all[0] < 1.01);
	assert_true(fabs(is[1]/all[1]) < 0.3);
}

static void
too_few_steps_are_reported(void **state)
{
	const FitOptions hasty = { .tolerance = 1e-10, .most = 1, .sharpen = 1 };
	Surface s = given(torus, COARSE);
	FitProgress at;

	(void)state;
	memcpy(found, truth, sizeof truth);
	assert_int_equal(surface(&s, &hasty, found, &at), 0);
	assert_int_equal(at.step, 1);
	assert_true(at.change > 0 && at.energy > 0 && at.worst > (size_t)COARSE.nu);
	assert_int_equal(at.stopped, 0);
}

/* Fits a surface to lambda and H of a torus after noise of the given size was added to H. */
static FitProgress
fit_noisy(double size, double tolerance, double settled)
{
	const FitOptions o = { .tolerance = tolerance, .most = 400, .settled = settled };
	Surface s = given(torus, COARSE);
	Misfit m;
	unsigned long long seed = 5;
	FitProgress at = { 0 };
	int p, r;

	for (p = 0; p < COARSE.nu*COARSE.nv; p++)
		H[p] += size*noise(&seed);
	m = misfit_of(&s);
	memcpy(found, truth, sizeof truth);
	r = fit(&m, &o, found, &at);
	assert_int_equal(r, at.stopped != 0);
	misfit_free(&m);
	return at;
}

/* With little noise in H the fit converges, and its misfit is proportional to the square of the noise.
 * With much noise the fit creeps: its steps are shortened again and again. */
static void
fit_says_how_it_ended(void **state)
{
	FitProgress little = fit_noisy(1, 1e-6, 0), more = fit_noisy(3, 1e-6, 0), much = fit_noisy(100, 1e-6, 0), on;

	(void)state;
	assert_int_equal(little.stopped, FIT_CONVERGED);
	assert_int_equal(more.stopped, FIT_CONVERGED);
	assert_true(fabs(more.misfit/little.misfit/9 - 1) < 0.1);
	assert_int_equal(much.stopped, FIT_CREPT);
	assert_true(much.crept > 0);
	on = fit_noisy(100, 1e-6, 0.5*much.crept);              /* goes on until it moves less */
	assert_true(on.step > much.step && on.energy < much.energy);
	assert_true(on.stopped != FIT_CREPT || on.crept <= 0.5*much.crept);
}

/* If the energy overflows, surface() does not report convergence. */
static void
overflow_is_reported(void **state)
{
	Surface s = given(cylinder, (Chart){ 9, 8, 0.8, &CHART_RECTANGLE });
	FitProgress at;
	int i, k;

	(void)state;
	for (k = 0; k < 2; k++) {
		for (i = 0; i < 9*8; i++)
			(k ? H : lambda)[i] = k ? 1e200 : 1e-200;
		memcpy(found, truth, 3*9*8*sizeof *found);
		assert_int_equal(surface(&s, &EXACT, found, &at), 0);
		assert_true(at.step <= 1);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(surfaces_come_back),
		cmocka_unit_test(error_is_of_second_order),
		cmocka_unit_test(residue_gives_the_surface_itself),
		cmocka_unit_test(start_does_not_change_the_result),
		cmocka_unit_test(unit_of_length_changes_nothing),
		cmocka_unit_test(threads_change_no_bit),
		cmocka_unit_test(free_surfaces_come_back_of_second_order),
		cmocka_unit_test(free_surface_moves_with_its_band_or_start),
		cmocka_unit_test(free_surface_starts_from_its_band),
		cmocka_unit_test(small_grids_with_free_boundary_are_solved),
		cmocka_unit_test(small_grids_are_solved),
		cmocka_unit_test(weights_are_sharp_once_the_metric_fits),
		cmocka_unit_test(known_detail_needs_hardly_a_step),
		cmocka_unit_test(steps_that_overshoot_are_shortened),
		cmocka_unit_test(place_holds_long_waves),
		cmocka_unit_test(too_few_steps_are_reported),
		cmocka_unit_test(fit_says_how_it_ended),
		cmocka_unit_test(overflow_is_reported),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
