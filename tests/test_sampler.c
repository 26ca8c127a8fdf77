/* test_sampler.c - sampler.h: facets replace the smooth surface near flipped triangles; locate.h:
 * the corners of the chart are vertices. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/vec3.h"
#include "../lib/map/rectmap.h"
#include "../lib/sample/sampler.h"
#include "../lib/synth/delaunay.h"
#include "../lib/synth/rng.h"
#include "disks.h"

enum { POINTS = 400, A = 4, B = 5, C = POINTS };

/* The map of the test: the (u,v) of the point (x,y) of the unit square.  It has a dent in the
 * middle, which flips the thin triangle A B C in (u,v). */
static void
warp(double x, double y, double *u, double *v)
{
	double r2 = (pow(x - .5, 2) + pow(y - .5, 2))/(.15*.15);

	*u = x;
	*v = y - .04*exp(-r2)*16*x*(1 - x)*y*(1 - y);
}

/* A disk on the graph of a smooth function over the unit square.  The only vertices near the dent are
 * A, B, and C, which lies just above the middle of A B; the others are corners, random points on the
 * sides and random points inside.  *u, *v get the map. */
static void
make_dented(Disk *d, double **u, double **v)
{
	static double xy[POINTS+1][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 }, { .3, .5 }, { .7, .5 } };
	static double xyz[POINTS+1][3];
	static int tri[2*POINTS+8][3];
	uint64_t seed = 2;
	int i, f, k, nf, old[3];

	for (i = 6; i < POINTS; ) {
		double x = rng_unit(&seed), y = rng_unit(&seed);

		if (i < 70)
			x = i%4 < 2 ? i%4 : x, y = i%4 < 2 ? y : i%4 - 2;
		if (hypot(x - .5, y - .5) > .22)
			xy[i][0] = x, xy[i++][1] = y;
	}
	assert_int_equal(delaunay(POINTS, xy[0], tri[0], &nf), 0);
	xy[C][0] = .5, xy[C][1] = .52;
	for (f = 0; f < nf; f++)
		for (k = 0; k < 3; k++)
			if (tri[f][k] == A && tri[f][(k+1)%3] == B) {
				memcpy(old, tri[f], sizeof old);
				tri[f][(k+2)%3] = C;
				memcpy(tri[nf], (int[]){ B, old[(k+2)%3], C }, sizeof old);
				memcpy(tri[nf+1], (int[]){ old[(k+2)%3], A, C }, sizeof old);
			}
	nf += 2;
	for (i = 0; i <= C; i++) {
		double x = xy[i][0], y = xy[i][1];

		memcpy(xyz[i], (double[]){ x, y, .3*sin(3*x + y) + .2*x*y*y }, sizeof xyz[i]);
	}
	assert_int_equal(disks_of(C + 1, xyz[0], nf, tri[0], d), 0);
	*u = malloc((C + 1)*sizeof **u), *v = malloc((C + 1)*sizeof **v);
	for (i = 0; i <= C; i++)
		warp(xy[i][0], xy[i][1], &(*u)[i], &(*v)[i]);
}

/* The same disk and map on a finer mesh, where no triangle is flipped. */
typedef struct Fine {
	Subdivision s;
	double     *u, *v;
} Fine;

static void
make_fine(const Disk *d, Fine *f)
{
	int i;

	assert_int_equal(subdivision_init(&f->s, d), 0);
	for (i = 0; i < 4; i++)
		assert_int_equal(subdivision_refine(&f->s, NULL, NULL, NULL), 0);
	f->u = malloc(f->s.d.m.nv*sizeof *f->u), f->v = malloc(f->s.d.m.nv*sizeof *f->v);
	for (i = 0; i < f->s.d.m.nv; i++)
		warp(f->s.d.m.xyz[3*i], f->s.d.m.xyz[3*i+1], &f->u[i], &f->v[i]);
	assert_int_equal(rectmap_flipped(&f->s.d.m, f->u, f->v) + rectmap_flat(&f->s.d.m, f->u, f->v), 0);
}

enum { SIDE = 41, NODES = SIDE*SIDE };

/* Nodes at x, y, and the samples of phi and of one channel there. */
typedef struct Sampled {
	double x[NODES], y[NODES], phi[3][NODES], channel[NODES];
} Sampled;

/* Samples the smooth surface and a channel at the nodes x, y of s.  If fine is not NULL, facets
 * replace the smooth surface near flipped triangles. */
static void
sample(const Disk *d, const double *u, const double *v, const Fine *fine, Sampled *s)
{
	double f[C+1], *phi[3] = { s->phi[0], s->phi[1], s->phi[2] }, *out[1] = { s->channel };
	Channel c = { .name = "f", .n = 1, .f = f };
	Sampler sampler;
	int i;

	for (i = 0; i <= C; i++)
		f[i] = exp(d->m.xyz[3*i])*cos(2*d->m.xyz[3*i+1]);
	assert_int_equal(sampler_init(&sampler, d, u, v, 1, SAMPLER_SMOOTH), 0);
	if (fine)
		assert_int_equal(sampler_overlay(&sampler, &fine->s, fine->u, fine->v, NULL), 0);
	assert_int_equal(sampler_points(&sampler, SIDE*SIDE, s->x, s->y, phi), 0);
	assert_int_equal(sampler_channel(&sampler, &c, SIDE*SIDE, s->x, s->y, out), 0);
	sampler_free(&sampler);
}

/* Whether (x,y) is farther from the middle of the dent than every triangle at A, B or C. */
static int
is_far(const Disk *d, double x, double y)
{
	double reach = 0;
	int f, k, i;

	for (f = 0; f < d->m.nf; f++)
		for (k = 0; k < 3; k++)
			if (d->m.tri[3*f+k] == A || d->m.tri[3*f+k] == B || d->m.tri[3*f+k] == C)
				for (i = 0; i < 3; i++)
					reach = fmax(reach, hypot(d->m.xyz[3*d->m.tri[3*f+i]] - .5, d->m.xyz[3*d->m.tri[3*f+i]+1] - .5));
	return hypot(x - .5, y - .5) > reach + .05;
}

static void
facets_only_near_a_turned_triangle(void **state)
{
	static Sampled smooth, mixed;
	double *u, *v, off = 0;
	int p, c, far = 0;
	Fine fine;
	Disk d;

	(void)state;
	make_dented(&d, &u, &v);
	assert_int_equal(rectmap_flipped(&d.m, u, v), 1);
	make_fine(&d, &fine);
	for (p = 0; p < NODES; p++) {
		smooth.x[p] = mixed.x[p] = p%SIDE/(SIDE - 1.0);
		smooth.y[p] = mixed.y[p] = p/SIDE/(SIDE - 1.0);
	}
	sample(&d, u, v, NULL, &smooth);
	sample(&d, u, v, &fine, &mixed);
	for (p = 0; p < NODES; p++) {
		if (!is_far(&d, smooth.x[p], smooth.y[p])) {
			off = fmax(off, fabs(mixed.phi[2][p] - smooth.phi[2][p]));
			continue;
		}
		far++;
		for (c = 0; c < 3; c++)
			assert_true(fabs(mixed.phi[c][p] - smooth.phi[c][p]) < 1e-14);
		assert_true(fabs(mixed.channel[p] - smooth.channel[p]) < 1e-14);
	}
	assert_true(far > NODES/3 && off > 1e-3);
	free(u), free(v), free(fine.u), free(fine.v);
	subdivision_free(&fine.s);
	disk_free(&d);
}

/* Barycentric coordinates of (x,y) in triangle A B C.  Returns 1 if the point is inside it. */
static int
within(const Mesh *m, double x, double y, double w[3])
{
	const double *a = &m->xyz[3*A], *b = &m->xyz[3*B], *c = &m->xyz[3*C];
	double area = (b[0] - a[0])*(c[1] - a[1]) - (b[1] - a[1])*(c[0] - a[0]);

	w[1] = ((x - a[0])*(c[1] - a[1]) - (y - a[1])*(c[0] - a[0]))/area;
	w[2] = ((b[0] - a[0])*(y - a[1]) - (b[1] - a[1])*(x - a[0]))/area;
	w[0] = 1 - w[1] - w[2];
	return fmin(w[0], fmin(w[1], w[2])) > -1e-9;
}

/* On the flipped triangle A B C the sampled surface is the flat triangle, and the channel is
 * linear.  The nodes are the vertices of the finer mesh in A B C. */
static void
facets_at_a_turned_triangle(void **state)
{
	static Sampled s;
	double *u, *v, w[NODES][3], f[3];
	int i, k, n = 0, corner[3] = { A, B, C };
	Fine fine;
	Disk d;

	(void)state;
	make_dented(&d, &u, &v);
	make_fine(&d, &fine);
	for (i = 0; i < fine.s.d.m.nv && n < NODES; i++)
		if (within(&d.m, fine.s.d.m.xyz[3*i], fine.s.d.m.xyz[3*i+1], w[n])) {
			s.x[n] = fine.u[i];
			s.y[n++] = fine.v[i];
		}
	assert_int_equal(n, 17*18/2);
	for (i = n; i < NODES; i++)
		s.x[i] = s.y[i] = 0;
	sample(&d, u, v, &fine, &s);
	for (k = 0; k < 3; k++)
		f[k] = exp(d.m.xyz[3*corner[k]])*cos(2*d.m.xyz[3*corner[k]+1]);
	for (i = 0; i < n; i++) {
		for (k = 0; k < 3; k++)
			assert_true(fabs(s.phi[k][i] - w[i][0]*d.m.xyz[3*A+k] - w[i][1]*d.m.xyz[3*B+k] - w[i][2]*d.m.xyz[3*C+k]) < 1e-8);
		assert_true(fabs(s.channel[i] - w[i][0]*f[0] - w[i][1]*f[1] - w[i][2]*f[2]) < 1e-8);
	}
	free(u), free(v), free(fine.u), free(fine.v);
	subdivision_free(&fine.s);
	disk_free(&d);
}

/* A node at a corner of the chart gets exactly the vertex there, even if an edge passes the corner at
 * a distance of 1e-12.  Within the tolerance of the search the corner is then also in the triangle
 * beyond that edge. */
static void
corners_are_vertices(void **state)
{
	static const double at[4][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } };
	double xyz[17][3] = { { 0 } }, u[17], v[17], T = .7, bary[3];
	int tri[20][3], ring[12], nf = 0, i, k;
	Locator l;
	Disk d;

	(void)state;
	for (k = 0; k < 4; k++) {
		const double *x = at[k], *y = at[(k+1)%4], *z = at[(k+3)%4];
		double a[4][2];
		int n[4] = { k, 4 + 3*k, 5 + 3*k, 6 + 3*k };    /* corner, two on the sides, inside */

		for (i = 0; i < 2; i++) {
			a[0][i] = 0;
			a[1][i] = z[i] - x[i];
			a[2][i] = y[i] - x[i];
			a[3][i] = .1*(a[1][i] + a[2][i]);
		}
		for (i = 0; i < 4; i++) {
			double e = i == 3 ? 1 : 1e-12, far = i == 3 ? 1 : .05;

			u[n[i]] = x[0] + e*a[i][0], v[n[i]] = T*(x[1] + e*a[i][1]);
			xyz[n[i]][0] = 3*(x[0] + far*a[i][0]), xyz[n[i]][1] = 3*(x[1] + far*a[i][1]);
		}
		memcpy(tri[nf++], (int[]){ n[1], n[0], n[2] }, sizeof tri[0]);
		memcpy(tri[nf++], (int[]){ n[1], n[2], n[3] }, sizeof tri[0]);
		ring[3*k] = n[1], ring[3*k+1] = n[3], ring[3*k+2] = n[2];
	}
	u[16] = .5, v[16] = T/2, xyz[16][0] = xyz[16][1] = 1.5;
	for (i = 0; i < 12; i++)
		memcpy(tri[nf++], (int[]){ ring[i], ring[(i+1)%12], 16 }, sizeof tri[0]);
	assert_int_equal(disks_of(17, xyz[0], nf, tri[0], &d), 0);
	assert_int_equal(rectmap_flipped(&d.m, u, v), 0);
	assert_int_equal(locator_init(&l, &d, u, v, T), 0);
	for (k = 0; k < 4; k++) {
		int t = locate(&l, u[k], v[k], bary);

		for (i = 0; i < 3; i++)
			assert_true(bary[i] == (d.m.tri[3*t+i] == k));
		assert_true(bary[0] + bary[1] + bary[2] == 1);
	}
	locator_free(&l);
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(facets_only_near_a_turned_triangle),
		cmocka_unit_test(facets_at_a_turned_triangle),
		cmocka_unit_test(corners_are_vertices),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
