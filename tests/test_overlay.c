/* test_overlay.c - the common subdivision of a mesh and an intrinsic triangulation. */
#include "cmock.h"

#include <math.h>

#include "../lib/base/vec3.h"
#include "../lib/intrinsic/crossings.h"
#include "../lib/intrinsic/flips.h"
#include "../lib/intrinsic/overlay.h"
#include "../lib/map/corners.h"
#include "../lib/map/intrinsicmap.h"
#include "../lib/mesh/topology.h"
#include "disks.h"
#include "synthdisk.h"

static size_t
count_crossings(const Intrinsic *t)
{
	size_t n = 0;
	int e;

	for (e = 0; e < t->ne; e++)
		n += t->crossings[e];
	return n;
}

/* Checks that every crossing of an intrinsic edge with an edge of the mesh is a vertex of the
 * subdivision, and that this vertex lies on the edge of the mesh, between its ends. */
static void
check_crossings(const Intrinsic *t, const Disk *mesh, const Subdivision *s)
{
	int e, i, k, c, v = t->nv;

	for (e = 0; e < t->ne; e++)
		for (k = 0; k < t->crossings[e]; k++, v++) {
			int h = t->mesh_side[t->crossing[e][k]], a = mesh->m.tri[h], b = mesh->m.tri[topology_next(h)];
			const int *corner = s->corner[v - s->given];
			const double *w = s->w[v - s->given], *x = s->d.m.xyz;

			assert_int_equal(corner[0], a);
			assert_int_equal(corner[1], b);
			assert_true(w[0] >= 0 && w[1] >= 0 && w[2] == 0 && fabs(w[0] + w[1] - 1) < 1e-15);
			for (i = 0, c = 0; c < 3; c++) {
				double size = fabs(x[3*a+c]) + fabs(x[3*b+c]);

				i += fabs(w[0]*x[3*a+c] + w[1]*x[3*b+c] - x[3*v+c]) <= 1e-15*size;
			}
			assert_int_equal(i, 3);
		}
	assert_int_equal(v, s->d.m.nv);
}

/* Checks that m has this area on the surface and area T in (u,v), and that no triangle is flipped in
 * (u,v). */
static void
check_areas(double area, const Mesh *m, const double *u, const double *v, double T)
{
	double image = 0;
	int f;

	assert_true(fabs(mesh_area(m)/area - 1) < 1e-10);
	for (f = 0; f < m->nf; f++) {
		const int *c = &m->tri[3*f];
		double a = (u[c[1]] - u[c[0]])*(v[c[2]] - v[c[0]]) - (u[c[2]] - u[c[0]])*(v[c[1]] - v[c[0]]);

		assert_true(a > -1e-14*T);
		image += a/2;
	}
	assert_true(fabs(image/T - 1) < 1e-10);
}

/* Checks that of n vertices only the four of `vertex` are mapped to corners of the rectangle. */
static void
check_corners(int n, const double *u, const double *v, double T, const int vertex[4])
{
	int i, k, at = 0;

	for (i = 0; i < n; i++)
		at += (u[i] == 0 || u[i] == 1) && (v[i] == 0 || v[i] == T);
	assert_int_equal(at, 4);
	for (k = 0; k < 4; k++) {
		assert_true(u[vertex[k]] == (k == 1 || k == 2));
		assert_true(v[vertex[k]] == (k < 2 ? 0 : T));
	}
}

/* Maps d with these corners, overlays the mesh with its intrinsic triangulation and checks the
 * overlay.  Returns the number of crossings. */
static size_t
check_overlay_with(const Disk *d, const int vertex[4])
{
	SpdReport report;
	IntrinsicMap m;
	Disk mesh;
	size_t n;
	int nb;

	assert_int_equal(intrinsic_map(d, vertex, &(AdaptOptions){ 1, 0, 30000 }, &m, &report), 0);
	nb = m.s.mesh.d.nb;
	n = count_crossings(&m.s.t);
	assert_int_equal(m.s.t.nf, m.s.mesh.d.m.nf);
	mesh = (Disk){ .m = { .nv = m.s.mesh.d.m.nv, .nf = m.s.mesh.d.m.nf } };
	mesh.m.tri = malloc(3*mesh.m.nf*sizeof *mesh.m.tri);
	memcpy(mesh.m.tri, m.s.mesh.d.m.tri, 3*mesh.m.nf*sizeof *mesh.m.tri);
	assert_int_equal(overlay(&m.s.t, &m.s.mesh, &m.u, &m.v), 0);
	assert_int_equal(m.s.mesh.d.m.nf, m.s.t.nf + 2*n);
	assert_int_equal(m.s.mesh.d.m.nv, m.s.t.nv + n);
	assert_int_equal(m.s.mesh.d.nb, nb);
	assert_true(disks_is_disk(&m.s.mesh.d));
	check_crossings(&m.s.t, &mesh, &m.s.mesh);
	check_areas(mesh_area(&d->m), &m.s.mesh.d.m, m.u, m.v, m.T);
	check_corners(m.s.mesh.d.m.nv, m.u, m.v, m.T, vertex);
	free(mesh.m.tri);
	intrinsic_map_free(&m);
	return n;
}

/* The same with the corners that are chosen by shape. */
static size_t
check_overlay(const Disk *d)
{
	int corner[4], vertex[4], k;

	assert_true(corners_auto(d, corner) >= 0);
	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	return check_overlay_with(d, vertex);
}

static void
overlay_of_surfaces(void **state)
{
	static const char *const kind[] = { "face", "cortex", "tooth", "spiral" };
	SynthDomain dom;
	size_t i, n = 0;
	Synth s;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		synth_disk(kind[i], 1000, &s, &dom, &d, NULL);
		n += check_overlay(&d);
		disk_free(&d);
	}
	assert_true(n > 200);
}

static void
overlay_of_random_disks(void **state)
{
	uint64_t seed;
	size_t n = 0;
	int kind;

	(void)state;
	for (seed = 0; seed < 40; seed++)
		for (kind = DISKS_ANY; kind <= DISKS_FLAT; kind++) {
			char tag[DISKS_TAG];
			Disk d;

			if (disks_random(seed, kind, &d, tag))
				continue;
			if (d.m.nf < 2000 && strncmp(tag, "fan", 3) != 0)
				n += check_overlay(&d);
			disk_free(&d);
		}
	assert_true(n > 10000);
}

enum { LONG = 80 };

/* A strip of 40 x 1 in three rows of vertices, vertex 3*i + j at (i/2,j/2).  Three of its corners lie at one
 * end, the fourth at the other, c: towards c, (u,v) tend to a corner of the rectangle so fast that there are no
 * binary64 numbers between.  The edge next to c, from 3*LONG to 3*LONG + 2, crosses a Delaunay edge near c. */
static void
dead_end(void **state)
{
	enum { a = 3*LONG, c, b };
	double xyz[3*LONG+3][3];
	int tri[4*LONG][3], i, j, n = 0;
	Disk d;

	(void)state;
	for (i = 0; i <= LONG; i++)
		for (j = 0; j < 3; j++)
			memcpy(xyz[3*i+j], (double[]){ i/2.0, j/2.0, 0 }, sizeof xyz[0]);
	xyz[c][0] += .05;
	for (i = 0; i + 1 < LONG; i++)
		for (j = 0; j < 2; j++) {
			memcpy(tri[n++], (int[]){ 3*i + j, 3*i + j + 3, 3*i + j + 4 }, sizeof tri[0]);
			memcpy(tri[n++], (int[]){ 3*i + j, 3*i + j + 4, 3*i + j + 1 }, sizeof tri[0]);
		}
	memcpy(tri[n++], (int[]){ a - 3, a, a - 2 }, sizeof tri[0]);
	memcpy(tri[n++], (int[]){ a - 2, a, b }, sizeof tri[0]);
	memcpy(tri[n++], (int[]){ a - 2, b, a - 1 }, sizeof tri[0]);
	memcpy(tri[n++], (int[]){ a, c, b }, sizeof tri[0]);
	assert_int_equal(disks_of(3*LONG + 3, xyz[0], n, tri[0], &d), 0);
	assert_true(check_overlay_with(&d, (int[]){ 0, 6, c, 2 }) > 0);
	assert_true(check_overlay_with(&d, (int[]){ c, 2, 0, 6 }) > 0);
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(overlay_of_surfaces),
		cmocka_unit_test(overlay_of_random_disks),
		cmocka_unit_test(dead_end),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
