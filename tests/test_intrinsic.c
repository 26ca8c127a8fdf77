/* test_intrinsic.c - intrinsic triangulations: they are Delaunay and keep the surface; in the plane
 * their crossings with mesh edges are the true ones. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/vec3.h"
#include "../lib/intrinsic/crossings.h"
#include "../lib/intrinsic/flips.h"
#include "../lib/intrinsic/mollify.h"
#include "../lib/intrinsic/places.h"
#include "../lib/mesh/topology.h"
#include "../lib/synth/rng.h"
#include "disks.h"
#include "synthdisk.h"

static int
start(const Intrinsic *t, int e)
{
	return t->from[t->side[e]];
}

static int
end(const Intrinsic *t, int e)
{
	return t->from[intrinsic_next(t->side[e])];
}

static double
total_area(const Intrinsic *t)
{
	double sum = 0;
	int f;

	for (f = 0; f < t->nf; f++)
		sum += intrinsic_area(intrinsic_length(t, 3*f), intrinsic_length(t, 3*f + 1),
			intrinsic_length(t, 3*f + 2));
	return sum;
}

/* The sum of the angles at each vertex. */
static double *
angle_sums(const Intrinsic *t)
{
	double *sum = calloc(t->nv, sizeof *sum), above, below;
	int h;

	for (h = 0; h < 3*t->nf; h++) {
		intrinsic_cotangent_parts(t, h, &above, &below);
		sum[t->from[intrinsic_last(h)]] += atan2(below, above);
	}
	return sum;
}

/* Checks that from, twin, edge and side agree with each other. */
static void
check_sides(const Intrinsic *t)
{
	int h, e;

	for (h = 0; h < 3*t->nf; h++) {
		int g = t->twin[h];

		assert_true(t->edge[h] >= 0 && t->edge[h] < t->ne);
		assert_true(t->side[t->edge[h]] == h || t->side[t->edge[h]] == g);
		if (g < 0)
			continue;
		assert_int_equal(t->twin[g], h);
		assert_int_equal(t->edge[g], t->edge[h]);
		assert_int_equal(t->from[g], t->from[intrinsic_next(h)]);
		assert_int_equal(t->from[h], t->from[intrinsic_next(g)]);
	}
	for (e = 0; e < t->ne; e++)
		assert_int_equal(t->edge[t->side[e]], e);
}

/* Checks that cot a + cot b >= 0 for the two angles opposite to each inner edge, up to `small`
 * times max(1, |cot a| + |cot b|). */
static void
check_delaunay(const Intrinsic *t, double small)
{
	int e;

	for (e = 0; e < t->ne; e++) {
		int h = t->side[e], g = t->twin[h];
		double a, b;

		if (g < 0)
			continue;
		a = intrinsic_cotangent(t, h), b = intrinsic_cotangent(t, g);
		assert_true(a + b >= -small*fmax(1, fabs(a) + fabs(b)) || h/3 == g/3);
	}
}

static void
check_flips(const Disk *d)
{
	Intrinsic before, t;
	double *angle, *was;
	int i;

	assert_int_equal(intrinsic_init(&before, d) | intrinsic_init(&t, d), 0);
	assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
	check_sides(&t);
	check_delaunay(&t, 1e-8);
	assert_true(fabs(total_area(&t)/total_area(&before) - 1) < 1e-9);
	angle = angle_sums(&t), was = angle_sums(&before);
	for (i = 0; i < t.nv; i++)
		assert_true(fabs(angle[i] - was[i]) < 1e-9);
	free(angle), free(was);
	intrinsic_free(&before);
	intrinsic_free(&t);
}

static void
delaunay_keeps_the_surface(void **state)
{
	static const char *const kind[] = { "face", "cortex", "tooth", "spiral" };
	SynthDomain dom;
	uint64_t seed;
	size_t i;
	Synth s;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		synth_disk(kind[i], 1000, &s, &dom, &d, NULL);
		check_flips(&d);
		disk_free(&d);
	}
	for (seed = 0; seed < 60; seed++) {
		char tag[DISKS_TAG];

		if (disks_random(seed, DISKS_NICE, &d, tag))
			continue;
		check_flips(&d);
		disk_free(&d);
	}
}

/* The flips also reach a Delaunay triangulation on disks with needles, whose angles have larger
 * rounding errors. */
static void
delaunay_with_needles(void **state)
{
	uint64_t seed;

	(void)state;
	for (seed = 0; seed < 60; seed++) {
		char tag[DISKS_TAG];
		Intrinsic t;
		Disk d;

		if (disks_random(seed, DISKS_ANY, &d, tag))
			continue;
		assert_int_equal(intrinsic_init(&t, &d), 0);
		assert_int_equal(intrinsic_mollify(&t), 0);
		assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
		check_sides(&t);
		check_delaunay(&t, 1e-6);
		intrinsic_free(&t);
		disk_free(&d);
	}
}

static void
mollified_triangles_have_area(void **state)
{
	double xyz[] = { 0,0,0, 1,0,0, 1,1,0, 0,1,0, .3,0,0, .5,1e-9,0 };
	int tri[] = { 0,4,5, 4,1,5, 1,2,5, 2,3,5, 3,0,5 }, f, k;
	Intrinsic t;
	Disk d;

	(void)state;
	assert_int_equal(disks_of(6, xyz, 5, tri, &d), 0);
	assert_int_equal(intrinsic_init(&t, &d), 0);
	assert_int_equal(intrinsic_mollify(&t), 0);
	for (f = 0; f < t.nf; f++)
		for (k = 0; k < 3; k++) {
			double a = intrinsic_length(&t, 3*f + k), b = intrinsic_length(&t, 3*f + (k+1)%3);
			double c = intrinsic_length(&t, 3*f + (k+2)%3);

			assert_true(b + c - a > .99e-13*fmin(a, fmin(b, c)));
		}
	intrinsic_free(&t);
	disk_free(&d);
}

/* Checks each area against that of the corners' places xy, in units of `longest`. */
static void
check_areas(const Intrinsic *t, const double *xy, double longest)
{
	int f;

	for (f = 0; f < t->nf; f++) {
		const double *a = &xy[2*t->from[3*f]], *b = &xy[2*t->from[3*f+1]], *c = &xy[2*t->from[3*f+2]];
		double area = ((b[0] - a[0])*(c[1] - a[1]) - (c[0] - a[0])*(b[1] - a[1]))/2;

		assert_true(fabs(t->area[f]*longest*longest - area) < 1e-15);
	}
}

/* A triangle of height 1e-6 within a tilted square: its area is right to the rounding errors of the
 * coordinates, although lengths tell the height to 1e-10 only; so are the areas after it is flipped away. */
static void
thin_triangles_keep_their_area(void **state)
{
	const double xy[] = { 0,0, 1,0, 1,1, 0,1, .2,.5, .8,.5, .5,.500001 };
	const double e[3] = { 2/3., 2/3., 1/3. }, g[3] = { -2/3., 1/3., 2/3. };
	int tri[] = { 0,1,4, 1,5,4, 4,5,6, 1,2,5, 2,6,5, 2,3,6, 3,4,6, 3,0,4 }, i, k, before;
	double xyz[21];
	Intrinsic t;
	Disk d;

	(void)state;
	for (i = 0; i < 7; i++)
		for (k = 0; k < 3; k++)
			xyz[3*i + k] = xy[2*i]*e[k] + xy[2*i + 1]*g[k];
	assert_int_equal(disks_of(7, xyz, 8, tri, &d), 0);
	assert_int_equal(intrinsic_init(&t, &d), 0);
	check_areas(&t, xy, 1);
	before = t.from[8];
	assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
	assert_int_not_equal(t.from[8], before);
	check_areas(&t, xy, 1);
	intrinsic_free(&t);
	disk_free(&d);
}

/* Sums over the corners at vertex 0: length of the side that starts there, dot product, area. */
static void
sums_at_vertex(const Intrinsic *t, double sum[3])
{
	int h;

	memset(sum, 0, 3*sizeof *sum);
	for (h = 0; h < 3*t->nf; h++)
		if (t->from[h] == 0) {
			sum[0] += intrinsic_length(t, h);
			sum[1] += t->dot[h];
			sum[2] += t->area[h/3];
		}
}

/* If the edges at a vertex are halved 28 times, the triangles there are exactly similar to the given ones, although
 * they are smaller than the rounding errors of their coordinates, 1e-16, times 1e8. */
static void
short_edges_keep_their_digits(void **state)
{
	const double xyz[] = { .1,.2,.7, 1.3,.1,.3, .9,1.1,.4, -.7,.8,.6, -.8,-.9,.3, .6,-1.2,.2 };
	const int tri[] = { 0,1,2, 0,2,3, 0,3,4, 0,4,5, 0,5,1 };
	double was[3], is[3];
	SurfacePoint point[16];
	Intrinsic given, t;
	Subdivision s;
	int h, k, n;
	Disk d;

	(void)state;
	assert_int_equal(disks_of(6, xyz, 5, tri, &d), 0);
	assert_int_equal(subdivision_init(&s, &d), 0);
	for (k = 0; k < 28; k++) {
		for (n = 0, h = 0; h < 3*s.d.m.nf; h++)
			if (s.d.m.tri[h] == 0)
				point[n++] = subdivision_on_side(h, .5);
		assert_int_equal(subdivision_add(&s, n, point), 5);
	}
	assert_int_equal(intrinsic_init(&given, &d) | intrinsic_init_subdivision(&t, &s), 0);
	sums_at_vertex(&given, was), sums_at_vertex(&t, is);
	for (k = 0; k < 3; k++)
		assert_true(fabs(ldexp(is[k], k ? 56 : 28)/was[k] - 1) < 1e-14);
	intrinsic_free(&given);
	intrinsic_free(&t);
	subdivision_free(&s);
	disk_free(&d);
}

enum { SPOKES = 6, STEPS = 30, NEEDLED = 1 + SPOKES + 2*STEPS };

/* A hexagon with its middle, vertex 0, at the origin.  Two opposite ones of its spokes are halved again and again
 * towards the middle; these points are joined to the ends of the neighbouring spokes by needles. */
static void
make_needles(double xyz[NEEDLED][3], Disk *d)
{
	int tri[2*SPOKES*STEPS][3], s, k, n = 0;

	memset(xyz, 0, 3*NEEDLED*sizeof(double));
	for (s = 0; s < SPOKES; s++) {
		double *end = xyz[1 + s];

		end[0] = (1 + .1*s)*cos(s + .2*sin(3*s)), end[1] = (1 + .1*s)*sin(s + .2*sin(3*s));
		for (k = 0; k < STEPS && s%3 == 0; k++) {
			double *x = xyz[1 + SPOKES + STEPS*(s/3) + k];

			x[0] = ldexp(end[0], -k - 1), x[1] = ldexp(end[1], -k - 1);
		}
	}
	for (s = 0; s < SPOKES; s++) {
		int a = 1 + s, b = 1 + (s + 1)%SPOKES, halved = s%3 == 0 ? s : (s + 1)%SPOKES;
		int next = 1 + SPOKES + STEPS*(halved/3);

		for (k = 0; k < STEPS && halved%3 == 0; k++, next++) {
			memcpy(tri[n++], (int[]){ a, b, next }, sizeof tri[0]);
			*(halved == s ? &a : &b) = next;
		}
		memcpy(tri[n++], (int[]){ a, b, 0 }, sizeof tri[0]);
	}
	assert_int_equal(disks_of(NEEDLED, xyz[0], n, tri[0], d), 0);
}

/* Flips that lead from needles, 1e9 times as long as wide, to well shaped triangles: lengths and angles do not lose
 * digits on the way. */
static void
needles_keep_their_angles(void **state)
{
	double xyz[NEEDLED][3], unit;
	Intrinsic t;
	Disk d;
	int h;

	(void)state;
	make_needles(xyz, &d);
	assert_int_equal(intrinsic_init(&t, &d), 0);
	unit = hypot(xyz[t.from[0]][0] - xyz[t.from[1]][0], xyz[t.from[0]][1] - xyz[t.from[1]][1])/intrinsic_length(&t, 0);
	assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
	for (h = 0; h < 3*t.nf; h++) {
		const double *o = xyz[t.from[h]], *p = xyz[t.from[intrinsic_next(h)]], *q = xyz[t.from[intrinsic_last(h)]];
		double l = hypot(p[0] - o[0], p[1] - o[1])/unit, m = hypot(q[0] - o[0], q[1] - o[1])/unit;
		double dot = ((p[0] - o[0])*(q[0] - o[0]) + (p[1] - o[1])*(q[1] - o[1]))/(unit*unit);

		assert_true(fabs(intrinsic_length(&t, h)/l - 1) < 1e-12);
		assert_true(fabs(t.dot[h] - dot) < 1e-12*l*m);
	}
	intrinsic_free(&t);
	disk_free(&d);
}

/* Four vertices of which three lie on a line, but so near together that angles count as those of a cocircular
 * quadrilateral: no key makes these three a triangle. */
static void
no_key_makes_a_flat_triangle(void **state)
{
	const double xyz[] = { 0,0,0, 4e-9,0,0, 8e-9,0,0, 0,1,0 }, key[] = { 0, 1, 0, 1 };
	const int tri[] = { 0,1,3, 1,2,3 };
	Intrinsic t;
	Disk d;

	(void)state;
	assert_int_equal(disks_of(4, xyz, 2, tri, &d), 0);
	assert_int_equal(intrinsic_init(&t, &d), 0);
	assert_int_equal(intrinsic_delaunay(&t, key), 0);
	assert_true(t.area[0] > 1e-9 && t.area[1] > 1e-9);
	intrinsic_free(&t);
	disk_free(&d);
}

/* Shears the disk and stretches it tenfold, so that its triangulation is far from Delaunay. */
static void
shear(Disk *d)
{
	int i;

	for (i = 0; i < d->m.nv; i++) {
		double *x = &d->m.xyz[3*i];

		x[0] = 10*(x[0] + .3*x[1]);
	}
}

static double
orientation(const double *a, const double *b, const double *c)
{
	return (b[0] - a[0])*(c[1] - a[1]) - (b[1] - a[1])*(c[0] - a[0]);
}

/* A crossing of an edge of the intrinsic triangulation with edge number `mesh` of the mesh; on_edge
 * and on_mesh are its positions on both, from 0 to 1. */
typedef struct PlaneCrossing {
	int    mesh;
	double on_edge, on_mesh;
} PlaneCrossing;

static int
along_edge(const void *a, const void *b)
{
	const PlaneCrossing *p = a, *q = b;

	return p->on_edge < q->on_edge ? -1 : p->on_edge > q->on_edge;
}

/* Finds the crossings of edge e with all edges of the mesh, for a disk in the plane, where all
 * edges are straight.  Returns their number. */
static int
cross_all(const Intrinsic *t, const Disk *d, int e, PlaneCrossing *c)
{
	const double *x = d->m.xyz, *a = &x[3*start(t, e)], *b = &x[3*end(t, e)];
	int i, n = 0;

	for (i = 0; i < t->ne; i++) {
		int from = d->m.tri[t->mesh_side[i]], to = d->m.tri[topology_next(t->mesh_side[i])];
		double pa, pb, qa, qb;

		if (from == start(t, e) || from == end(t, e) || to == start(t, e) || to == end(t, e))
			continue;
		pa = orientation(&x[3*from], &x[3*to], a), pb = orientation(&x[3*from], &x[3*to], b);
		qa = orientation(a, b, &x[3*from]), qb = orientation(a, b, &x[3*to]);
		if ((pa > 0) != (pb > 0) && (qa > 0) != (qb > 0))
			c[n++] = (PlaneCrossing){ i, pa/(pa - pb), qa/(qa - qb) };
	}
	qsort(c, n, sizeof *c, along_edge);
	return n;
}

/* Checks lengths and crossings on a disk in the plane.  Returns the number of crossings. */
static size_t
check_plane(const Disk *d)
{
	double longest = 0, length, x[3];
	PlaneCrossing *c;
	Intrinsic t;
	Places p;
	size_t all;
	int e, k, n;

	assert_int_equal(intrinsic_init(&t, d), 0);
	c = malloc(t.ne*sizeof *c);
	for (e = 0; e < t.ne; e++) {
		sub3(&d->m.xyz[3*start(&t, e)], &d->m.xyz[3*end(&t, e)], x);
		longest = fmax(longest, norm3(x));
		assert_int_equal(t.mesh_from[e], start(&t, e));
	}
	assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
	assert_int_equal(places_init(&t, &p), 0);
	for (e = 0; e < t.ne; e++) {
		sub3(&d->m.xyz[3*start(&t, e)], &d->m.xyz[3*end(&t, e)], x);
		length = norm3(x)/longest;
		assert_true(fabs(t.length[e] - length) < 1e-9*fmax(1, length));
		n = cross_all(&t, d, e, c);
		assert_int_equal(t.crossings[e], n);
		assert_int_equal(p.first[e+1] - p.first[e], n);
		if (t.along[e] >= 0) {
			int h = t.mesh_side[t.along[e]], from = d->m.tri[h], to = d->m.tri[topology_next(h)];

			assert_int_equal(n, 0);
			assert_true((from == start(&t, e) && to == end(&t, e)) ||
				(to == start(&t, e) && from == end(&t, e)));
		}
		for (k = 0; k < n; k++) {
			assert_int_equal(t.crossing[e][k], c[k].mesh);
			assert_true(fabs(p.on_edge[p.first[e] + k] - c[k].on_edge) < 1e-8);
			assert_true(fabs(p.on_mesh[p.first[e] + k] - c[k].on_mesh) < 1e-8);
		}
	}
	all = p.first[t.ne];
	free(c);
	places_free(&p);
	intrinsic_free(&t);
	return all;
}

static void
crossings_of_the_plane(void **state)
{
	static const char *const kind[] = { "rectangle", "sector", "lshape" };
	SynthDomain dom;
	uint64_t seed;
	size_t i, all = 0;
	Synth s;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		synth_disk(kind[i], 300, &s, &dom, &d, NULL);
		shear(&d);
		assert_true(check_plane(&d) > (size_t)d.m.nf);
		disk_free(&d);
	}
	for (seed = 0; seed < 40; seed++) {
		char tag[DISKS_TAG];

		if (disks_random(seed, DISKS_FLAT, &d, tag))
			continue;
		/* not on lattices of squares, where edges could pass through vertices */
		if (d.m.nf < 1000 && strncmp(tag, "grid", 4) != 0) {
			shear(&d);
			all += check_plane(&d);
		}
		disk_free(&d);
	}
	assert_true(all > 1000);
}

/* The pieces into which mesh edges divide a triangle account for all crossings of its sides. */
static void
pieces_use_all_crossings(void **state)
{
	SynthDomain dom;
	Intrinsic t;
	Synth s;
	Disk d;
	int f, k;

	(void)state;
	synth_disk("face", 1000, &s, &dom, &d, NULL);
	shear(&d);
	assert_int_equal(intrinsic_init(&t, &d), 0);
	assert_int_equal(intrinsic_delaunay(&t, NULL), 0);
	for (f = 0; f < t.nf; f++) {
		Pieces p = crossings_pieces(&t, f);

		for (k = 0; k < 3; k++)
			assert_int_equal(p.round[k] + p.round[(k+1)%3] + p.start[(k+2)%3], t.crossings[t.edge[3*f+k]]);
		assert_true(!p.start[0] + !p.start[1] + !p.start[2] >= 2);
	}
	intrinsic_free(&t);
	disk_free(&d);
}

/* An edge as its two vertices, the smaller number first. */
typedef struct Pair {
	int a, b;
} Pair;

static int
by_vertices(const void *a, const void *b)
{
	const Pair *p = a, *q = b;

	return p->a != q->a ? (p->a < q->a ? -1 : 1) : (p->b > q->b) - (p->b < q->b);
}

/* The sorted edges of the Delaunay triangulation.  If number is not NULL, vertex i has the number
 * number[i] in the result. */
static Pair *
edges_of(const Disk *d, const double *key, const int *number, int *ne)
{
	Intrinsic t;
	Pair *pair;
	int e;

	assert_int_equal(intrinsic_init(&t, d), 0);
	assert_int_equal(intrinsic_delaunay(&t, key), 0);
	pair = malloc(t.ne*sizeof *pair);
	for (e = 0; e < t.ne; e++) {
		int a = start(&t, e), b = end(&t, e);

		a = number ? number[a] : a, b = number ? number[b] : b;
		pair[e] = a < b ? (Pair){ a, b } : (Pair){ b, a };
	}
	qsort(pair, t.ne, sizeof *pair, by_vertices);
	*ne = t.ne;
	intrinsic_free(&t);
	return pair;
}

/* A key for each vertex that depends only on its position. */
static double *
keys_of(const Disk *d)
{
	double *key = malloc(d->m.nv*sizeof *key);
	int i;

	for (i = 0; i < d->m.nv; i++) {
		const double *x = &d->m.xyz[3*i];

		key[i] = hypot(x[0] + 1, x[1] + 1.7) + 1.01*hypot(x[0] - 40, x[1] + 2) + 1.03*hypot(x[1] - 30, x[2]);
	}
	return key;
}

static void
check_order(const Disk *d, uint64_t seed, int keys)
{
	int *number = malloc(d->m.nv*sizeof *number), *back = malloc(d->m.nv*sizeof *back), i, n, n1, n2;
	double *key = keys ? keys_of(d) : NULL, *key1 = NULL;
	Pair *pair, *pair1, *pair2;
	Disk one, two;

	assert_int_equal(disks_renumbered(d, seed, &one, number), 0);
	for (i = 0; i < d->m.nv; i++)
		back[number[i]] = i;
	assert_int_equal(disks_reordered(d, seed, &two), 0);
	key1 = keys ? keys_of(&one) : NULL;
	pair = edges_of(d, key, NULL, &n);
	pair1 = edges_of(&one, key1, back, &n1);
	pair2 = edges_of(&two, key, NULL, &n2);
	assert_true(n1 == n && n2 == n);
	assert_memory_equal(pair, pair1, n*sizeof *pair);
	assert_memory_equal(pair, pair2, n*sizeof *pair);
	free(number), free(back), free(key), free(key1);
	free(pair), free(pair1), free(pair2);
	disk_free(&one), disk_free(&two);
}

/* A lattice of unit squares, each cut along a random diagonal. */
static void
make_squares(int nx, int ny, uint64_t seed, Disk *d)
{
	double *xyz = calloc(3*(nx + 1)*(ny + 1), sizeof *xyz);
	int *tri = malloc(6*nx*ny*sizeof *tri), i, n = 0;

	for (i = 0; i < (nx + 1)*(ny + 1); i++)
		xyz[3*i] = i%(nx + 1), xyz[3*i+1] = i/(nx + 1);
	for (i = 0; i < nx*ny; i++) {
		int a = i/nx*(nx + 1) + i%nx, b = a + 1, c = b + nx + 1, e = a + nx + 1;
		int t[2][6] = { { a, b, c, a, c, e }, { a, b, e, b, c, e } };

		memcpy(&tri[n], t[rng_unit(&seed) < .5], sizeof t[0]);
		n += 6;
	}
	assert_int_equal(disks_of((nx + 1)*(ny + 1), xyz, 2*nx*ny, tri, d), 0);
	free(xyz);
	free(tri);
}

/* A regular polygon of n vertices, triangulated by cutting off random ears. */
static void
make_polygon(int n, uint64_t seed, Disk *d)
{
	double *xyz = calloc(3*n, sizeof *xyz);
	int *tri = malloc(3*(n - 2)*sizeof *tri), *left = malloc(n*sizeof *left), i, k, f = 0;

	for (i = 0; i < n; i++) {
		xyz[3*i] = cos(2*M_PI*i/n), xyz[3*i+1] = sin(2*M_PI*i/n);
		left[i] = i;
	}
	for (k = n; k > 2; k--) {
		i = (int)(k*rng_unit(&seed));
		memcpy(&tri[3*f++], (int[]){ left[i], left[(i+1)%k], left[(i+2)%k] }, 3*sizeof *tri);
		i = (i + 1)%k;
		memmove(&left[i], &left[i+1], (k - 1 - i)*sizeof *left);
	}
	assert_int_equal(disks_of(n, xyz, n - 2, tri, d), 0);
	free(xyz), free(tri), free(left);
}

/* All triangulations of a regular polygon are Delaunay.  The keys alone decide which one the flips
 * reach, whichever they start from. */
static void
order_of_flips_does_not_matter(void **state)
{
	uint64_t seed;
	int n, m;
	Pair *first, *pair;
	double *key;
	Disk d;

	(void)state;
	make_polygon(24, 0, &d);
	key = keys_of(&d);
	first = edges_of(&d, key, NULL, &n);
	disk_free(&d);
	for (seed = 1; seed < 20; seed++) {
		make_polygon(24, seed, &d);
		pair = edges_of(&d, key, NULL, &m);
		assert_int_equal(m, n);
		assert_memory_equal(pair, first, n*sizeof *pair);
		free(pair);
		disk_free(&d);
	}
	free(first);
	free(key);
}

static void
order_of_the_mesh_does_not_matter(void **state)
{
	SynthDomain dom;
	uint64_t seed;
	Synth s;
	Disk d;

	(void)state;
	synth_disk("cortex", 2000, &s, &dom, &d, NULL);
	check_order(&d, 1, 0);
	disk_free(&d);
	for (seed = 0; seed < 10; seed++) {
		make_squares(14, 9, seed, &d);
		check_order(&d, seed, 1);
		disk_free(&d);
	}
	for (seed = 0; seed < 40; seed++) {
		char tag[DISKS_TAG];

		if (disks_random(seed, DISKS_NICE, &d, tag))
			continue;
		check_order(&d, seed, 1);
		disk_free(&d);
	}
}

/* Whether the disk has an edge between a and b. */
static int
has_edge(const Disk *d, int a, int b)
{
	int h;

	for (h = 0; h < 3*d->m.nf; h++) {
		int from = d->m.tri[h], to = d->m.tri[topology_next(h)];

		if ((from == a && to == b) || (from == b && to == a))
			return 1;
	}
	return 0;
}

/* cot a + cot b of the two angles opposite to half-edge h, from the positions of the vertices. */
static double
cotangents(const Disk *d, int h)
{
	double sum = 0, x[3], y[3], n[3];
	int k, side[2] = { h, d->twin[h] };

	for (k = 0; k < 2; k++) {
		const int *t = d->m.tri;
		int a = side[k], b = topology_next(a), c = topology_next(b);

		sub3(&d->m.xyz[3*t[a]], &d->m.xyz[3*t[c]], x);
		sub3(&d->m.xyz[3*t[b]], &d->m.xyz[3*t[c]], y);
		cross3(x, y, n);
		sum += dot3(x, y)/norm3(n);
	}
	return sum;
}

static void
improve_moves_no_given_edge(void **state)
{
	SurfacePoint point[1500];
	SynthDomain dom;
	Subdivision s;
	uint64_t seed = 7;
	Disk d, before;
	Synth y;
	int h, n = 0, inner = 0, changed = 0;

	(void)state;
	synth_disk("face", 200, &y, &dom, &d, NULL);
	for (h = 0; h < 3*d.m.nf && n < 1400; h++) {
		if (d.twin[h] < h)
			point[n++] = subdivision_on_side(h, .1 + .8*rng_unit(&seed));
		if (h%6 == 0)
			point[n++] = (SurfacePoint){ h/3, { .2, .3, .5 } };
	}
	assert_int_equal(subdivision_init(&s, &d), 0);
	assert_int_equal(subdivision_add(&s, n, point), n);
	assert_int_equal(disks_of(s.d.m.nv, s.d.m.xyz, s.d.m.nf, s.d.m.tri, &before), 0);
	for (h = 0; h < 3*s.d.m.nf; h++)
		inner += s.inner[h];
	assert_int_equal(intrinsic_improve(&s, NULL), 0);
	assert_true(disks_is_disk(&s.d));
	assert_memory_equal(s.d.m.xyz, before.m.xyz, 3*before.m.nv*sizeof(double));
	assert_true(fabs(mesh_area(&s.d.m)/mesh_area(&d.m) - 1) < 1e-12);
	for (h = 0; h < 3*s.d.m.nf; h++) {
		inner -= s.inner[h];
		if (s.inner[h]) {
			assert_true(cotangents(&s.d, h) > -1e-9);
			changed += !has_edge(&before, s.d.m.tri[h], s.d.m.tri[topology_next(h)]);
		} else
			assert_true(has_edge(&before, s.d.m.tri[h], s.d.m.tri[topology_next(h)]));
	}
	assert_int_equal(inner, 0);
	assert_true(changed > 100);
	subdivision_free(&s);
	disk_free(&before);
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(delaunay_keeps_the_surface),
		cmocka_unit_test(delaunay_with_needles),
		cmocka_unit_test(mollified_triangles_have_area),
		cmocka_unit_test(thin_triangles_keep_their_area),
		cmocka_unit_test(short_edges_keep_their_digits),
		cmocka_unit_test(needles_keep_their_angles),
		cmocka_unit_test(no_key_makes_a_flat_triangle),
		cmocka_unit_test(crossings_of_the_plane),
		cmocka_unit_test(pieces_use_all_crossings),
		cmocka_unit_test(order_of_flips_does_not_matter),
		cmocka_unit_test(order_of_the_mesh_does_not_matter),
		cmocka_unit_test(improve_moves_no_given_edge),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
