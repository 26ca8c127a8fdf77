/* test_synth.c - synth.h: the formulas for lambda and H agree with finite differences of phi, and the
 * meshes are disks whose vertices lie on the surfaces. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/synth/rng.h"
#include "../lib/synth/synth.h"
#include "../lib/base/vec3.h"

/* phi_x, phi_y and Delta phi by central differences of fourth order. */
typedef struct Diffs {
	double x[3], y[3], lap[3];
} Diffs;

static Diffs
diffs(const Synth *s, double x, double y, double h)
{
	static const double d1[5] = { 1./12, -8./12, 0, 8./12, -1./12 };
	static const double d2[5] = { -1./12, 16./12, -30./12, 16./12, -1./12 };
	Diffs d = { { 0 }, { 0 }, { 0 } };
	double px[3], py[3];
	int i, k;

	for (i = 0; i < 5; i++) {
		s->kind->phi(s->p, x + (i-2)*h, y, px);
		s->kind->phi(s->p, x, y + (i-2)*h, py);
		for (k = 0; k < 3; k++) {
			d.x[k] += d1[i]*px[k]/h;
			d.y[k] += d1[i]*py[k]/h;
			d.lap[k] += d2[i]*(px[k] + py[k])/(h*h);
		}
	}
	return d;
}

/* A random point of the domain that is not too close to the border of its box. */
static void
random_point(const SynthDomain *d, uint64_t *rng, double *x, double *y)
{
	double w = d->x1 - d->x0, h = d->y1 - d->y0;

	do {
		*x = d->x0 + w*(0.02 + 0.96*rng_unit(rng));
		*y = d->y0 + h*(0.02 + 0.96*rng_unit(rng));
	} while (!synth_inside(d, *x, *y));
}

static void
check_formulas(const Synth *s)
{
	double x, y, lambda, n[3], area;
	uint64_t rng = 7;
	SynthDomain dom;
	Diffs d;
	int i;

	assert_int_equal(synth_domain(s, &dom), 0);
	for (i = 0; i < 200; i++) {
		random_point(&dom, &rng, &x, &y);
		lambda = s->kind->lambda(s->p, x, y);
		d = diffs(s, x, y, 1e-3);
		assert_true(fabs(norm3(d.x)/lambda - 1) < 1e-6);
		assert_true(fabs(norm3(d.y)/lambda - 1) < 1e-6);
		assert_true(fabs(dot3(d.x, d.y)) < 1e-6*lambda*lambda);
		cross3(d.x, d.y, n);
		area = norm3(n);
		assert_true(fabs(dot3(d.lap, n)/area/(2*lambda*lambda) - s->kind->H(s->p, x, y))
			< 1e-6*(1 + fabs(s->kind->H(s->p, x, y))));
	}
}

static int
is_closed(const SynthKind *k)
{
	SynthDomain d = { .shape = SYNTH_RECT };
	double p[SYNTH_MAXPAR];
	int i;

	for (i = 0; i < SYNTH_MAXPAR; i++)
		p[i] = k->par[i].value;
	k->domain(p, &d);
	return d.shape == SYNTH_SPHERE;
}

static void
formulas_match_differences(void **state)
{
	const SynthKind *k;
	Synth s;
	int i, seen = 0;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++) {
		assert_int_equal(synth_init(&s, k->name), 0);
		assert_ptr_equal(s.kind, k);
		assert_true(!k->lambda == !k->H);
		if (k->lambda)
			check_formulas(&s), seen++;
	}
	assert_true(seen >= 10);
}

/* The formulas also hold for parameters other than the defaults: a formula that exchanges two
 * parameters or forgets one would fail. */
static void
formulas_hold_for_other_parameters(void **state)
{
	static const struct { const char *kind, *par; double value; } at[] = {
		{ "sector", "r0", 0.7 }, { "cap", "R", 1.7 }, { "mercator", "R", 2.3 },
		{ "cylinder", "R", 0.6 }, { "catenoid", "a", 1.9 }, { "torus", "r", 1.1 },
		{ "torus", "R", 3.1 }, { "enneper", "a", 0.4 }, { "spiral", "gap", 0.3 },
		{ "spiral", "rise", 12 }, { "spiral", "r0", 1.3 }
	};
	Synth s;
	size_t i;

	(void)state;
	for (i = 0; i < sizeof at/sizeof *at; i++) {
		assert_int_equal(synth_init(&s, at[i].kind), 0);
		assert_int_equal(synth_set(&s, at[i].par, at[i].value), 0);
		check_formulas(&s);
	}
}

/* On surfaces around the origin or around the z axis, the normal points outward. */
static void
normals_point_out(void **state)
{
	static const char *const kind[] = { "cap", "mercator", "cylinder", "tooth" };
	double xyz[3], n[3], cx, cy;
	SynthDomain dom;
	Synth s;
	Diffs d;
	size_t i;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		assert_int_equal(synth_init(&s, kind[i]), 0);
		assert_int_equal(synth_domain(&s, &dom), 0);
		cx = 0.4*dom.x0 + 0.6*dom.x1;
		cy = 0.55*dom.y0 + 0.45*dom.y1;
		s.kind->phi(s.p, cx, cy, xyz);
		d = diffs(&s, cx, cy, 1e-3);
		cross3(d.x, d.y, n);
		if (!strcmp(kind[i], "cylinder"))
			xyz[2] = 0;
		assert_true(dot3(xyz, n) > 0);
	}
}

static void
moduli_are_known(void **state)
{
	SynthDomain d;
	Synth s;

	(void)state;
	synth_init(&s, "rectangle");
	synth_set(&s, "a", 3);
	synth_set(&s, "b", 2);
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_true(fabs(d.T - 2./3) < 1e-15);
	synth_init(&s, "sector");
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_true(fabs(d.T - 2*acos(-1)/3/log(3)) < 1e-14);
	synth_init(&s, "lshape");
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_true(d.T == 1);
	synth_init(&s, "cap");
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_true(d.T == 1);
	synth_init(&s, "face");
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_true(d.T == 0);
}

static void
parameters_are_checked(void **state)
{
	SynthDomain d;
	Synth s;

	(void)state;
	assert_int_equal(synth_init(&s, "ball"), -1);
	assert_int_equal(synth_init(&s, ""), -1);
	assert_int_equal(synth_init(&s, "sector"), 0);
	assert_int_equal(synth_set(&s, "R", 1), SYNTH_EPAR);
	assert_int_equal(synth_set(&s, "r0", 0), SYNTH_ERANGE);
	assert_int_equal(synth_set(&s, "r0", NAN), SYNTH_ERANGE);
	assert_int_equal(synth_set(&s, "r0", 5), 0);
	assert_int_equal(synth_domain(&s, &d), SYNTH_EDOMAIN);  /* r0 = 5 > r1 = 3 */
	assert_int_equal(synth_set(&s, "r1", 6), 0);
	assert_int_equal(synth_domain(&s, &d), 0);
	assert_int_equal(synth_init(&s, "torus"), 0);
	assert_int_equal(synth_set(&s, "r", 2), 0);             /* r = R */
	assert_int_equal(synth_domain(&s, &d), SYNTH_EDOMAIN);
}

static int
by_edge(const void *a, const void *b)
{
	return memcmp(a, b, 2*sizeof(int));
}

/* The directed edges of m as pairs of vertices, sorted. */
static int *
edges(const Mesh *m)
{
	int *e = malloc(6*sizeof *e*(size_t)m->nf), f, k;

	assert_non_null(e);
	for (f = 0; f < m->nf; f++)
		for (k = 0; k < 3; k++) {
			e[6*f + 2*k] = m->tri[3*f + k];
			e[6*f + 2*k + 1] = m->tri[3*f + (k+1)%3];
		}
	qsort(e, 3*(size_t)m->nf, 2*sizeof *e, by_edge);
	return e;
}

/* Checks that m is an oriented disk: each directed edge occurs once, the edges without a twin form
 * a single loop, the Euler characteristic is 1, and every vertex is used.  It does not check that
 * m is connected; a Delaunay triangulation is. */
static void
check_disk(const Mesh *m)
{
	int *e = edges(m), *next = malloc(sizeof *next*(size_t)m->nv), i, p, nb = 0, steps = 0;
	int first = -1;

	assert_non_null(next);
	for (p = 0; p < m->nv; p++)
		next[p] = -1;
	for (i = 0; i < 3*m->nf; i++) {
		int back[2] = { e[2*i+1], e[2*i] };

		assert_true(i == 0 || by_edge(e + 2*i, e + 2*(i-1)));
		if (bsearch(back, e, 3*(size_t)m->nf, 2*sizeof *e, by_edge))
			continue;
		assert_int_equal(next[e[2*i]], -1);
		next[first = e[2*i]] = e[2*i+1];
		nb++;
	}
	for (p = first; steps < nb && (p != first || steps == 0); steps++)
		p = next[p];
	assert_int_equal(steps, nb);
	assert_int_equal(p, first);
	assert_int_equal(m->nv - (3*m->nf + nb)/2 + m->nf, 1);
	for (p = 0; p < 4; p++)
		assert_true(next[p] >= 0);      /* the corners are on the boundary */
	memset(next, 0, sizeof *next*(size_t)m->nv);
	for (i = 0; i < 3*m->nf; i++)
		next[e[2*i]] = 1;
	for (p = 0; p < m->nv; p++)
		assert_int_equal(next[p], 1);
	free(e);
	free(next);
}

static double
least_angle(const Mesh *m)
{
	double a[3], b[3], least = 180, angle;
	int f, k;

	for (f = 0; f < m->nf; f++)
		for (k = 0; k < 3; k++) {
			const double *p = m->xyz + 3*m->tri[3*f + k];

			sub3(m->xyz + 3*m->tri[3*f + (k+1)%3], p, a);
			sub3(m->xyz + 3*m->tri[3*f + (k+2)%3], p, b);
			angle = acos(dot3(a, b)/(norm3(a)*norm3(b)))*180/acos(-1);
			assert_true(angle > 0);
			least = angle < least ? angle : least;
		}
	return least;
}

static int
is_strip(const char *name)
{
	return !strcmp(name, "spiral") || !strcmp(name, "moebius") || !strcmp(name, "cortex");
}

static void
meshes_are_disks(void **state)
{
	static const int size[] = { 50, 400, 6000 };
	const SynthKind *k;
	Synth s;
	Mesh m;
	int i, j;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++)
		for (j = 0; j < 3 && !is_closed(k); j++) {
			synth_init(&s, k->name);
			assert_int_equal(synth_mesh(&s, size[j], 5, &m, NULL), 0);
			assert_true(abs(m.nv - size[j]) <= size[j]/10);
			check_disk(&m);
			assert_true(least_angle(&m) > (is_strip(k->name) ? 3 : 10));
			mesh_free(&m);
		}
}

/* For every small number of vertices synth_mesh makes a disk or returns SYNTH_EMESH. */
static void
few_vertices(void **state)
{
	const SynthKind *k;
	Synth s;
	Mesh m;
	int err, i, n;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++)
		for (n = 4; n < 30; n++) {
			synth_init(&s, k->name);
			err = synth_mesh(&s, n, 1, &m, NULL);
			assert_true(err == 0 || err == SYNTH_EMESH);
			if (err)
				continue;
			if (!is_closed(k))
				check_disk(&m);
			mesh_free(&m);
		}
}

/* Checks that vertices 0 1 2 3 are the corners that synth.h states.  at[shape] has their positions in
 * the box of the domain, in units of its sides. */
static void
check_corners(const SynthDomain *d, const double *xy)
{
	const double r = (1 + sqrt(0.5))/2, l = 1 - r;
	const double at[3][4][2] = {
		[SYNTH_RECT] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } },
		[SYNTH_OVAL] = { { l, l }, { r, l }, { r, r }, { l, r } },
		[SYNTH_LSHAPE] = { { 0, 0 }, { 1, 0 }, { 0.5, 0.5 }, { 0, 1 } }
	};
	int i;

	for (i = 0; i < 4; i++) {
		assert_true(fabs((xy[2*i] - d->x0)/(d->x1 - d->x0) - at[d->shape][i][0]) < 1e-14);
		assert_true(fabs((xy[2*i+1] - d->y0)/(d->y1 - d->y0) - at[d->shape][i][1]) < 1e-14);
	}
}

/* Every vertex is phi of its parameters, the corners come first, and the normals of the triangles
 * point to the side of phi_x x phi_y. */
static void
vertices_lie_on_the_surface(void **state)
{
	const SynthKind *k;
	SynthDomain d;
	double *xy, xyz[3], e[3], g[3], n[3], area;
	Synth s;
	Diffs at;
	Mesh m;
	int i, p, f, *t, with = 0;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++) {
		synth_init(&s, k->name);
		assert_int_equal(synth_domain(&s, &d), 0);
		assert_int_equal(synth_mesh(&s, 3000, 1, &m, &xy), 0);
		for (p = 0; p < m.nv; p++) {
			k->phi(s.p, xy[2*p], xy[2*p+1], xyz);
			assert_memory_equal(xyz, m.xyz + 3*p, sizeof xyz);
		}
		for (f = 0; f < m.nf; f++) {
			t = m.tri + 3*f;
			if (is_closed(k))
				continue;       /* closed_meshes */
			area = (xy[2*t[1]] - xy[2*t[0]])*(xy[2*t[2]+1] - xy[2*t[0]+1])
				- (xy[2*t[2]] - xy[2*t[0]])*(xy[2*t[1]+1] - xy[2*t[0]+1]);
			assert_true(area > 0);
			if (!k->lambda)
				continue;
			sub3(m.xyz + 3*t[1], m.xyz + 3*t[0], e);
			sub3(m.xyz + 3*t[2], m.xyz + 3*t[0], g);
			cross3(e, g, n);
			at = diffs(&s, xy[2*t[0]], xy[2*t[0]+1], 1e-4);
			cross3(at.x, at.y, e);
			with += dot3(n, e) > 0;
			assert_true(dot3(n, e) > 0);
		}
		if (!is_closed(k))
			check_corners(&d, xy);
		mesh_free(&m);
		free(xy);
	}
	assert_true(with > 0);
}

/* Closed kinds give closed meshes, as even as the others, with the normal outwards, of the volume of their surface. */
static void
closed_meshes(void **state)
{
	static const struct { const char *kind; double volume; } at[] = { { "sphere", 4*M_PI/3 },
		{ "ellipsoid", 4*M_PI/3*1.5*0.7 }, { "bumpy", 0 } };
	static const int size[] = { 50, 400, 6000 };
	double n[3], volume;
	Synth s;
	Mesh m;
	size_t i;
	int j, f, q, *partner;

	(void)state;
	for (i = 0; i < 3; i++)
		for (j = 0; j < 3; j++) {
			assert_int_equal(synth_init(&s, at[i].kind), 0);
			assert_true(is_closed(s.kind));
			assert_int_equal(synth_mesh(&s, size[j], 5, &m, NULL), 0);
			assert_true(abs(m.nv - size[j]) <= size[j]/10);
			assert_int_equal(m.nv - m.nf/2, 2);
			assert_true(least_angle(&m) > (j ? 10 : 5));
			partner = calloc(3*(size_t)m.nf, sizeof *partner);
			for (volume = 0, f = 0; f < m.nf; f++) {
				cross3(m.xyz + 3*m.tri[3*f], m.xyz + 3*m.tri[3*f+1], n);
				volume += dot3(n, m.xyz + 3*m.tri[3*f+2])/6;
			}
			for (f = 0; j == 1 && f < 3*m.nf; f++)  /* each side has its opposite */
				for (q = 0; q < 3*m.nf; q++)
					partner[f] += m.tri[q] == m.tri[f - f%3 + (f+1)%3] &&
					    m.tri[q - q%3 + (q+1)%3] == m.tri[f];
			for (f = 0; j == 1 && f < 3*m.nf; f++)
				assert_int_equal(partner[f], 1);
			assert_true(volume > 0);
			if (at[i].volume > 0)
				assert_true(fabs(volume/at[i].volume - 1) < 12./size[j]);
			free(partner);
			mesh_free(&m);
		}
}

static void
equal_seeds_give_equal_meshes(void **state)
{
	Mesh a, b, c;
	Synth s;

	(void)state;
	synth_init(&s, "torus");
	assert_int_equal(synth_mesh(&s, 3000, 1, &a, NULL), 0);
	assert_int_equal(synth_mesh(&s, 3000, 1, &b, NULL), 0);
	assert_int_equal(synth_mesh(&s, 3000, 2, &c, NULL), 0);
	assert_int_equal(a.nv, b.nv);
	assert_int_equal(a.nf, b.nf);
	assert_memory_equal(a.xyz, b.xyz, 3*sizeof *a.xyz*(size_t)a.nv);
	assert_memory_equal(a.tri, b.tri, 3*sizeof *a.tri*(size_t)a.nf);
	assert_true(a.nv != c.nv || memcmp(a.xyz, c.xyz, 3*sizeof *a.xyz*(size_t)a.nv));
	mesh_free(&a);
	mesh_free(&b);
	mesh_free(&c);
}

/* The area of the surface: the integral of |phi_x x phi_y| by the midpoint rule. */
static double
true_area(const Synth *s, const SynthDomain *d)
{
	enum { N = 500 };
	double w = (d->x1 - d->x0)/N, h = (d->y1 - d->y0)/N, x, y, n[3], sum = 0;
	Diffs at;
	int i, j;

	for (j = 0; j < N; j++)
		for (i = 0; i < N; i++) {
			x = d->x0 + (i + 0.5)*w;
			y = d->y0 + (j + 0.5)*h;
			if (!synth_inside(d, x, y))
				continue;
			at = diffs(s, x, y, 1e-4*(d->x1 - d->x0));
			cross3(at.x, at.y, n);
			if (s->kind->lambda) {
				double l = s->kind->lambda(s->p, x, y);

				sum += w*h*l*l;
			} else
				sum += w*h*norm3(n);
		}
	return sum;
}

/* The area of the mesh converges to that of the surface.  The error decreases in proportion to the
 * area of the triangles, unless it is already small. */
static void
area_converges(void **state)
{
	const SynthKind *k;
	double A, err[2];
	SynthDomain d;
	Synth s;
	Mesh m;
	int i, j;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++) {
		synth_init(&s, k->name);
		assert_int_equal(synth_domain(&s, &d), 0);
		A = true_area(&s, &d);
		for (j = 0; j < 2; j++) {
			assert_int_equal(synth_mesh(&s, j ? 16000 : 1000, 3, &m, NULL), 0);
			err[j] = fabs(mesh_area(&m)/A - 1);
			mesh_free(&m);
		}
		assert_true(err[1] < 1e-2);
		assert_true(err[1] < err[0]/8 || err[1] < 2e-4);
	}
}

/* On surfaces with conformal parameters the triangles have similar sizes although lambda varies: the
 * longest edge is less than four times as long as the shortest. */
static void
meshes_are_even(void **state)
{
	const SynthKind *k;
	double least, most, e[3];
	Synth s;
	Mesh m;
	int i, f, j;

	(void)state;
	for (i = 0; (k = synth_kind(i)); i++) {
		if (!k->lambda)
			continue;
		synth_init(&s, k->name);
		assert_int_equal(synth_mesh(&s, 6000, 1, &m, NULL), 0);
		for (least = HUGE_VAL, most = 0, f = 0; f < m.nf; f++)
			for (j = 0; j < 3; j++) {
				sub3(m.xyz + 3*m.tri[3*f + j], m.xyz + 3*m.tri[3*f + (j+1)%3], e);
				least = fmin(least, norm3(e));
				most = fmax(most, norm3(e));
			}
		assert_true(most < 4*least);
		mesh_free(&m);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(formulas_match_differences),
		cmocka_unit_test(formulas_hold_for_other_parameters),
		cmocka_unit_test(normals_point_out),
		cmocka_unit_test(moduli_are_known),
		cmocka_unit_test(parameters_are_checked),
		cmocka_unit_test(meshes_are_disks),
		cmocka_unit_test(few_vertices),
		cmocka_unit_test(vertices_lie_on_the_surface),
		cmocka_unit_test(closed_meshes),
		cmocka_unit_test(equal_seeds_give_equal_meshes),
		cmocka_unit_test(area_converges),
		cmocka_unit_test(meshes_are_even),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
