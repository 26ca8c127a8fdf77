/* test_rectmap.c - the corners, the conformal map and its grid, on surfaces whose map is known
 * in closed form. */
#include "cmock.h"

#include <omp.h>

#include "../lib/map/corners.h"
#include "../lib/grid/lambdah.h"
#include "../lib/map/rectmap.h"
#include "../lib/mesh/refine.h"
#include "../lib/sample/sampler.h"
#include "surfaces.h"
#include "synthdisk.h"
#include "cotapply.h"

/* A synthetic surface and its map; the corners are vertices 0 1 2 3. */
typedef struct Mapped {
	Synth       s;
	SynthDomain dom;
	Disk        d;
	int         corner[4];
	double     *xy, *u, *v, T, certificate;
} Mapped;

static void
map(const char *kind, int n, Mapped *m)
{
	static const int vertex[4] = { 0, 1, 2, 3 };
	SpdReport report;
	int at;

	synth_disk(kind, n, &m->s, &m->dom, &m->d, &m->xy);
	m->u = malloc(m->d.m.nv*sizeof *m->u);
	m->v = malloc(m->d.m.nv*sizeof *m->v);
	assert_int_equal(corners_given(&m->d, vertex, m->corner, &at), 0);
	assert_int_equal(rectmap(&m->d, NULL, m->corner, m->u, m->v, &m->T, &m->certificate, &report), 0);
	assert_true(m->certificate > -1e-12);
}

static void
unmap(Mapped *m)
{
	disk_free(&m->d);
	free(m->xy);
	free(m->u);
	free(m->v);
}

/* The map of a rectangle is exact, because it is linear, and linear functions solve the equations of
 * the cotangent matrix exactly. */
static void
rectangle_is_mapped_by_the_identity(void **state)
{
	Mapped m;
	double a, b;
	int i;

	(void)state;
	map("rectangle", 500, &m);
	a = m.dom.x1 - m.dom.x0, b = m.dom.y1 - m.dom.y0;
	assert_true(fabs(m.T - b/a) < 1e-12);
	assert_true(fabs(m.certificate) < 1e-12);
	for (i = 0; i < m.d.m.nv; i++) {
		assert_true(fabs(m.u[i] - m.xy[2*i]/a) < 1e-12);
		assert_true(fabs(m.v[i] - m.xy[2*i+1]/a) < 1e-12);
	}
	assert_int_equal(rectmap_flipped(&m.d.m, m.u, m.v), 0);
	unmap(&m);
}

static double
modulus_error(const char *kind, int n)
{
	Mapped m;
	double e;

	map(kind, n, &m);
	assert_int_equal(rectmap_flipped(&m.d.m, m.u, m.v), 0);
	e = fabs(m.T/m.dom.T - 1);
	unmap(&m);
	return e;
}

/* The modulus T converges: with 16 times as many vertices, the bound on its error is 13 times
 * smaller, which is close to second order in the edge length. */
static void
modulus_of_sector_and_surfaces(void **state)
{
	static const char *const kind[] = { "sector", "mercator", "catenoid", "torus", "cylinder" };
	size_t i;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		assert_true(modulus_error(kind[i], 500) < 2e-2);
		assert_true(modulus_error(kind[i], 8000) < 1.5e-3);
	}
}

/* The modulus of surfaces for which T = 1 by symmetry.  The map is singular at the inner corner of
 * the L and at corners on a smooth boundary, which lowers the order of convergence. */
static void
modulus_by_symmetry(void **state)
{
	(void)state;
	assert_true(modulus_error("lshape", 2000) < 5e-3);
	assert_true(modulus_error("cap", 2000) < 5e-3);
	assert_true(modulus_error("enneper", 2000) < 5e-3);
}

static double
certificate_of(int n)
{
	Mapped m;
	double c;

	map("sector", n, &m);
	c = m.certificate;
	unmap(&m);
	return c;
}

static void
certificate_falls_with_the_triangle_size(void **state)
{
	(void)state;
	assert_true(certificate_of(8000) < certificate_of(500)/10);
}

static void
cotangent_matrix_is_its_own_adjoint(void **state)
{
	Mapped m;
	unsigned long long seed = 3;
	double *x, *y, *Cx, *Cy, left = 0, right = 0, energy = 0, sum = 0;
	int i, n;

	(void)state;
	map("torus", 800, &m);
	n = m.d.m.nv;
	x = calloc(n, sizeof *x), y = calloc(n, sizeof *y), Cx = malloc(n*sizeof *x), Cy = malloc(n*sizeof *y);
	for (i = 0; i < n; i++)
		x[i] = noise(&seed), y[i] = noise(&seed);
	cotangent_apply(&m.d.m, x, Cx);
	cotangent_apply(&m.d.m, y, Cy);
	for (i = 0; i < n; i++) {
		left += Cx[i]*y[i];
		right += x[i]*Cy[i];
		energy += x[i]*Cx[i];
		sum += Cx[i];
	}
	assert_true(fabs(left - right) < 1e-10*fabs(energy));
	assert_true(fabs(sum) < 1e-10*fabs(energy));
	assert_true(energy > 0);
	free(x), free(y), free(Cx), free(Cy);
	unmap(&m);
}

static double *
grid_of(const Mapped *m, Chart g, int surface, double *phi[3])
{
	size_t n = (size_t)g.nu*g.nv, p;
	double *block = malloc(5*n*sizeof *block), *x = block + 3*n, *y = block + 4*n;
	Sampler s;

	phi[0] = block, phi[1] = block + n, phi[2] = block + 2*n;
	for (p = 0; p < n; p++)
		x[p] = p%g.nu*chart_h(g), y[p] = p/g.nu*chart_k(g);
	assert_int_equal(sampler_init(&s, &m->d, m->u, m->v, m->T, surface), 0);
	assert_int_equal(sampler_points(&s, g.nu*g.nv, x, y, phi), 0);
	sampler_free(&s);
	return block;
}

static void
sampling_is_exact_on_the_plane(void **state)
{
	Mapped m;
	Chart g = { 23, 37, 0, &CHART_RECTANGLE };
	double *phi[3], *block;
	int p, surface;

	(void)state;
	map("rectangle", 300, &m);
	g.T = m.T;
	for (surface = SAMPLER_FACETS; surface <= SAMPLER_SMOOTH; surface++) {
		block = grid_of(&m, g, surface, phi);
		for (p = 0; p < g.nu*g.nv; p++) {
			assert_true(fabs(phi[0][p] - p%g.nu*chart_h(g)*m.dom.x1) < 1e-11);
			assert_true(fabs(phi[1][p] - p/g.nu*chart_k(g)*m.dom.x1) < 1e-11);
		}
		free(block);
	}
	unmap(&m);
}

/* The largest difference of a coordinate between the grid of a surface with conformal parameters and
 * phi at the corresponding points of its domain. */
static double
sampling_error(const char *kind, int n)
{
	Mapped m;
	Chart g = { 41, 33, 0, &CHART_RECTANGLE };
	double *phi[3], *block, truth[3], max = 0;
	int p, c;

	map(kind, n, &m);
	g.T = m.T;
	block = grid_of(&m, g, SAMPLER_FACETS, phi);
	for (p = 0; p < g.nu*g.nv; p++) {
		m.s.kind->phi(m.s.p, m.dom.x0 + (m.dom.x1 - m.dom.x0)*(p%g.nu)/(g.nu - 1),
		    m.dom.y0 + (m.dom.y1 - m.dom.y0)*(p/g.nu)/(g.nv - 1), truth);
		for (c = 0; c < 3; c++)
			max = fmax(max, fabs(phi[c][p] - truth[c]));
	}
	free(block);
	unmap(&m);
	return max;
}

static void
sampling_converges(void **state)
{
	static const char *const kind[] = { "mercator", "catenoid", "torus" };
	size_t i;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		double coarse = sampling_error(kind[i], 500), fine = sampling_error(kind[i], 8000);

		assert_true(fine < coarse/8);
		assert_true(fine < 5e-3);
	}
}

/* Checks the mean errors of lambda and H of the grid after mapping and sampling.  The rectangle has
 * width 1, so lambda of the grid is lambda of phi times the width of the domain of phi. */
static void
check_chain(int surface, double lambda_bound, double H_bound)
{
	Mapped m;
	Chart g = { 33, 33, 0, &CHART_RECTANGLE };
	double *phi[3], *block, *lambda, *H, elambda = 0, eH = 0, x, y;
	int p;

	map("mercator", 20000, &m);
	g.T = m.T;
	block = grid_of(&m, g, surface, phi);
	lambda = malloc(33*33*sizeof *lambda);
	H = malloc(33*33*sizeof *H);
	lambdah(g, (const double *const *)phi, LAMBDAH_NORMAL, lambda, H);
	for (p = 0; p < g.nu*g.nv; p++) {
		x = m.dom.x0 + (m.dom.x1 - m.dom.x0)*(p%g.nu)/(g.nu - 1);
		y = m.dom.y0 + (m.dom.y1 - m.dom.y0)*(p/g.nu)/(g.nv - 1);
		elambda += fabs(lambda[p]/(m.dom.x1 - m.dom.x0)/m.s.kind->lambda(m.s.p, x, y) - 1);
		eH += fabs(H[p] - m.s.kind->H(m.s.p, x, y));
	}
	assert_true(elambda/(g.nu*g.nv) < lambda_bound);
	assert_true(eH/(g.nu*g.nv) < H_bound);
	free(block), free(lambda), free(H);
	unmap(&m);
}

/* lambda and H after mapping and sampling.  With SAMPLER_SMOOTH H is more accurate, since facets have
 * all their curvature on the edges. */
static void
lambda_and_H_of_the_chain(void **state)
{
	(void)state;
	check_chain(SAMPLER_FACETS, 5e-3, 0.05);
	check_chain(SAMPLER_SMOOTH, 2e-3, 2e-3);
}

static void
corners_by_shape(void **state)
{
	Disk d;
	Synth s;
	SynthDomain dom;
	int corner[4], k;

	(void)state;
	synth_disk("rectangle", 2000, &s, &dom, &d, NULL);
	assert_int_equal(corners_auto(&d, corner), 1);
	for (k = 0; k < 4; k++)
		assert_int_equal(d.loop[corner[k]], k);
	disk_free(&d);
	synth_disk("cap", 2000, &s, &dom, &d, NULL);
	assert_int_equal(corners_auto(&d, corner), 0);
	for (k = 0; k < 4; k++)         /* the vertices are evenly spaced on a circle */
		assert_true(fabs(corner[k] - k*d.nb/4.0) <= 1);
	disk_free(&d);
}

static void
corners_by_number(void **state)
{
	static const int inner[4] = { 0, 1, 2, -1 }, back[4] = { 3, 2, 1, 0 }, twice[4] = { 0, 0, 1, 2 };
	static const int turned[4] = { 2, 3, 0, 1 };
	Disk d;
	Synth s;
	SynthDomain dom;
	int corner[4], at = 0;

	(void)state;
	synth_disk("rectangle", 200, &s, &dom, &d, NULL);
	assert_int_equal(corners_given(&d, turned, corner, &at), 0);
	assert_int_equal(d.loop[corner[0]], 2);
	assert_int_equal(corners_given(&d, inner, corner, &at), CORNERS_EINNER);
	assert_int_equal(at, -1);
	assert_int_equal(corners_given(&d, back, corner, &at), CORNERS_EORDER);
	assert_int_equal(corners_given(&d, twice, corner, &at), CORNERS_EORDER);
	disk_free(&d);
}

/* A rectangle of two triangles is mapped: every vertex is a corner, so there is no equation to
 * solve. */
static void
no_free_vertices(void **state)
{
	double xyz[] = { 0,0,0, 1,0,0, 1,2,0, 0,2,0 }, u[4], v[4], T, certificate;
	int idx[] = { 0,1,2, 0,2,3 }, first[] = { 0, 3, 6 }, i;
	static const int corner[4] = { 0, 1, 2, 3 };
	Soup soup = { .nv = 4, .nf = 2, .xyz = xyz, .idx = idx, .first = first };
	SpdReport report;
	Disk d;

	(void)state;
	assert_int_equal(disk_from_soup(&d, &soup), 0);
	assert_int_equal(rectmap(&d, NULL, corner, u, v, &T, &certificate, &report), 0);
	assert_true(fabs(T - 2) < 1e-14);
	assert_true(fabs(certificate) < 1e-14);
	for (i = 0; i < 4; i++) {
		assert_true(fabs(u[i] - xyz[3*i]) < 1e-14);
		assert_true(fabs(v[i] - xyz[3*i+1]) < 1e-14);
	}
	disk_free(&d);
}

/* C x, computed from the rows of the cotangent matrix C, equals C x summed triangle by triangle. */
static void
rows_are_the_triangles(void **state)
{
	Mapped m;
	Cotangent C;
	unsigned long long seed = 5;
	double *x, *y, z, Eu, Ev, energy = 0;
	int i, k;

	(void)state;
	map("catenoid", 800, &m);
	x = calloc(m.d.m.nv, sizeof *x), y = calloc(m.d.m.nv, sizeof *y);
	for (i = 0; i < m.d.m.nv; i++)
		x[i] = noise(&seed);
	cotangent_apply(&m.d.m, x, y);
	assert_int_equal(cotangent_init(&C, &m.d), 0);
	for (i = 0; i < C.g.n; i++) {
		for (z = 0, k = C.g.first[i]; k < C.g.first[i+1]; k++)
			z += C.c[k]*(x[C.g.adj[k]] - x[i]);
		assert_true(fabs(z - y[i]) < 1e-11);
		energy += x[i]*y[i];
	}
	assert_int_equal(cotangent_energy(&m.d.m, x, m.u, &Eu, &Ev), 0);
	assert_true(fabs(Eu/energy - 1) < 1e-12);
	cotangent_free(&C);
	free(x), free(y);
	unmap(&m);
}

/* A triangle with two equal vertices, whose angles are NaN, is reported: in a small mesh, and in
 * one so large that the elimination is split into several subtrees. */
static void
degenerate_triangle_is_reported(void **state)
{
	static const int size[] = { 300, 40000 };
	Mapped m;
	SpdReport report;
	size_t s;
	int *t;

	(void)state;
	for (s = 0; s < 2; s++) {
		map("rectangle", size[s], &m);
		t = &m.d.m.tri[3*(m.d.m.nf/2)];
		memcpy(&m.d.m.xyz[3*(size_t)t[0]], &m.d.m.xyz[3*(size_t)t[1]], 3*sizeof(double));
		assert_int_equal(rectmap(&m.d, NULL, m.corner, m.u, m.v, &m.T, &m.certificate, &report),
			SPD_EINDEFINITE);
		unmap(&m);
	}
}

static int
upright(const Mesh *m)
{
	int t;

	for (t = 0; t < m->nf; t++) {
		const double *a = &m->xyz[3*m->tri[3*t]], *b = &m->xyz[3*m->tri[3*t+1]],
			*c = &m->xyz[3*m->tri[3*t+2]];

		if (!((b[0] - a[0])*(c[1] - a[1]) - (b[1] - a[1])*(c[0] - a[0]) > 0))
			return 0;
	}
	return 1;
}

/* Slivers are mapped: vertices are moved almost onto a neighbour, so that cotangents reach 1e6.  The
 * map of the rectangle is still linear, up to the rounding errors of such large entries. */
static void
slivers_are_mapped(void **state)
{
	Mapped m;
	SpdReport report;
	double a, keep[3], *x, *y, step = 1;
	int i, t, moved = 0;

	(void)state;
	map("rectangle", 500, &m);
	a = m.dom.x1 - m.dom.x0;
	for (t = 0; t < m.d.m.nf && moved < 10; t++) {
		for (i = 0; i < m.d.nb && m.d.loop[i] != m.d.m.tri[3*t]; i++)
			;
		if (i < m.d.nb)
			continue;
		x = &m.d.m.xyz[3*m.d.m.tri[3*t]], y = &m.d.m.xyz[3*m.d.m.tri[3*t+1]];
		if (hypot(x[0] - y[0], x[1] - y[1]) < 1e-3)
			continue;
		memcpy(keep, x, sizeof keep);
		for (i = 0; i < 2; i++)
			x[i] = y[i] + 1e-5*(x[i] - y[i]);
		step = fmin(step, fabs(x[0] - y[0]));
		if (upright(&m.d.m))
			moved++;
		else
			memcpy(x, keep, sizeof keep);
	}
	assert_int_equal(moved, 10);
	assert_true(step < 1e-6);
	assert_int_equal(rectmap(&m.d, NULL, m.corner, m.u, m.v, &m.T, &m.certificate, &report), 0);
	assert_true(fabs(m.T*a/(m.dom.y1 - m.dom.y0) - 1) < 1e-8);
	for (i = 0; i < m.d.m.nv; i++)
		assert_true(fabs(m.u[i] - m.d.m.xyz[3*i]/a) < 1e-6);
	unmap(&m);
}

static void
same_bits_for_any_threads(void **state)
{
	int threads = omp_get_max_threads(), t;
	double *u, *v, T, certificate;
	SpdReport report;
	Mapped m;

	(void)state;
	omp_set_num_threads(1);
	map("face", 20000, &m);
	u = malloc(m.d.m.nv*sizeof *u), v = malloc(m.d.m.nv*sizeof *v);
	for (t = 2; t <= 8; t *= 2) {
		omp_set_num_threads(t);
		assert_int_equal(rectmap(&m.d, NULL, m.corner, u, v, &T, &certificate, &report), 0);
		assert_memory_equal(u, m.u, m.d.m.nv*sizeof *u);
		assert_memory_equal(v, m.v, m.d.m.nv*sizeof *v);
		assert_memory_equal(&T, &m.T, sizeof T);
	}
	omp_set_num_threads(threads);
	free(u), free(v);
	unmap(&m);
}

/* Quadratic elements give the exact energy of a quadratic function, and C x is 0 at inner vertices
 * if the function is harmonic. */
static void
quadratics_are_exact(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d, fine;
	Cotangent C, C0;
	double *x, E = 0, a, b, row, most = 0;
	unsigned char *border;
	int i, k;

	(void)state;
	synth_disk("rectangle", 300, &s, &dom, &d, NULL);
	assert_int_equal(refine_split(&d, NULL, NULL, &fine, NULL), 0);
	assert_int_equal(cotangent_init(&C0, &d) | cotangent_init(&C, &fine), 0);
	assert_int_equal(cotangent_quadratic(&C, &C0), 0);
	x = malloc(fine.m.nv*sizeof *x);
	border = calloc(fine.m.nv, 1);
	for (i = 0; i < fine.m.nv; i++) {
		a = fine.m.xyz[3*i], b = fine.m.xyz[3*i+1];
		x[i] = a*a - b*b + 3*a*b + a;
	}
	for (i = 0; i < fine.nb; i++)
		border[fine.loop[i]] = 1;
	for (i = 0; i < fine.m.nv; i++) {
		for (row = 0, k = C.g.first[i]; k < C.g.first[i+1]; k++) {
			row += C.c[k]*(x[C.g.adj[k]] - x[i]);
			E -= C.c[k]*(x[C.g.adj[k]] - x[i])*(x[C.g.adj[k]] - x[i])/2;
		}
		most = border[i] ? most : fmax(most, fabs(row));
	}
	assert_true(most < 1e-12);
	/* E is the integral of |grad|^2 = 13 (x^2 + y^2) + 4x + 6y + 1 */
	a = dom.x1, b = dom.y1;
	assert_true(dom.x0 == 0 && dom.y0 == 0);
	assert_true(fabs(E/(13*a*b*(a*a + b*b)/3 + 2*a*a*b + 3*a*b*b + a*b) - 1) < 1e-12);
	free(x), free(border);
	cotangent_free(&C), cotangent_free(&C0);
	disk_free(&d), disk_free(&fine);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(rectangle_is_mapped_by_the_identity),
		cmocka_unit_test(modulus_of_sector_and_surfaces),
		cmocka_unit_test(modulus_by_symmetry),
		cmocka_unit_test(certificate_falls_with_the_triangle_size),
		cmocka_unit_test(cotangent_matrix_is_its_own_adjoint),
		cmocka_unit_test(sampling_is_exact_on_the_plane),
		cmocka_unit_test(sampling_converges),
		cmocka_unit_test(lambda_and_H_of_the_chain),
		cmocka_unit_test(corners_by_shape),
		cmocka_unit_test(corners_by_number),
		cmocka_unit_test(no_free_vertices),
		cmocka_unit_test(rows_are_the_triangles),
		cmocka_unit_test(degenerate_triangle_is_reported),
		cmocka_unit_test(slivers_are_mapped),
		cmocka_unit_test(quadratics_are_exact),
		cmocka_unit_test(same_bits_for_any_threads),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
