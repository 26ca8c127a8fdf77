/* test_corners.c - corners.h: finding corners on surfaces whose corners are known, on ragged
 * boundaries, on boundaries without corners and on flipped disks; corners from points or places. */
#include "cmock.h"

#include <math.h>
#include <stdio.h>

#include "../lib/map/corners.h"
#include "../lib/synth/rng.h"
#include "synthdisk.h"

static void
make(const char *kind, int n, Disk *d)
{
	SynthDomain dom;
	double *xy;
	Synth s;

	synth_disk(kind, n, &s, &dom, d, &xy);
	free(xy);
}

/* corners_auto finds the true corners of synthetic surfaces, which are vertices 0 1 2 3. */
static void
real_corners(void **state)
{
	static const struct { const char *kind; int n; } t[] = {
		{ "rectangle", 60 }, { "rectangle", 3000 }, { "mercator", 400 }, { "torus", 600 },
		{ "cylinder", 600 }, { "cylinder", 5000 }, { "catenoid", 600 }, { "sector", 600 },
		{ "moebius", 600 }, { "moebius", 5000 }, { "spiral", 5000 }
	};
	int corner[4], k;
	size_t i;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof t/sizeof *t; i++) {
		make(t[i].kind, t[i].n, &d);
		if (corners_auto(&d, corner) != 1)
			fail_msg("%s %d: no corners found", t[i].kind, t[i].n);
		for (k = 0; k < 4; k++)
			if (d.loop[corner[k]] != k)
				fail_msg("%s %d: corner %d is vertex %d", t[i].kind, t[i].n, k, d.loop[corner[k]]);
		disk_free(&d);
	}
}

/* On a boundary without four corners, the chosen points divide its length into quarters, up to one
 * edge length. */
static void
equal_arcs(void **state)
{
	static const char *const kind[] = { "cap", "tooth", "face", "enneper", "lshape", "cortex" };
	double s[5], a, longest;
	int corner[4], i, k;
	size_t n;
	Disk d;

	(void)state;
	for (n = 0; n < sizeof kind/sizeof *kind; n++) {
		make(kind[n], 2000, &d);
		if (corners_auto(&d, corner) != 0)
			fail_msg("%s: corners found", kind[n]);
		for (a = longest = 0, i = k = 0; i <= d.nb; i++) {
			const double *x = &d.m.xyz[3*d.loop[i%d.nb]], *y = &d.m.xyz[3*d.loop[(i+1)%d.nb]];
			double e = hypot(hypot(x[0] - y[0], x[1] - y[1]), x[2] - y[2]);

			if (k < 4 ? i == corner[k] : i == d.nb)
				s[k++] = a;
			a += e;
			longest = fmax(longest, e);
		}
		assert_int_equal(corner[0], 0);
		for (k = 1; k < 4; k++)
			assert_true(fabs(s[k] - k*s[4]/4) <= longest);
		disk_free(&d);
	}
}

/* The ragged disk is a lattice of NX x NY squares.  Its boundary vertices are moved at random by up
 * to 0.4 of an edge in x and y, and every third boundary edge has an ear, a triangle with two
 * boundary edges.  Its corners are vertices A B C D. */
enum { NX = 60, NY = 40, V = (NX+1)*(NY+1), A = 0, B = NX, C = V - 1, D = V - 1 - NX };

static void
add(Soup *s, int a, int b, int c)
{
	int *t = s->idx + 3*s->nf;

	t[0] = a, t[1] = b, t[2] = c;
	s->nf++;
	s->first[s->nf] = 3*s->nf;
}

static void
ear(Soup *s, int a, int b)
{
	double *x = s->xyz + 3*s->nv;
	const double *p = s->xyz + 3*a, *q = s->xyz + 3*b;

	x[0] = (p[0] + q[0])/2 + (q[1] - p[1])/2;
	x[1] = (p[1] + q[1])/2 - (q[0] - p[0])/2;
	x[2] = 0;
	add(s, b, a, s->nv++);
}

static void
ragged(Disk *d, double scale, uint64_t seed)
{
	static double xyz[3*(V + 2*NX + 2*NY)];
	static int first[2*NX*NY + 2*NX + 2*NY + 1], idx[3*(2*NX*NY + 2*NX + 2*NY)];
	Soup s = { .nv = V, .xyz = xyz, .first = first, .idx = idx };
	int i, j, v, e;

	first[0] = 0;
	for (v = 0; v < V; v++) {
		i = v%(NX+1), j = v/(NX+1);
		e = i == 0 || j == 0 || i == NX || j == NY;
		xyz[3*v]   = i + e*0.8*(rng_unit(&seed) - 0.5);
		xyz[3*v+1] = j + e*0.8*(rng_unit(&seed) - 0.5);
		xyz[3*v+2] = 0;
	}
	for (j = 0; j < NY; j++)
		for (i = 0; i < NX; i++) {
			v = j*(NX+1) + i;
			add(&s, v, v+1, v+NX+2);
			add(&s, v, v+NX+2, v+NX+1);
		}
	for (i = 2; i < NX - 2; i += 3) {
		ear(&s, i, i+1);
		ear(&s, V-1 - i, V-2 - i);
	}
	for (j = 2; j < NY - 2; j += 3) {
		ear(&s, j*(NX+1) + NX, (j+1)*(NX+1) + NX);
		ear(&s, (j+1)*(NX+1), j*(NX+1));
	}
	for (i = 0; i < 3*s.nv; i++)
		xyz[i] *= scale;
	if (disk_from_soup(d, &s))
		fail_msg("%s", d->err);
}

/* The corners of the ragged disk are found within three lattice edges, whatever the unit of
 * length. */
static void
ragged_corners(void **state)
{
	static const int want[4] = { A, B, C, D };
	static const double scale[] = { 1, 1e-120, 1e120, 7e3, 3e-4 };
	int corner[4], k;
	size_t i;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof scale/sizeof *scale; i++) {
		ragged(&d, scale[i], 11 + i);
		assert_int_equal(corners_auto(&d, corner), 1);
		for (k = 0; k < 4; k++) {
			const double *x = &d.m.xyz[3*d.loop[corner[k]]], *y = &d.m.xyz[3*want[k]];

			assert_true(hypot(x[0] - y[0], x[1] - y[1]) < 3*scale[i]);
		}
		disk_free(&d);
	}
}

/* A square with a notch in its top side, where the boundary turns by 30, -60 and 30 degrees.  The
 * turn of -60 degrees must not be taken for a corner.  The same holds for the flipped surface. */
static void
notched(void **state)
{
	enum { N = 40 };
	double xyz[3*(4*N + 1)];
	int first[4*N + 1], idx[12*N], corner[4], i, k, side;
	Soup s = { .nv = 4*N + 1, .nf = 4*N, .xyz = xyz, .first = first, .idx = idx };
	Disk d;

	(void)state;
	for (i = 0; i < 4*N; i++) {
		double t = (double)(i%N)/N, *x = xyz + 3*i;

		side = i/N;
		x[0] = side == 0 ? t : side == 1 ? 1 : side == 2 ? 1 - t : 0;
		x[1] = side == 0 ? 0 : side == 1 ? t : side == 2 ? 1 : 1 - t;
		x[2] = 0;
		if (side == 2)
			x[1] -= fmax(0, 0.2 - fabs(t - 0.5))*tan(M_PI/6);
		first[i] = 3*i;
		idx[3*i] = i, idx[3*i+1] = (i + 1)%(4*N), idx[3*i+2] = 4*N;
	}
	first[4*N] = 12*N;
	xyz[12*N] = xyz[12*N+1] = 0.5, xyz[12*N+2] = 0;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	for (side = 0; side < 2; side++, disk_flip(&d)) {
		assert_int_equal(corners_auto(&d, corner), 1);
		for (k = 0; k < 4; k++)
			assert_int_equal(d.loop[corner[k]], side ? (4 - k)%4*N : k*N);
	}
	disk_free(&d);
}

/* The flipped surface has the same corners in the other order. */
static void
flipped_corners(void **state)
{
	int before[4], after[4], corner[4], k;
	Disk d;

	(void)state;
	make("mercator", 500, &d);
	assert_int_equal(corners_auto(&d, corner), 1);
	for (k = 0; k < 4; k++)
		before[k] = d.loop[corner[k]];
	disk_flip(&d);
	assert_int_equal(corners_auto(&d, corner), 1);
	for (k = 0; k < 4; k++)
		after[k] = d.loop[corner[k]];
	for (k = 0; k < 4; k++)
		assert_int_equal(after[k], before[(4 - k)%4]);
	disk_free(&d);
}

static void
nearest_points(void **state)
{
	double xyz[] = { 0,0,0, 2,0,0, 2,2,0, 0,2,0, 1,1,0 };
	int first[] = { 0, 3, 6, 9, 12 }, idx[] = { 0,1,4, 1,2,4, 2,3,4, 3,0,4 }, i;
	Soup s = { .nv = 5, .nf = 4, .xyz = xyz, .first = first, .idx = idx };
	Disk d;

	(void)state;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	for (i = 0; i < 4; i++)
		assert_int_equal(corners_nearest(&d, xyz + 3*i), i);
	assert_int_equal(corners_nearest(&d, (double[]){ 1.1, 1.2, 0 }), 2);    /* 4 is nearer but inside */
	assert_int_equal(corners_nearest(&d, (double[]){ 1, 1, 5 }), 0);        /* a tie: the lowest number */
	assert_int_equal(corners_nearest(&d, (double[]){ 3, 1, 0 }), 1);
	assert_int_equal(corners_nearest(&d, (double[]){ -1e5, 1e5, 0 }), 3);
	disk_flip(&d);                                                  /* the loop is now 0 3 2 1 */
	assert_int_equal(corners_nearest(&d, (double[]){ 3, 1, 0 }), 1);
	disk_free(&d);
}

static void
too_few(void **state)
{
	double xyz[] = { 0,0,0, 1,0,0, 0,1,0, 1,1,0 };
	int first[] = { 0, 3, 6 }, idx[] = { 0,1,2, 1,3,2 }, corner[4], k;
	Soup s = { .nv = 4, .nf = 1, .xyz = xyz, .first = first, .idx = idx };
	Disk d;

	(void)state;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	assert_int_equal(corners_auto(&d, corner), CORNERS_EFEW);
	disk_free(&d);
	s.nf = 2;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	assert_true(corners_auto(&d, corner) >= 0);
	for (k = 0; k < 4; k++)
		assert_int_equal(corner[k], k);
	disk_free(&d);
}

/* corners_at returns the boundary vertices at the given places, whichever of them comes first; four
 * equal places give four successive vertices. */
static void
at_places(void **state)
{
	double *s, total, at[4], e[3];
	int corner[4], i, k, c;
	Disk d;

	(void)state;
	make("face", 400, &d);
	s = malloc((d.nb + 1)*sizeof *s);
	for (s[0] = 0, i = 0; i < d.nb; i++) {
		for (c = 0; c < 3; c++)
			e[c] = d.m.xyz[3*d.loop[(i+1)%d.nb]+c] - d.m.xyz[3*d.loop[i]+c];
		s[i+1] = s[i] + sqrt(e[0]*e[0] + e[1]*e[1] + e[2]*e[2]);
	}
	total = s[d.nb];
	for (i = 0; i < d.nb; i++) {
		for (k = 0; k < 4; k++)
			at[k] = fmod((s[(i + k*d.nb/5)%d.nb] + 1e-3*total/d.nb)/total, 1);
		assert_int_equal(corners_at(&d, at, corner), 0);
		for (k = 0; k < 4; k++)
			assert_int_equal(corner[k], (i + k*d.nb/5)%d.nb);
	}
	for (i = 0; i < d.nb; i++) {
		for (k = 0; k < 4; k++)
			at[k] = s[i]/total;
		assert_int_equal(corners_at(&d, at, corner), 0);
		for (k = 0; k < 4; k++)
			assert_int_equal(corner[k], (i + k)%d.nb);
	}
	free(s);
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(real_corners), cmocka_unit_test(at_places),
		cmocka_unit_test(equal_arcs),
		cmocka_unit_test(ragged_corners),
		cmocka_unit_test(notched),
		cmocka_unit_test(flipped_corners),
		cmocka_unit_test(nearest_points),
		cmocka_unit_test(too_few),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
