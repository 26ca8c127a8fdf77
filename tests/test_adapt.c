/* test_adapt.c - splitting faces, the map on a mesh split where needed, and untangling. */
#include "cmock.h"

#include <math.h>
#include <unistd.h>

#include "../lib/map/adapt.h"
#include "../lib/map/rectmap.h"
#include "../lib/mesh/refine.h"
#include "../lib/base/vec3.h"
#include "surfaces.h"
#include "synthdisk.h"

/* Checks that finer is a conforming mesh of the same surface as d: it is a disk with valid loop and
 * twins and with the same area, and the old vertices have not moved. */
static void
check_finer(const Disk *d, const Disk *finer)
{
	Soup s = { .nv = finer->m.nv, .nf = finer->m.nf, .xyz = finer->m.xyz, .idx = finer->m.tri };
	Disk again;
	int i;

	s.first = malloc((s.nf + 1)*sizeof *s.first);
	for (i = 0; i <= s.nf; i++)
		s.first[i] = 3*i;
	assert_int_equal(disk_from_soup(&again, &s), 0);
	assert_string_equal(again.note, "");
	assert_int_equal(again.nb, finer->nb);
	assert_memory_equal(again.loop, finer->loop, finer->nb*sizeof *finer->loop);
	assert_memory_equal(again.twin, finer->twin, 3*finer->m.nf*sizeof *finer->twin);
	assert_memory_equal(d->m.xyz, finer->m.xyz, 3*d->m.nv*sizeof(double));
	assert_true(fabs(mesh_area(&finer->m)/mesh_area(&d->m) - 1) < 1e-12);
	disk_free(&again);
	free(s.first);
}

static void
split_all_gives_four_of_each(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d, finer;
	unsigned char *marked;

	(void)state;
	synth_disk("face", 300, &s, &dom, &d, NULL);
	marked = malloc(d.m.nf);
	memset(marked, 1, d.m.nf);
	assert_int_equal(refine_split(&d, marked, NULL, &finer, NULL), 0);
	assert_int_equal(finer.m.nf, 4*d.m.nf);
	assert_int_equal(finer.nb, 2*d.nb);
	check_finer(&d, &finer);
	free(marked);
	disk_free(&d);
	disk_free(&finer);
}

static double
least_angle(const Mesh *m)
{
	double least = M_PI, a[3], b[3], n[3];
	int f, k, c;

	for (f = 0; f < m->nf; f++)
		for (k = 0; k < 3; k++) {
			const double *x = &m->xyz[3*m->tri[3*f+k]];

			for (c = 0; c < 3; c++) {
				a[c] = m->xyz[3*m->tri[3*f+(k+1)%3]+c] - x[c];
				b[c] = m->xyz[3*m->tri[3*f+(k+2)%3]+c] - x[c];
			}
			cross3(a, b, n);
			least = fmin(least, atan2(norm3(n), dot3(a, b)));
		}
	return least;
}

/* Splitting all faces into four similar ones keeps the least angle of the mesh. */
static void
split_similar_keeps_angles(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d, finer;

	(void)state;
	synth_disk("face", 300, &s, &dom, &d, NULL);
	assert_int_equal(refine_split(&d, NULL, NULL, &finer, NULL), 0);
	assert_int_equal(finer.m.nf, 4*d.m.nf);
	assert_int_equal(finer.nb, 2*d.nb);
	check_finer(&d, &finer);
	assert_true(fabs(least_angle(&finer.m)/least_angle(&d.m) - 1) < 1e-9);
	disk_free(&d);
	disk_free(&finer);
}

static void
split_some_is_conforming(void **state)
{
	Synth s;
	SynthDomain dom;
	Disk d, finer;
	unsigned char *marked;
	unsigned long long seed = 5;
	int round, f;
	double angle;

	(void)state;
	synth_disk("cap", 200, &s, &dom, &d, NULL);
	angle = least_angle(&d.m);
	for (round = 0; round < 6; round++) {
		marked = calloc(d.m.nf, 1);
		for (f = 0; f < d.m.nf; f++)
			marked[f] = noise(&seed) > 0.7;
		assert_int_equal(refine_split(&d, marked, NULL, &finer, NULL), 0);
		check_finer(&d, &finer);
		free(marked);
		disk_free(&d);
		d = finer;
		assert_true(least_angle(&d.m) > angle/2);       /* proved by Rosenberg and Stenger */
	}
	disk_free(&d);
}

/* T is right to 1e-4 on quadrilaterals whose modulus is known. */
static void
modulus_to_1e_4(void **state)
{
	static const char *const kind[] = { "lshape", "sector", "cap", "mercator", "torus" };
	static const int vertex[4] = { 0, 1, 2, 3 };
	size_t i;

	(void)state;
	for (i = 0; i < sizeof kind/sizeof *kind; i++) {
		Synth s;
		SynthDomain dom;
		SpdReport report;
		AdaptMap a;
		Disk d;

		synth_disk(kind[i], 20000, &s, &dom, &d, NULL);
		assert_int_equal(adapt_map(&d, vertex, &(AdaptOptions){ 1e-3, 1, 100000 }, &a, &report), 0);
		assert_true(a.certificate > -1e-12 && a.certificate <= 1e-3);
		assert_true(fabs(a.T/dom.T - 1) < 1e-4);
		adapt_free(&a);
		disk_free(&d);
	}
}

static void
stops_at_the_limit(void **state)
{
	static const int vertex[4] = { 0, 1, 2, 3 };
	Synth s;
	SynthDomain dom;
	SpdReport report;
	AdaptMap a;
	Disk d;

	(void)state;
	synth_disk("cortex", 500, &s, &dom, &d, NULL);
	assert_int_equal(adapt_map(&d, vertex, &(AdaptOptions){ 1e-9, 0, 3000 }, &a, &report), 0);
	assert_true(a.certificate > 1e-9 && a.rounds > 0 && a.mesh.d.m.nv < 12000);
	adapt_free(&a);
	assert_int_equal(adapt_map(&d, vertex, &(AdaptOptions){ 1e-9, 2, 0 }, &a, &report), 0);
	assert_int_equal(a.rounds, 0);
	assert_int_equal(a.mesh.d.m.nv, d.m.nv);
	adapt_free(&a);
	disk_free(&d);
}

/* Splitting ends for every limit on the number of vertices, also if the limit leaves no room to
 * split even one face.  If it does not end, the alarm kills the process. */
static void
ends_at_every_limit(void **state)
{
	static const int vertex[4] = { 0, 1, 2, 3 };
	SynthDomain dom;
	SpdReport report;
	AdaptMap a;
	Synth s;
	Disk d;
	int most;

	(void)state;
	alarm(60);
	synth_disk("face", 30, &s, &dom, &d, NULL);
	for (most = d.m.nv - 1; most < d.m.nv + 200; most++) {
		assert_int_equal(adapt_map(&d, vertex, &(AdaptOptions){ 1e-6, 0, most }, &a, &report), 0);
		adapt_free(&a);
	}
	alarm(0);
	disk_free(&d);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(split_all_gives_four_of_each),
		cmocka_unit_test(split_similar_keeps_angles),
		cmocka_unit_test(split_some_is_conforming),
		cmocka_unit_test(modulus_to_1e_4),
		cmocka_unit_test(stops_at_the_limit),
		cmocka_unit_test(ends_at_every_limit),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
