/* test_subdivision.c - subdivision.h: after points are added, a disk is still a disk with the same
 * surface, and linear functions are extended exactly to the new vertices. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/vec3.h"
#include "../lib/mesh/subdivision.h"
#include "../lib/mesh/topology.h"
#include "../lib/synth/rng.h"
#include "disks.h"
#include "synthdisk.h"

/* n points to add.  They give `apart` new vertices, `boundary` of which lie on the boundary; other
 * points equal another point or an old vertex. */
typedef struct Chosen {
	SurfacePoint *point;
	int           n, apart, boundary;
} Chosen;

static void
choose(Chosen *c, SurfacePoint p)
{
	c->point[c->n++] = p;
}

/* On about every third edge, chooses up to four points, at most one in each quarter, and one end of
 * the edge.  Some points are chosen twice.  Each is given as a place on a side of one or the other
 * triangle at the edge. */
static void
choose_on_sides(const Disk *d, uint64_t *rng, Chosen *c)
{
	int h, k, twin;

	for (h = 0; h < 3*d->m.nf; h++) {
		twin = d->twin[h];
		if (twin > h || rng_unit(rng) < .67)
			continue;
		for (k = 0; k < 4; k++) {
			double place = (k + .1 + .8*rng_unit(rng))/4;

			if (rng_unit(rng) < .4)
				continue;
			choose(c, twin >= 0 && rng_unit(rng) < .5 ? subdivision_on_side(twin,
				1 - place) : subdivision_on_side(h, place));
			c->apart++;
			c->boundary += twin < 0;
			if (rng_unit(rng) < .3)
				choose(c, twin >= 0 ? subdivision_on_side(twin, 1 - place) : subdivision_on_side(h, place + 1e-12));
		}
		choose(c, subdivision_on_side(h, rng_unit(rng) < .5));
	}
}

static void
choose_within(const Disk *d, uint64_t *rng, Chosen *c)
{
	int f, k, n;

	for (f = 0; f < d->m.nf; f++)
		for (n = rng_unit(rng) < .3 ? 1 + (int)(5*rng_unit(rng)) : 0, k = 0; k < n; k++) {
			double s = sqrt(rng_unit(rng)), t = rng_unit(rng);

			choose(c, (SurfacePoint){ f, { 1 - s, s*(1 - t), s*t } });
			c->apart++;
		}
}

static void
shuffle(Chosen *c, uint64_t *rng)
{
	int i, k;

	for (i = c->n - 1; i > 0; i--) {
		SurfacePoint p = c->point[i];

		k = (int)(rng_unit(rng)*(i + 1));
		c->point[i] = c->point[k];
		c->point[k] = p;
	}
}

static Chosen
choose_points(const Disk *d, uint64_t seed)
{
	Chosen c = { malloc((40*(size_t)d->m.nf)*sizeof *c.point), 0, 0, 0 };

	assert_non_null(c.point);
	choose_on_sides(d, &seed, &c);
	choose_within(d, &seed, &c);
	shuffle(&c, &seed);
	return c;
}

static double
perimeter(const Disk *d)
{
	double sum = 0, x[3];
	int i;

	for (i = 0; i < d->nb; i++) {
		sub3(&d->m.xyz[3*d->loop[(i+1)%d->nb]], &d->m.xyz[3*d->loop[i]], x);
		sum += norm3(x);
	}
	return sum;
}

/* Checks that there is a vertex of m at every chosen point. */
static void
check_places(const Disk *d, const Chosen *c, const Mesh *m)
{
	int i, k, v;

	for (i = 0; i < c->n; i++) {
		const int *t = &d->m.tri[3*c->point[i].triangle];
		double least = HUGE_VAL, x[3], y[3];

		for (k = 0; k < 3; k++)
			x[k] = c->point[i].w[0]*d->m.xyz[3*t[0]+k] + c->point[i].w[1]*d->m.xyz[3*t[1]+k] + c->point[i].w[2]*d->m.xyz[3*t[2]+k];
		for (v = 0; v < m->nv; v++) {
			sub3(&m->xyz[3*v], x, y);
			least = fmin(least, norm3(y));
		}
		assert_true(least < 1e-11);
	}
}

/* Checks that subdivision_extend extends two linear functions of the position exactly from the
 * given vertices to all. */
static void
check_linear(const Subdivision *s)
{
	double *f = malloc(2*(size_t)s->d.m.nv*sizeof *f);
	int i, k;

	for (k = 0; k < 2; k++) {
		for (i = 0; i < s->given; i++) {
			const double *x = &s->d.m.xyz[3*i];

			f[2*i] = 1 + x[0] - 2*x[1] + 3*x[2];
			f[2*i+1] = x[1] + 5*x[2];
		}
		subdivision_extend(s, 2, f, f);
	}
	for (i = 0; i < s->d.m.nv; i++) {
		const double *x = &s->d.m.xyz[3*i];

		assert_true(fabs(f[2*i] - (1 + x[0] - 2*x[1] + 3*x[2])) < 1e-12);
		assert_true(fabs(f[2*i+1] - (x[1] + 5*x[2])) < 1e-12);
	}
	free(f);
}

/* Checks that `inner` has the same value on both sides of an edge, and that it is 0 on `given` edges:
 * the pieces of the edges of the given disk. */
static void
check_inner(const Subdivision *s, int given)
{
	int h, edges = 0;

	for (h = 0; h < 3*s->d.m.nf; h++) {
		if (s->d.twin[h] >= 0)
			assert_int_equal(s->inner[h], s->inner[s->d.twin[h]]);
		else
			assert_int_equal(s->inner[h], 0);
		edges += !s->inner[h] && s->d.twin[h] < h;
	}
	assert_int_equal(edges, given);
}

static int
count_within(const Chosen *c)
{
	int i, n = 0;

	for (i = 0; i < c->n; i++)
		n += c->point[i].w[0] != 0 && c->point[i].w[1] != 0 && c->point[i].w[2] != 0;
	return n;
}

static void
check_added(const Disk *d, uint64_t seed)
{
	Chosen c = choose_points(d, seed), more;
	Subdivision s;
	int n;

	assert_int_equal(subdivision_init(&s, d), 0);
	assert_true(disks_is_disk(&s.d));
	assert_int_equal(subdivision_add(&s, c.n, c.point), c.apart);
	assert_true(disks_is_disk(&s.d));
	assert_int_equal(s.d.m.nv, d->m.nv + c.apart);
	assert_int_equal(s.d.nb, d->nb + c.boundary);
	assert_true(fabs(mesh_area(&s.d.m)/mesh_area(&d->m) - 1) < 1e-12);
	assert_true(fabs(perimeter(&s.d)/perimeter(d) - 1) < 1e-12);
	assert_memory_equal(s.d.m.xyz, d->m.xyz, 3*d->m.nv*sizeof(double));
	check_places(d, &c, &s.d.m);
	check_linear(&s);
	check_inner(&s, (3*d->m.nf + d->nb)/2 + c.apart - count_within(&c));

	more = choose_points(&s.d, seed + 1);
	n = s.d.m.nv;
	assert_int_equal(subdivision_add(&s, more.n, more.point), more.apart);
	assert_true(disks_is_disk(&s.d));
	assert_int_equal(s.d.m.nv, n + more.apart);
	assert_true(fabs(mesh_area(&s.d.m)/mesh_area(&d->m) - 1) < 1e-12);
	check_linear(&s);
	free(c.point), free(more.point);
	subdivision_free(&s);
}

static void
points_are_added(void **state)
{
	static const char *const kind[] = { "face", "cap", "torus", "spiral" };
	SynthDomain dom;
	size_t i;
	Synth s;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		synth_disk(kind[i], 150, &s, &dom, &d, NULL);
		check_added(&d, i);
		disk_free(&d);
	}
}

/* Twice the signed area of triangle f of a mesh in the plane. */
static double
area(const Mesh *m, int f)
{
	const double *a = &m->xyz[3*m->tri[3*f]], *b = &m->xyz[3*m->tri[3*f+1]], *c = &m->xyz[3*m->tri[3*f+2]];

	return (b[0] - a[0])*(c[1] - a[1]) - (b[1] - a[1])*(c[0] - a[0]);
}

/* On a disk in the plane no triangle of the subdivision is flipped, up to rounding. */
static void
no_triangle_is_turned(void **state)
{
	uint64_t seed;
	int f;

	(void)state;
	for (seed = 0; seed < 30; seed++) {
		char tag[DISKS_TAG];
		Subdivision s;
		Chosen c;
		Disk d;

		if (disks_random(seed, DISKS_FLAT, &d, tag))
			continue;
		c = choose_points(&d, seed);
		assert_int_equal(subdivision_init(&s, &d), 0);
		assert_int_equal(subdivision_add(&s, c.n, c.point), c.apart);
		for (f = 0; f < s.d.m.nf; f++)
			assert_true(area(&s.d.m, f) > -1e-14);
		free(c.point);
		subdivision_free(&s);
		disk_free(&d);
	}
}

static void
nothing_to_add(void **state)
{
	SynthDomain dom;
	Subdivision s;
	Synth y;
	Disk d;

	(void)state;
	synth_disk("face", 100, &y, &dom, &d, NULL);
	assert_int_equal(subdivision_init(&s, &d), 0);
	assert_int_equal(subdivision_add(&s, 0, NULL), 0);
	assert_int_equal(subdivision_add(&s, 2, (SurfacePoint[]){ subdivision_on_side(4, 0),
		subdivision_on_side(7, 1) }), 0);
	assert_int_equal(s.d.m.nv, d.m.nv);
	assert_memory_equal(s.d.m.tri, d.m.tri, 3*d.m.nf*sizeof *d.m.tri);
	assert_true(disks_is_disk(&s.d));
	subdivision_free(&s);
	disk_free(&d);
}

/* Linear functions are also extended exactly if faces are split after points were added: first some
 * faces, then all. */
static void
refined_is_linear(void **state)
{
	unsigned char *marked;
	SynthDomain dom;
	uint64_t seed = 3;
	Subdivision s;
	Disk d, before;
	Chosen c;
	Synth y;
	int f, nf;

	(void)state;
	synth_disk("face", 150, &y, &dom, &d, NULL);
	c = choose_points(&d, 2);
	assert_int_equal(subdivision_init(&s, &d), 0);
	assert_int_equal(subdivision_add(&s, c.n, c.point), c.apart);
	marked = malloc(s.d.m.nf);
	for (f = 0; f < s.d.m.nf; f++)
		marked[f] = rng_unit(&seed) < .3;
	assert_int_equal(subdivision_refine(&s, marked, NULL, NULL), 0);
	assert_true(disks_is_disk(&s.d));
	check_linear(&s);
	nf = s.d.m.nf;
	assert_int_equal(subdivision_refine(&s, NULL, NULL, &before), 0);
	assert_int_equal(before.m.nf, nf);
	assert_int_equal(s.d.m.nf, 4*nf);
	assert_true(disks_is_disk(&s.d) && disks_is_disk(&before));
	assert_true(fabs(mesh_area(&s.d.m)/mesh_area(&d.m) - 1) < 1e-12);
	check_linear(&s);
	free(marked), free(c.point);
	disk_free(&before);
	subdivision_free(&s);
	disk_free(&d);
}

/* Points within a triangle such that one lies on the line from a corner to another, the third is equal to the
 * first: two are added, and no triangle is flat, whatever rounding says of the second point. */
static void
points_on_a_line_with_a_corner(void **state)
{
	const double xyz[] = { 0,0,0, 1,0,0, 0,1,0, 1,1,0 };
	const int tri[] = { 0,1,2, 1,3,2 };
	uint64_t seed = 3;
	int pass, k, f;
	Disk d;

	(void)state;
	assert_int_equal(disks_of(4, xyz, 2, tri, &d), 0);
	for (pass = 0; pass < 300; pass++) {
		double a = .1 + .3*rng_unit(&seed), b = .1 + .3*rng_unit(&seed), s = .2 + .6*rng_unit(&seed);
		SurfacePoint p[3] = { { 0, { 1 - a - b, a, b } }, { 0, { 0, 0, 0 } } };
		Subdivision sub;

		for (k = 0; k < 3; k++)
			p[1].w[k] = s*p[0].w[k] + (k == pass%3 ? 1 - s : 0);
		p[2] = p[0];
		assert_int_equal(subdivision_init(&sub, &d), 0);
		assert_int_equal(subdivision_add(&sub, 3, p), 2);
		assert_true(disks_is_disk(&sub.d));
		assert_int_equal(sub.d.m.nf, 6);
		for (f = 0; f < sub.d.m.nf; f++) {
			double x[3], y[3], n[3];
			const int *c = &sub.d.m.tri[3*f];

			sub3(&sub.d.m.xyz[3*c[1]], &sub.d.m.xyz[3*c[0]], x);
			sub3(&sub.d.m.xyz[3*c[2]], &sub.d.m.xyz[3*c[0]], y);
			cross3(x, y, n);
			assert_true(n[2] > 1e-4);
		}
		subdivision_free(&sub);
	}
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(points_are_added),
		cmocka_unit_test(no_triangle_is_turned),
		cmocka_unit_test(nothing_to_add),
		cmocka_unit_test(points_on_a_line_with_a_corner),
		cmocka_unit_test(refined_is_linear),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
