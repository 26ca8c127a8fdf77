/* test_untangle.c - untangle.h: no triangle is turned over, whatever the places were, and vertices
 * away from turned triangles keep theirs; the same across fold and seam of a sock; carry.h: points stay
 * inside. */
#include "cmock.h"

#include <math.h>
#include <string.h>

#include "../lib/base/sheet.h"
#include "../lib/base/sockplane.h"
#include "../lib/map/carry.h"
#include "../lib/map/corners.h"
#include "../lib/map/untangle.h"
#include "../lib/synth/rng.h"
#include "disks.h"
#include "synthdisk.h"

/* A disk with places in the rectangle. */
typedef struct Placed {
	Disk    d;
	int     corner[4];
	double  T, *u, *v;
} Placed;

static void
set_room(Placed *c)
{
	c->u = malloc(c->d.m.nv*sizeof *c->u);
	c->v = malloc(c->d.m.nv*sizeof *c->v);
	assert_true(c->u && c->v);
}

static void
placed_free(Placed *c)
{
	disk_free(&c->d);
	free(c->u);
	free(c->v);
}

/* A rectangle with about n vertices at their own places. */
static void
rectangle(int n, Placed *c)
{
	SynthDomain dom;
	double *xy;
	int i, k;
	Synth s;

	synth_disk("rectangle", n, &s, &dom, &c->d, &xy);
	set_room(c);
	c->T = dom.y1/dom.x1;
	for (i = 0; i < c->d.m.nv; i++)
		c->u[i] = xy[2*i]/dom.x1, c->v[i] = xy[2*i+1]/dom.x1;
	for (i = 0; i < c->d.nb; i++)
		for (k = 0; k < 4; k++)
			if (c->d.loop[i] == k)
				c->corner[k] = i;
	free(xy);
}

static int
turned(const Placed *c)
{
	int thin;

	return disks_turned(&c->d, c->u, c->v, &thin);
}

/* Untangles; checks that nothing is turned over, and that the boundary is that of the rectangle. */
static void
check(Placed *c, Untangled *r)
{
	const Disk *d = &c->d;
	UntangleChart on = { &CHART_RECTANGLE, c->T, .cone = { -1, -1 } };
	int k, i;

	memcpy(on.corner, c->corner, sizeof on.corner);
	assert_int_equal(untangle(d, &on, c->u, c->v, r), 0);
	assert_int_equal(r->turned, 0);
	assert_int_equal(turned(c), 0);
	for (k = 0; k < 4; k++)
		for (i = c->corner[k]; i != c->corner[(k+1)%4]; i = (i + 1)%d->nb) {
			const double *x = k%2 ? c->v : c->u, *y = k%2 ? c->u : c->v;
			double fixed = k == 0 || k == 3 ? 0 : k == 1 ? 1 : c->T;
			double step = x[d->loop[(i + 1)%d->nb]] - x[d->loop[i]];

			assert_true(y[d->loop[i]] == fixed && y[d->loop[(i + 1)%d->nb]] == fixed);
			assert_true(k < 2 ? step >= 0 : step <= 0);
		}
}

/* The vertices that are not where they were. */
static int
moved(const Placed *c, const double *u, const double *v)
{
	int i, n = 0;

	for (i = 0; i < c->d.m.nv; i++)
		n += c->u[i] != u[i] || c->v[i] != v[i];
	return n;
}

static double *
copy(const Placed *c, const double *x)
{
	double *y = malloc(c->d.m.nv*sizeof *y);

	assert_non_null(y);
	return memcpy(y, x, c->d.m.nv*sizeof *y);
}

/* A vertex moved out of the ring of its neighbours turns triangles over.  Only vertices near it
 * move. */
static void
one_vertex(void **state)
{
	int i, inner = -1;
	double *u, *v;
	Untangled r;
	Placed c;

	(void)state;
	rectangle(2000, &c);
	u = copy(&c, c.u), v = copy(&c, c.v);
	check(&c, &r);
	assert_true(r.moved == 0 && r.farthest == 0 && moved(&c, u, v) == 0);
	for (i = 0; i < c.d.m.nv; i++)
		if (fabs(c.u[i] - 0.5) < 0.02 && fabs(c.v[i] - 0.3) < 0.02)
			inner = i;
	assert_true(inner >= 0);
	c.u[inner] = u[inner] += 0.08;
	assert_true(turned(&c) > 0);
	check(&c, &r);
	assert_true(moved(&c, u, v) == r.moved && r.moved > 0 && r.moved <= 12 && r.farthest < 0.1);
	placed_free(&c);
	free(u), free(v);
}

/* Needles, 100 times as long as wide, bent by the map: their straight sides cross.  n columns of
 * vertices, in rows that are shifted by half a needle. */
static void
needles(int n, int rows, Placed *c)
{
	double *xyz = calloc(3*n*rows, sizeof *xyz);
	int *tri = malloc(6*n*rows*sizeof *tri), nf = 0, i, j, k;

	for (j = 0; j < rows; j++)
		for (i = 0; i < n; i++) {
			xyz[3*(j*n + i)] = i + (i > 0 && i < n - 1 && j%2 ? 0.5 : 0);
			xyz[3*(j*n + i)+1] = 0.01*j;
		}
	for (j = 0; j < rows - 1; j++)
		for (i = 0; i < n - 1; i++, nf += 2) {
			const int p = j*n + i, q[6] = { p, p + 1, p + 1 + n, p, p + 1 + n, p + n };
			const int s[6] = { p, p + 1, p + n, p + 1, p + 1 + n, p + n };

			memcpy(&tri[3*nf], j%2 ? q : s, sizeof q);
		}
	assert_int_equal(disks_of(n*rows, xyz, nf, tri, &c->d), 0);
	set_room(c);
	c->T = 1;
	for (k = 0; k < c->d.m.nv; k++) {
		const double x = c->d.m.xyz[3*k]/(n - 1), y = c->d.m.xyz[3*k+1]/(0.01*(rows - 1));

		c->u[k] = x;
		c->v[k] = y + 0.8*y*(1 - y)*sin(3*M_PI*x);
	}
	for (k = 0; k < c->d.nb; k++)
		for (i = 0; i < 4; i++)
			if (c->d.loop[k] == (i == 0 ? 0 : i == 1 ? n - 1 : i == 2 ? rows*n - 1 : (rows - 1)*n))
				c->corner[i] = k;
	free(xyz);
	free(tri);
}

static void
bent_needles(void **state)
{
	double *u, *v;
	Untangled r;
	Placed c;

	(void)state;
	needles(12, 60, &c);
	u = copy(&c, c.u), v = copy(&c, c.v);
	assert_true(turned(&c) > 20);
	check(&c, &r);
	assert_true(r.moved == moved(&c, u, v) && r.moved < c.d.m.nv/3 && r.farthest < 0.05);
	placed_free(&c);
	free(u), free(v);
}

/* Places at random: then only the theorem helps. */
static void
random_places(void **state)
{
	uint64_t seed, rng = 1;
	char tag[DISKS_TAG];
	int i, disks = 0;
	Untangled r;
	Placed c;

	(void)state;
	for (seed = 0; seed < 30; seed++) {
		if (disks_random(seed, DISKS_ANY, &c.d, tag))
			continue;
		if (c.d.m.nv > 300 || corners_auto(&c.d, c.corner) < 0) {
			disk_free(&c.d);
			continue;
		}
		set_room(&c);
		c.T = 0.7;
		for (i = 0; i < c.d.m.nv; i++)
			c.u[i] = rng_unit(&rng), c.v[i] = 0.7*rng_unit(&rng);
		check(&c, &r);
		disks++;
		placed_free(&c);
	}
	assert_true(disks >= 10);
}

/* A limb shrinks like exp(-s) towards its tip, whose places differ by a few units in the last place,
 * and are not more accurate than that.  It is drawn so that nothing is turned over, and no vertex
 * moves farther than is visible. */
static void
limb_too_small(void **state)
{
	uint64_t rng = 1;
	Untangled r;
	Placed c;
	int i;

	(void)state;
	rectangle(5000, &c);
	for (i = 0; i < c.d.m.nv; i++) {
		double x = c.u[i] - 0.6, y = c.v[i] - 0.3, far = hypot(x, y);
		double s = far < 0.2 ? 1e-14 : far < 0.3 ? pow(10, (far - 0.3)*140) : 1;

		c.u[i] = 0.6 + s*x + (far < 0.2 ? 3e-16*rng_unit(&rng) : 0);
		c.v[i] = 0.3 + s*y + (far < 0.2 ? 3e-16*rng_unit(&rng) : 0);
	}
	assert_true(turned(&c) > 0);
	check(&c, &r);
	assert_true(r.farthest < 1e-6);
	placed_free(&c);
}

/* Behind the inner edge between two vertices of one side lies an inner vertex: a straight map cannot
 * keep it from turning a triangle over unless it moves to the side. */
static void
pocket(void **state)
{
	static const double xyz[] = { 0, 0, 0,  1, 0, 0,  2, 0, 0,  3, 0, 0,  3, 2, 0,  0, 2, 0,
		1.5, .1, 0,  1.5, 1, 0,  1.5, 0, 0 };
	static const int tri[] = { 1, 8, 6,  8, 2, 6,  2, 1, 6,  1, 2, 7,  0, 1, 7,  2, 3, 7,  3, 4, 7,
		4, 5, 7,  5, 0, 7 };
	static const int vertex[4] = { 0, 3, 4, 5 };
	Untangled r;
	Placed c;
	int i, at;

	(void)state;
	assert_int_equal(disks_of(9, xyz, sizeof tri/sizeof *tri/3, tri, &c.d), 0);
	assert_int_equal(corners_given(&c.d, vertex, c.corner, &at), 0);
	set_room(&c);
	c.T = 2/3.;
	for (i = 0; i < 9; i++)
		c.u[i] = xyz[3*i]/3, c.v[i] = xyz[3*i+1]/3;
	assert_int_equal(turned(&c), 1);
	check(&c, &r);
	assert_true(r.moved == 1 && c.v[6] == 0);
	placed_free(&c);
}

/* Vertices of a side whose places are not in its order, and two at the same place. */
static void
side_out_of_order(void **state)
{
	Untangled r;
	Placed c;
	int i, k;

	(void)state;
	rectangle(500, &c);
	k = c.corner[0] + 3;
	i = c.d.loop[k%c.d.nb];
	c.u[i] = c.u[c.d.loop[(k + 1)%c.d.nb]] + 1e-3;
	i = c.d.loop[(k + 5)%c.d.nb];
	c.u[i] = c.u[c.d.loop[(k + 6)%c.d.nb]];
	check(&c, &r);
	assert_true(r.farthest < 0.1 && r.moved < 20);
	placed_free(&c);
}

/* The result does not depend on how vertices are numbered. */
static void
renumbered(void **state)
{
	Untangled r, s;
	Placed c, o;
	int *number, i;

	(void)state;
	needles(12, 60, &c);
	o = c;
	number = malloc(c.d.m.nv*sizeof *number);
	assert_non_null(number);
	assert_int_equal(disks_renumbered(&c.d, 5, &o.d, number), 0);
	set_room(&o);
	for (i = 0; i < c.d.m.nv; i++)
		o.u[number[i]] = c.u[i], o.v[number[i]] = c.v[i];
	for (i = 0; i < 4; i++)
		for (o.corner[i] = 0; o.d.loop[o.corner[i]] != number[c.d.loop[c.corner[i]]]; o.corner[i]++)
			;
	check(&c, &r);
	check(&o, &s);
	assert_int_equal(r.moved, s.moved);
	for (i = 0; i < c.d.m.nv; i++)
		assert_true(hypot(o.u[number[i]] - c.u[i], o.v[number[i]] - c.v[i]) < 1e-9);
	placed_free(&c);
	placed_free(&o);
	free(number);
}

/* ---- on a sock ------------------------------------------------------- */

typedef struct Sock {
	Placed        c;
	UntangleChart on;
} Sock;

static double complex
moved_to_0(double complex a, double complex z)
{
	return (z - a)/(1 - conj(a)*z);
}

/* The inner vertex nearest to z. */
static int
nearest(const Disk *d, const double complex *at, double complex z)
{
	int i, best = -1;

	for (i = 0; i < d->m.nv; i++)
		if (cabs(at[i]) < 0.99 && (best < 0 || cabs(at[i] - z) < cabs(at[best] - z)))
			best = i;
	return best;
}

/* A cap with about n vertices at their own places on a sock. */
static void
sock(int n, Sock *s)
{
	SynthDomain dom;
	double *xy, rho;
	double complex *z, b, w;
	SockPlane plane;
	Placed *c = &s->c;
	Synth kind;
	int i, k;

	synth_disk("cap", n, &kind, &dom, &c->d, &xy);
	set_room(c);
	z = malloc(c->d.m.nv*sizeof *z);
	assert_non_null(z);
	for (i = 0; i < c->d.m.nv; i++)
		z[i] = CMPLX(xy[2*i], xy[2*i+1])/dom.x1;
	s->on = (UntangleChart){ .kind = &CHART_SOCK,
		.cone = { nearest(&c->d, z, 0.3 + 0.2*I), nearest(&c->d, z, -0.4 + 0.1*I) } };
	b = moved_to_0(z[s->on.cone[0]], z[s->on.cone[1]]);
	rho = cabs(b);
	plane = sockplane(s->on.T = c->T = sockplane_height(rho));
	for (i = 0; i < c->d.m.nv; i++) {
		w = moved_to_0(plane.s, moved_to_0(z[s->on.cone[0]], z[i])*rho/b);
		sockplane_uv(&plane, cabs(w) > 1 ? w/cabs(w) : w, &c->u[i], &c->v[i]);
	}
	for (i = 0; i < c->d.nb; i++) {
		c->v[c->d.loop[i]] = c->T;
		for (k = 0; k < 4; k++)
			if (c->d.loop[i] == k)
				s->on.corner[k] = i;
	}
	free(xy);
	free(z);
}

/* The triangles that are turned over, each drawn on one sheet. */
static int
turned_on_sheets(const Placed *c)
{
	double x[3], y[3];
	Sheet s[3];
	int t, k, n = 0;

	for (t = 0; t < c->d.m.nf; t++) {
		for (k = 0; k < 3; k++)
			x[k] = c->u[c->d.m.tri[3*t+k]], y[k] = c->v[c->d.m.tri[3*t+k]];
		sheet_polygon(3, x, y, s);
		for (k = 0; k < 3; k++)
			x[k] = sheet_u(s[k], x[k]), y[k] = sheet_v(s[k], y[k]);
		n += (x[1] - x[0])*(y[2] - y[0]) < (x[2] - x[0])*(y[1] - y[0]);
	}
	return n;
}

/* Untangles; checks that nothing is turned over, that all is in the chart and the cones at their places,
 * and that u falls along the boundary. */
static void
check_sock(Sock *s, Untangled *r)
{
	Placed *c = &s->c;
	double step;
	int i;

	assert_int_equal(untangle(&c->d, &s->on, c->u, c->v, r), 0);
	assert_int_equal(r->turned, 0);
	assert_int_equal(turned_on_sheets(c), 0);
	for (i = 0; i < c->d.m.nv; i++)
		assert_true(c->u[i] >= 0 && c->u[i] < 1 && c->v[i] >= 0 && c->v[i] <= c->T);
	for (i = 0; i < 2; i++)
		assert_true(c->u[s->on.cone[i]] == i*0.5 && c->v[s->on.cone[i]] == 0);
	for (i = 0; i < c->d.nb; i++) {
		step = c->u[c->d.loop[i]] - c->u[c->d.loop[(i + 1)%c->d.nb]];
		assert_true(c->v[c->d.loop[i]] == c->T && step - floor(step) < 0.5);
	}
}

/* Moves the vertex whose place is nearest to (u,v) by (du,dv), and untangles. */
static void
move_on_sock(double u, double v, double du, double dv)
{
	double *before[2];
	Untangled r;
	Placed *c;
	Sock s;
	int i, best = -1;

	sock(2000, &s);
	c = &s.c;
	check_sock(&s, &r);
	for (i = 0; i < c->d.m.nv; i++)
		if (i != s.on.cone[0] && i != s.on.cone[1]
		    && (best < 0 || hypot(c->u[i] - u, c->v[i] - v) < hypot(c->u[best] - u, c->v[best] - v)))
			best = i;
	c->u[best] += du, c->v[best] += dv;
	if (c->v[best] < 0)
		c->u[best] *= -1, c->v[best] *= -1;
	c->u[best] -= floor(c->u[best]);
	assert_true(turned_on_sheets(c) > 0);
	before[0] = copy(c, c->u), before[1] = copy(c, c->v);
	check_sock(&s, &r);
	assert_true(r.moved == moved(c, before[0], before[1]) && r.moved > 0 && r.moved <= 20);
	assert_true(r.farthest < 0.12);
	placed_free(c);
	free(before[0]), free(before[1]);
}

static void
across_fold_and_seam(void **state)
{
	(void)state;
	move_on_sock(0.25, 0.15, 0.06, 0.02);           /* within a sheet */
	move_on_sock(0.25, 0.01, 0.01, -0.08);          /* across the fold */
	move_on_sock(0.99, 0.2, 0.07, 0);               /* across the seam */
	move_on_sock(0.02, 0.02, 0.08, -0.01);          /* a neighbour of a cone */
	move_on_sock(0.47, 0.02, 0, 0.08);
}

static void
boundary_of_a_sock_out_of_order(void **state)
{
	double was[2];
	Untangled r;
	Placed *c;
	Sock s;
	int i, k, *l;

	(void)state;
	for (k = 0; k < 40; k += 13) {
		sock(1000, &s);
		c = &s.c;
		l = c->d.loop;
		check_sock(&s, &r);
		for (i = 0; i < c->d.nb && !(c->u[l[i]] < c->u[l[(i + 1)%c->d.nb]]); i++)
			;                               /* i, i + 1: the seam is between them */
		i = (i + k)%c->d.nb;
		was[0] = c->u[l[i]], was[1] = c->u[l[(i + 1)%c->d.nb]];
		c->u[l[i]] = was[1], c->u[l[(i + 1)%c->d.nb]] = was[0];
		check_sock(&s, &r);
		assert_true(r.moved > 0 && r.moved < 20 && r.farthest < 0.1);
		placed_free(c);
	}
}

/* Adds a pocket to a sock: behind edge k of its loop a vertex of the boundary and an inner one. */
static void
add_pocket(Sock *s, int k)
{
	Placed *c = &s->c, old = *c;
	const Mesh *m = &old.d.m;
	const int nv = m->nv, nf = m->nf, p = old.d.loop[k], q = old.d.loop[(k + 1)%old.d.nb];
	const int more[9] = { q, p, nv + 1,  p, nv, nv + 1,  nv, q, nv + 1 };
	double *xyz = malloc(3*(nv + 2)*sizeof *xyz);
	int *tri = malloc((3*nf + 9)*sizeof *tri), i, r;

	assert_true(xyz && tri);
	memcpy(xyz, m->xyz, 3*nv*sizeof *xyz);
	memcpy(tri, m->tri, 3*nf*sizeof *tri);
	memcpy(tri + 3*nf, more, sizeof more);
	for (i = 0; i < 3; i++) {
		xyz[3*nv+i] = (xyz[3*p+i] + xyz[3*q+i])*0.6;
		xyz[3*nv+3+i] = (xyz[3*p+i] + xyz[3*q+i])*0.52;
	}
	assert_int_equal(disks_of(nv + 2, xyz, nf + 3, tri, &c->d), 0);
	set_room(c);
	memcpy(c->u, old.u, nv*sizeof *c->u);
	memcpy(c->v, old.v, nv*sizeof *c->v);
	c->u[nv] = c->u[nv+1] = c->u[q] + (c->u[p] - c->u[q] - floor(c->u[p] - c->u[q]))/2;
	c->u[nv] = c->u[nv+1] = c->u[nv] - floor(c->u[nv]);
	c->v[nv] = c->T, c->v[nv+1] = c->T - 1e-3;
	for (i = 0; i < c->d.nb; i++)
		for (r = 0; r < 4; r++)
			if (c->d.loop[i] == r)
				s->on.corner[r] = i;
	placed_free(&old);
	free(xyz), free(tri);
}

static void
pockets_of_a_sock(void **state)
{
	Untangled r;
	int k, inner;
	Sock s;

	(void)state;
	for (k = 0; k < 80; k += 7) {
		sock(1000, &s);
		check_sock(&s, &r);
		add_pocket(&s, k%s.c.d.nb);
		assert_int_equal(turned_on_sheets(&s.c), 1);
		check_sock(&s, &r);
		inner = s.c.d.m.nv - 1;
		assert_true(r.moved == 1 && s.c.v[inner] == s.c.T);
		placed_free(&s.c);
	}
}

/* Points carried along by a grid one of whose cells is turned over, and whose displacements vary so
 * much that bicubic interpolation leaves the rectangle: they stay inside, and apart. */
static void
carried_inside(void **state)
{
	const Chart g = { 9, 9, 1, &CHART_RECTANGLE };
	double du[81] = { 0 }, dv[81] = { 0 }, u[50], v[50];
	Shift s = { du, dv, 1 };
	int i;

	(void)state;
	for (i = 1; i < 8; i++)
		du[8*9+i] = -0.95*i, du[7*9+i] = -0.9*i;        /* towards the corner (0,1) */
	du[8*9+1] = -1.01;
	for (i = 0; i < 50; i++)
		u[i] = (i + 1)*1e-3, v[i] = 0.99;
	carry_points(g, &s, 50, u, v);
	for (i = 0; i < 50; i++)
		assert_true(u[i] > (i > 0 ? u[i-1] : 0) && u[i] < 1 && v[i] > 0 && v[i] < 1);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(one_vertex),
		cmocka_unit_test(bent_needles),
		cmocka_unit_test(random_places),
		cmocka_unit_test(limb_too_small),
		cmocka_unit_test(pocket),
		cmocka_unit_test(side_out_of_order),
		cmocka_unit_test(renumbered),
		cmocka_unit_test(across_fold_and_seam),
		cmocka_unit_test(boundary_of_a_sock_out_of_order),
		cmocka_unit_test(pockets_of_a_sock),
		cmocka_unit_test(carried_inside),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
