/* test_disk.c - disk.h: polygon soups are accepted, repaired, or refused with a reason.  The soups are
 * texts in this file, or real meshes from the folder $LHGRID_MESHES. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/mesh/channel.h"
#include "../lib/mesh/disk.h"
#include "../lib/mesh/disksoup.h"
#include "../lib/meshfile/meshfile.h"

/* isdisk checks the definition of a disk without the code under test: every half-edge occurs once;
 * an edge has at most two faces, in opposite directions; V - E + F = 1; the loop consists of all
 * half-edges without an opposite, is closed and begins at its lowest vertex.  A connected surface
 * with one boundary loop and Euler characteristic 1 is a disk. */
static int
find(const Mesh *m, int a, int b)
{
	int i, n = 0;

	for (i = 0; i < 3*m->nf; i++)
		n += m->tri[i] == a && m->tri[i % 3 == 2 ? i - 2 : i + 1] == b;
	return n;
}

static void
isdisk(const Disk *d)
{
	int i, a, b, twin, open = 0;

	for (i = 0; i < 3*d->m.nf; i++) {
		a = d->m.tri[i], b = d->m.tri[i % 3 == 2 ? i - 2 : i + 1];
		assert_int_equal(find(&d->m, a, b), 1);
		open += find(&d->m, b, a) == 0;
		twin = d->twin[i];
		if (find(&d->m, b, a) == 0)
			assert_int_equal(twin, -1);
		else
			assert_true(d->m.tri[twin] == b && d->m.tri[twin % 3 == 2 ? twin - 2 : twin + 1] == a);
	}
	assert_int_equal(open, d->nb);
	assert_int_equal(d->m.nv - (3*d->m.nf + open)/2 + d->m.nf, 1);
	for (i = 0; i < d->nb; i++) {
		assert_true(d->loop[i] >= d->loop[0]);
		assert_int_equal(find(&d->m, d->loop[i], d->loop[(i+1) % d->nb]), 1);
		assert_int_equal(find(&d->m, d->loop[(i+1) % d->nb], d->loop[i]), 0);
	}
}

static int
make(Disk *d, const char *text)
{
	Soup s;
	int e;

	if (meshfile_parse(&s, text, strlen(text), 0))
		fail_msg("'%s': %s", text, s.err);
	e = disk_from_soup(d, &s);
	soup_free(&s);
	if (e)
		assert_true(!d->m.xyz && !d->m.tri && !d->loop && !d->twin && !d->file && !d->became && d->err[0] &&
		    !strchr(d->err, '\n'));
	return e;
}

static Disk
good(const char *text, int nv, int nf, int nb, const char *note)
{
	Disk d;

	if (make(&d, text))
		fail_msg("'%s': %s", text, d.err);
	if (d.m.nv != nv || d.m.nf != nf || d.nb != nb || strcmp(d.note, note) != 0)
		fail_msg("'%s': %d %d %d '%s'", text, d.m.nv, d.m.nf, d.nb, d.note);
	isdisk(&d);
	return d;
}

static void
takes(const char *text, int nv, int nf, int nb, const char *note)
{
	Disk d = good(text, nv, nf, nb, note);

	disk_free(&d);
}

static void
refuses(const char *text, int code, const char *why)
{
	Disk d;
	int e = make(&d, text);

	if (!e)
		disk_free(&d);
	if (e != code || strncmp(d.err, why, strlen(why)) != 0)
		fail_msg("'%s': code %d, '%s', not %d, '%s'", text, e, e ? d.err : d.note, code, why);
}

#define SQUARE "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n"
#define TETRA "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\n"

static void
disks(void **state)
{
	Disk d;

	(void)state;
	takes(SQUARE "f 1 2 3\n", 3, 1, 3, "1 unreferenced vertex dropped");
	d = good("v 9 9 9\n" SQUARE "v 8 8 8\nf 4 5 2\nf 2 3 4\n", 4, 2, 4, "2 unreferenced vertices dropped");
	assert_true(d.m.xyz[0] == 0 && d.m.xyz[3] == 1 && d.m.xyz[10] == 1);    /* order of the file */
	assert_true(d.loop[0] == 0 && d.loop[1] == 1 && d.loop[3] == 3);        /* counterclockwise */
	assert_true(fabs(mesh_area(&d.m) - 1) < 1e-15);
	disk_free(&d);
	takes(TETRA "f 1 3 2\nf 1 2 4\nf 2 3 4\n", 4, 3, 3, "");
	takes("v 0 0 0\nv 1e-140 0 0\nv 0 1e-140 0\nf 1 2 3\n", 3, 1, 3, "");
	takes("v 0 0 0\nv 1e140 0 0\nv 0 1e140 0\nf 1 2 3\n", 3, 1, 3, "");
	takes("v 0 0 0\nv 1 0 0\nv .5 5e-8 0\nf 1 2 3\n", 3, 1, 3, "");         /* a sliver is valid */
}

/* Checks that a polygon is split into nf triangles of the right total area.  An inverted or
 * overlapping triangle would make the total larger. */
static void
splits(const char *text, int nf, double area)
{
	Disk d = good(text, nf + 2, nf, nf + 2, "");
	int i;

	if (!(fabs(mesh_area(&d.m) - area) < 1e-14 * area))
		fail_msg("'%s': area %g, not %g", text, mesh_area(&d.m), area);
	for (i = 0; i < nf + 2; i++)
		assert_int_equal(d.loop[i], i);         /* oriented as the polygon */
	disk_free(&d);
}

static void
polygons(void **state)
{
	Disk d;
	int f;

	(void)state;
	splits(SQUARE "f 1 2 3 4\n", 2, 1);
	splits("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n", 2, 4);        /* concave at corner 2 */
	splits("v 0 4 0\nv 0 0 0\nv 4 0 0\nv 1 1 0\nf 1 2 3 4\n", 2, 4);
	splits("v 1 1 0\nv 0 4 0\nv 0 0 0\nv 4 0 0\nf 1 2 3 4\n", 2, 4);
	splits("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3 4\n", 2, 2);        /* three corners on a line */
	splits("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 0 2 0\nf 1 2 3 4 5\n", 3, 3);
	splits("v 0 0 0\nv 0 3 0\nv 0 3 3\nv 0 2 3\nv 0 2 1\nv 0 1 1\nv 0 1 3\nv 0 0 3\nf 1 2 3 4 5 6 7 8\n",
	    6, 7);                                                              /* a U in the plane x = 0 */
	splits("v 2 0 0\nv 1 1 0\nv 0 2 0\nv -1 1 0\nv -2 0 0\nv -1 -1 0\nv 0 -2 0\nv 1 -1 0\n"
	    "f 1 2 3 4 5 6 7 8\n", 6, 8);
	d = good("v 0 0 0\nv 5 0 0\nv 6 1 0\nv 1 1 0\nf 1 2 3 4\n", 4, 2, 4, "");
	assert_true(d.m.tri[0] == 1 || d.m.tri[1] == 1 || d.m.tri[2] == 1);     /* cut along diagonal 1-3 */
	assert_true(d.m.tri[0] == 3 || d.m.tri[1] == 3 || d.m.tri[2] == 3);
	assert_true(d.m.tri[3] != 0 || d.m.tri[4] != 2);
	disk_free(&d);
	refuses(SQUARE "f 1 2 3\nf 1 3\n", MESH_EFACE, "face 1 has only 2 corners");
	refuses(SQUARE "f 1 2 3\nf 3 4 3\n", MESH_EFACE, "face 1 has vertex 2 twice");
	refuses("v 0 0 0\nv 1 1 1\nv 2 2 2\nf 1 2 3\n", MESH_EFACE, "face 0 has no area");
	refuses("v 0 0 0\nv 1 1 1\nv 1 1 1\nf 1 2 3\n", MESH_EFACE, "face 0 has no area");
	refuses("v 0 0 0\nv 1 0 0\nv .5 1e-15 0\nf 1 2 3\n", MESH_EFACE, "face 0 has no area");
	refuses("v 0 0 0\nv 1e-300 0 0\nv 0 1e-300 0\nf 1 2 3\n", MESH_EFACE, "face 0 has no area");
	refuses("v 0 0 0\nv 1e300 0 0\nv 0 1e300 0\nf 1 2 3\n", MESH_EFACE, "face 0 has no area");
	refuses("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3 4\n", MESH_EFACE,
	    "face 0, of 4 corners, cannot be split into triangles of some area");
	refuses("v 0 0 0\nv 1 1 0\nv 1 0 0\nv 0 1 0\nf 1 2 3 4\n", MESH_EFACE,  /* a bow tie */
	    "face 0, of 4 corners, cannot be split into triangles of some area");
	refuses("v 2102 1 0\nv -2 0 0\nv -1 -1 0\nv 0 -2 0\nv 1 -1 0\nf 2 3 4\n", MESH_EFACE,
	    "face 0 has no area");              /* found by fuzzing: no split may use this triangle */
	d = good("v 2102 1 0\nv -2 0 0\nv -1 -1 0\nv 0 -2 0\nv 1 -1 0\nf 1 2 3 4 5\n", 5, 3, 5, "");
	for (f = 0; f < 3; f++)
		assert_false(d.m.tri[3*f] + d.m.tri[3*f+1] + d.m.tri[3*f+2] == 6 && d.m.tri[3*f] > 0 &&
		    d.m.tri[3*f+1] > 0 && d.m.tri[3*f+2] > 0);      /* not triangle 1 2 3 */
	disk_free(&d);
	refuses("v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nv 4 0 0\nf 1 2 3 4 5\n", MESH_EFACE,
	    "face 0, of 5 corners, cannot be split into triangles of some area");
}

static void
repairs(void **state)
{
	Disk d;

	(void)state;
	takes(SQUARE "v -0 0 0\nv 1 1 0\nf 1 2 3\nf 5 6 4\n", 4, 2, 4, "6 vertices of a soup welded to 4");
	takes("v 7 7 7\n" SQUARE "v 0 0 0\nv 1 1 0\nf 2 3 4\nf 6 7 5\n", 4, 2, 4,
	    "1 unreferenced vertex dropped; 6 vertices of a soup welded to 4");
	takes(SQUARE "f 1 2 3\nf 4 3 1\n", 4, 2, 4, "1 of 2 faces were turned to agree with the rest");
	d = good(TETRA "f 1 2 3\nf 1 2 4\nf 2 3 4\n", 4, 3, 3,
		"1 of 3 faces were turned to agree with the rest");
	assert_int_equal(d.m.tri[1], 2);        /* the first face is turned */
	disk_free(&d);
}

#define STRIP "v 0 0 0\nv 1 0 0\nv 2 1 0\nv 2 2 1\nv 1 3 1\nv 0 2 0\n"

static void
refusals(void **state)
{
	(void)state;
	refuses("v 0 0 0\n", MESH_EDISK, "no faces");
	refuses(TETRA "v 9 9 9\nf 1 2 3\nf 2 1 4\nf 1 2 5\n", MESH_EMANIFOLD, "edge 0-1 belongs to 3 faces");
	refuses("v 9 9 9\n" TETRA "v 0 -1 -1\nf 2 3 4\nf 3 2 5\nf 2 3 6\n", MESH_EMANIFOLD,
	    "edge 1-2 belongs to 3 faces");     /* the numbers are those of the file */
	refuses(TETRA "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n", MESH_EDISK, "closed surface: no boundary");
	refuses(SQUARE "v 5 0 0\nv 6 0 0\nv 6 1 0\nf 1 2 3\nf 1 3 4\nf 5 6 7\n", MESH_EDISK,
	    "2 components, a disk is one");
	refuses(SQUARE "v 5 0 0\nv 6 0 0\nv 6 1 0\nf 1 2 3\nf 5 6 7\n", MESH_EDISK,
	    "2 components, a disk is one");     /* no equal positions: nothing to weld */
	refuses("v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nf 1 2 3\nf 1 4 5\n", MESH_EMANIFOLD,
	    "vertex 0 is pinched: 2 fans of faces meet there");
	refuses("v 0 0 0\nv 1 0 0\nv 1 1 0\nv -1 0 0\nv -1 -1 0\nv 0 1 1\nv 0 2 1\nf 1 2 3\nf 1 4 5\nf 1 6 7\n",
	    MESH_EMANIFOLD, "vertex 0 is pinched: 3 fans of faces meet there");
	refuses("v 0 0 0\nv 3 0 0\nv 0 3 0\nv 1 1 0\nv 1.5 1 0\nv 1 1.5 0\n"
	    "f 1 2 5 4\nf 2 3 6 5\nf 3 1 4 6\n", MESH_EDISK,
	    "2 boundary loops, a disk has one: at vertices 0, 3");
	refuses(STRIP "f 1 2 3\nf 2 3 4\nf 3 4 5\nf 4 5 1\nf 5 1 2\n", MESH_EORIENT,    /* a Moebius strip */
	    "surface is one-sided: no orientation agrees across edge");
}

/* A torus of 4 x 4 quads without one of them has a single boundary loop but a handle, and is
 * refused. */
static void
handles(void **state)
{
	char text[2000];
	int i, j, n = 0;

	(void)state;
	for (j = 0; j < 4; j++)
		for (i = 0; i < 4; i++)
			n += sprintf(text + n, "v %.3f %.3f %.3f\n", (3 + cos(1.57*j)) * cos(1.57*i),
			    (3 + cos(1.57*j)) * sin(1.57*i), sin(1.57*j));
	for (j = 0; j < 4; j++)
		for (i = 0; i < 4; i++)
			if (i + j > 0)
				n += sprintf(text + n, "f %d %d %d %d\n", 4*j + i + 1, 4*j + (i+1)%4 + 1,
				    4*((j+1)%4) + (i+1)%4 + 1, 4*((j+1)%4) + i + 1);
	refuses(text, MESH_EDISK, "genus 1: a disk has no handles");
}

/* Invalid soups, which no file reader returns, are refused. */
static void
raw_soups(void **state)
{
	double xyz[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
	int first[2] = { 0, 3 }, idx[3] = { 0, 1, 2 };
	Soup s = { .nv = 3, .nf = 1, .xyz = xyz, .first = first, .idx = idx };
	Disk d;

	(void)state;
	idx[2] = 3;
	assert_int_equal(disk_from_soup(&d, &s), MESH_EINDEX);
	assert_string_equal(d.err, "face 0 refers to vertex 3, there are 3");
	idx[2] = -1;
	assert_int_equal(disk_from_soup(&d, &s), MESH_EINDEX);
	idx[2] = 2;
	xyz[4] = NAN;
	assert_int_equal(disk_from_soup(&d, &s), MESH_EVALUE);
	assert_string_equal(d.err, "vertex 1 has a coordinate that is not finite; mesh2disk drops its faces");
	xyz[4] = 0;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	disk_free(&d);
	disk_free(&d);          /* a second call is allowed */
}

/* A lattice of N x N squares, with its faces in random order and some of them flipped, is
 * repaired. */
static void
shuffled(void **state)
{
	enum { N = 12, V = (N+1)*(N+1), F = 2*N*N };
	double xyz[3*V];
	int first[F+1], idx[3*F], f, k, v, t, turned = 0;
	unsigned seed = 1;
	Soup s = { .nv = V, .nf = F, .xyz = xyz, .first = first, .idx = idx };
	char note[100];
	Disk d;

	(void)state;
	for (v = 0; v < V; v++)
		xyz[3*v] = v % (N+1), xyz[3*v+1] = v / (N+1), xyz[3*v+2] = sin(v);
	for (f = 0; f < F; f++) {
		v = f/2 % N + f/2 / N * (N+1);
		idx[3*f] = v, idx[3*f+1] = f % 2 ? v+N+2 : v+1, idx[3*f+2] = f % 2 ? v+N+1 : v+N+2;
		first[f] = 3*f;
	}
	first[F] = 3*F;
	for (f = F - 1; f > 0; f--) {
		seed = seed * 1103515245 + 12345;
		for (k = 0, v = (int)(seed >> 16) % (f+1); k < 3; k++)
			t = idx[3*f+k], idx[3*f+k] = idx[3*v+k], idx[3*v+k] = t;
		if (seed >> 28 < 5)
			t = idx[3*f], idx[3*f] = idx[3*f+1], idx[3*f+1] = t, turned++;
	}
	snprintf(note, sizeof note, "%d of %d faces were turned to agree with the rest", turned, F);
	assert_int_equal(disk_from_soup(&d, &s), 0);
	assert_string_equal(d.note, note);
	assert_int_equal(d.nb, 4*N);
	assert_true(d.loop[0] == 0 && d.loop[1] == 1);
	isdisk(&d);
	disk_free(&d);
}

/* An STL file has no shared vertices: after reading, the triangles are welded to the same disk. */
static void
stl_welds(void **state)
{
	Disk d = good(TETRA "f 1 3 2\nf 1 2 4\nf 2 3 4\n", 4, 3, 3, ""), back;
	Soup s;
	size_t n;
	char *p;

	(void)state;
	assert_int_equal(meshfile_write_mesh(&d.m, meshformat_of("x.stl"), &p, &n), 0);
	assert_int_equal(meshfile_parse(&s, p, n, (size_t)1 << 30), 0);
	assert_int_equal(disk_from_soup(&back, &s), 0);
	assert_true(back.m.nv == 4 && back.m.nf == 3 && back.nb == 3);
	assert_true(fabs(mesh_area(&back.m) - mesh_area(&d.m)) < 1e-14);
	free(p);
	soup_free(&s);
	disk_free(&d);
	disk_free(&back);
}

/* Checks file and became: each vertex of the disk has the position of all vertices of the soup that
 * became it, and file[] is the lowest of their numbers. */
static void
traces(const Disk *d, const Soup *s)
{
	int v, k;

	assert_int_equal(d->nfile, s->nv);
	for (v = 0; v < d->m.nv; v++)
		assert_int_equal(d->became[d->file[v]], v);
	for (v = 0; v < s->nv; v++) {
		if ((k = d->became[v]) < 0)
			continue;
		assert_true(k < d->m.nv && d->file[k] <= v);
		assert_memory_equal(d->m.xyz + 3*k, s->xyz + 3*v, 3*sizeof(double));
	}
}

static void
origins(void **state)
{
	static const struct { const char *text; int nv, became[8]; } t[] = {
		{ SQUARE "f 1 2 3\nf 1 3 4\n", 4, { 0, 1, 2, 3 } },
		{ SQUARE "f 1 2 3 4\n", 4, { 0, 1, 2, 3 } },
		{ "v 9 9 9\n" SQUARE "v 8 8 8\nf 4 5 2\nf 2 3 4\n", 6, { -1, 0, 1, 2, 3, -1 } },
		{ SQUARE "v 1 1 0\nv 0 0 0\nf 3 1 2\nf 4 6 5\n", 6, { 0, 1, 2, 3, 2, 0 } },
		{ "v 5 5 5\n" SQUARE "v 1 1 0\nv 0 0 0\nf 4 2 3\nf 5 7 6\n", 7, { -1, 0, 1, 2, 3, 2, 0 } }
	};
	size_t i;
	Soup s;
	Disk d;
	int v;

	(void)state;
	for (i = 0; i < sizeof t / sizeof *t; i++) {
		assert_int_equal(meshfile_parse(&s, t[i].text, strlen(t[i].text), 0), 0);
		assert_int_equal(disk_from_soup(&d, &s), 0);
		assert_int_equal(d.nfile, t[i].nv);
		for (v = 0; v < t[i].nv; v++)
			assert_int_equal(d.became[v], t[i].became[v]);
		traces(&d, &s);
		disk_free(&d);
		soup_free(&s);
	}
}

/* disk_flip reverses every face and the loop; flipping twice restores the disk. */
static void
flips(void **state)
{
	Disk d = good(TETRA "v 2 2 2\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 4 3 5\n", 5, 4, 4, ""), was = d;
	int tri[12], loop[4], i;

	(void)state;
	memcpy(tri, d.m.tri, sizeof tri);
	memcpy(loop, d.loop, sizeof loop);
	disk_flip(&d);
	isdisk(&d);
	assert_true(d.nb == was.nb && d.m.nf == was.m.nf);
	for (i = 0; i < 4; i++)
		assert_int_equal(d.loop[i], loop[(4 - i)%4]);
	for (i = 0; i < 12; i++)
		assert_int_equal(find(&d.m, tri[i % 3 == 2 ? i - 2 : i + 1], tri[i]), 1);
	disk_flip(&d);
	assert_memory_equal(d.m.tri, tri, sizeof tri);
	assert_memory_equal(d.loop, loop, sizeof loop);
	disk_free(&d);
	d = good("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", 3, 1, 3, "");
	disk_flip(&d);                          /* a loop of odd length */
	isdisk(&d);
	disk_free(&d);
}

/* disk_uv_to_soup copies (u,v) to the vertices of the soup, clamped to the rectangle. */
static void
uv_to_soup(void **state)
{
	static const char text[] = "v 5 5 5\n" SQUARE "v 1 1 0\nv 0 0 0\nf 4 2 3\nf 5 7 6\n";
	static const double u[4] = { 0.125, 0.25, 1.01, -0.5 }, v[4] = { 0.5, 0.75, 0.8, -1e-9 };
	static const double want[14] = { -1, -1, 0.125, 0.5, 0.25, 0.7, 1, 0.7, 0, 0, 1, 0.7, 0.125, 0.5 };
	Soup s;
	Disk d;
	int i;

	(void)state;
	assert_int_equal(meshfile_parse(&s, text, strlen(text), 0), 0);
	assert_true(s.channels.n == 0 && s.T == 0);
	assert_int_equal(disk_from_soup(&d, &s), 0);
	for (i = 0; i < 2; i++) {
		assert_int_equal(disk_uv_to_soup(&d, u, v, 0.7, &s), 0);
		assert_true(s.T == 0.7);
		assert_memory_equal(channel_values(&s.channels, MESH_UV), want, sizeof want);
	}
	disk_free(&d);
	soup_free(&s);
	assert_int_equal(s.channels.n, 0);
}

/* The bytes of a file in the folder of test meshes, or NULL if it cannot be opened. */
static char *
slurp(const char *name, size_t *n)
{
	const char *folder = getenv("LHGRID_MESHES");
	char path[500], *p;
	FILE *f;

	snprintf(path, sizeof path, "%s/%s", folder ? folder : "../shared/meshes", name);
	f = fopen(path, "rb");
	if (!f)
		return NULL;
	fseek(f, 0, SEEK_END);
	*n = (size_t)ftell(f);
	rewind(f);
	p = malloc(*n + 1);
	*n = fread(p, 1, *n, f);
	fclose(f);
	return p;
}

/* Reads a file and makes a disk of it; `why` gets the reason or the note. */
static int
real(const char *name, Disk *d, char why[MESH_ERRLEN])
{
	size_t n = 0;
	char *p = slurp(name, &n);
	Soup s;
	int e;

	if (!p) {
		print_message("no test meshes: set LHGRID_MESHES\n");
		skip();
	}
	e = meshfile_parse(&s, p, n, (size_t)1 << 30);
	free(p);
	if (e) {
		strcpy(why, s.err);
		return e;
	}
	e = disk_from_soup(d, &s);
	if (!e)
		traces(d, &s);
	soup_free(&s);
	strcpy(why, e ? d->err : d->note);
	return e;
}

/* The numbers of vertices, faces and boundary edges are those counted by two other programs, see
 * MANIFEST.md of the folder. */
static void
real_disks(void **state)
{
	static const struct { const char *name; int nv, nf, nb; const char *note; } t[] = {
		{ "good/face_woman_17k.off", 17157, 34144, 168, "" },
		{ "good/face_neutral_1875.obj", 1875, 3535, 213, "" },
		{ "good/face_smile_1656.obj", 1656, 3132, 178, "" },
		{ "good/face_man_scan_6k.off", 5999, 11755, 241, "" },
		{ "good/face_nefertiti_4.6k.off", 4565, 8992, 136, "" },
		{ "good/head_man_26k.ply", 25905, 51712, 96, "" },
		{ "good/tooth_lemur_B03.off", 5107, 10000, 212, "" },
		{ "good/tooth_orangutan_edj_14k.off", 14373, 27948, 796, "" },
		{ "good/jaw_gum_20k.ply", 19894, 39477, 309, "" },
		{ "good/cortex_fs5_lh_ball.off", 3581, 6964, 196, "" },
		{ "good/cortex_fs5_lh_flatcuts.off", 9465, 18654, 274, "" },
		{ "good/cortex_hemisphere_48k.ply", 48463, 96811, 113, "" },
		{ "good/buddha_laughing_15k.off", 14885, 29503, 265, "" },
		{ "good/bunny_28k.ply", 27961, 55616, 304, "" },
		{ "good/camelhead_11k.off", 11381, 22704, 56, "" },
		{ "good/coarse_mannequin_428.off", 428, 839, 15, "" },
		{ "good/coarse_cathead_131.obj", 131, 248, 12, "" },
		{ "good/moebius_part.obj", 225, 352, 96, "" },
		{ "good/spiral_synthetic.off", 6240, 11914, 564, "" },
		{ "good/large_cortex_wm_200k.ply", 214065, 423817, 4311, "" },
		{ "bad/quads_wrapped_lines.off", 1963, 3676, 248, "" },
		{ "bad/unreferenced_vertices.ply", 5076, 10050, 100, "3542 unreferenced vertices dropped" },
		{ "bad/soup_duplicated_vertices.off", 1656, 3132, 178, "9396 vertices of a soup welded to 1656" },
		{ "bad/orientation_half_flipped.obj", 1656, 3132, 178,
		    "1566 of 3132 faces were turned to agree with the rest" },
		{ "formats/bff_cowhead.obj", 15049, 29999, 97, "" },
		{ "formats/hem_disk.obj", 3813, 7543, 81, "" },
		{ "formats/doolkit_cusp.ply", 5076, 10050, 100, "3542 unreferenced vertices dropped" },
		{ "formats/fsaverage5_flat_left.gii", 9465, 18654, 274, "777 unreferenced vertices dropped" },
		{ "formats/fsaverage5_flat_left.gii.gz", 9465, 18654, 274, "777 unreferenced vertices dropped" }
	};
	char why[MESH_ERRLEN];
	size_t i;
	Disk d;

	(void)state;
	for (i = 0; i < sizeof t / sizeof *t; i++) {
		if (real(t[i].name, &d, why))
			fail_msg("%s: %s", t[i].name, why);
		if (d.m.nv != t[i].nv || d.m.nf != t[i].nf || d.nb != t[i].nb || strcmp(why, t[i].note) != 0)
			fail_msg("%s: %d %d %d '%s'", t[i].name, d.m.nv, d.m.nf, d.nb, why);
		disk_free(&d);
	}
}

static void
real_refusals(void **state)
{
	static const struct { const char *name; int code; const char *why; } t[] = {
		{ "bad/closed_bunny.off", MESH_EDISK, "closed surface" },
		{ "bad/pinched_vertex_face.off", MESH_EMANIFOLD, "is pinched: 2 fans" },
		{ "bad/nonmanifold_edges.obj", MESH_EMANIFOLD, "belongs to 3 faces" },
		{ "bad/two_loops_face.obj", MESH_EDISK, "2 boundary loops" },
		{ "bad/components_face_scan.obj", MESH_EDISK, "6 components" },
		{ "bad/binary_bird_skull.stl", MESH_EDISK, "closed surface" },
		{ "bad/nan_coordinates.off", MESH_EVALUE, "vertex 100 " },
		{ "bad/truncated.ply", MESH_EFORMAT, "file ends in face 1262 of 3132" },
		{ "bad/genus2_one_loop.off", MESH_EDISK, "genus 2" },
		{ "bad/moebius_quads.obj", MESH_EORIENT, "one-sided" },
		{ "bad/zero_area_bad_index.off", MESH_EINDEX, "face 3131 refers to vertex" },
		{ "formats/fsaverage5_pial_left.gii.gz", MESH_EDISK, "closed surface" },
		{ "formats/conte69_32k_lh.gii", MESH_EDISK, "closed surface" },
		{ "formats/lh.pial", MESH_EDISK, "closed surface" },
		{ "formats/lh.tinysurface.asc", MESH_EFACE, "has vertex 2 twice" },
		{ "formats/human_face.mat", MESH_EFORMAT, "MATLAB" },
		{ "formats/fandisk_hoppe.m", MESH_EDISK, "closed surface" },
		{ "formats/lapy_cube.vtk", MESH_EDISK, "closed surface" },
		{ "formats/lucy_50k.ply", MESH_EDISK, "closed surface" },
		{ "formats/brain_tristrips.ply", MESH_EDISK, "14 components" },
		{ "formats/bunny_zipper.ply", MESH_EDISK, "5 boundary loops" },
		{ "formats/ict_face_quads_uv.obj", MESH_EDISK, "56 components" },
		{ "formats/sphere_ascii.stl", MESH_EDISK, "closed surface" },
		{ "formats/beetle_binary.off", MESH_EMANIFOLD, "is pinched" },
		{ "formats/horse_quad.obj", MESH_EDISK, "closed surface" },
		{ "formats/finch_skull_binary.stl", MESH_EDISK, "closed surface" },
		{ "formats/fsaverage5_pial_left.gii", MESH_EDISK, "closed surface" },
		{ "formats/lh.tinysurface", MESH_EFACE, "has vertex 2 twice" }
	};
	char why[MESH_ERRLEN];
	size_t i;
	Disk d;
	int e;

	(void)state;
	for (i = 0; i < sizeof t / sizeof *t; i++)
		if ((e = real(t[i].name, &d, why)) != t[i].code || !strstr(why, t[i].why))
			fail_msg("%s: code %d, '%s'", t[i].name, e, why);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(disks),
		cmocka_unit_test(polygons),
		cmocka_unit_test(repairs),
		cmocka_unit_test(refusals),
		cmocka_unit_test(handles),
		cmocka_unit_test(raw_soups),
		cmocka_unit_test(shuffled),
		cmocka_unit_test(stl_welds),
		cmocka_unit_test(origins),
		cmocka_unit_test(flips),
		cmocka_unit_test(uv_to_soup),
		cmocka_unit_test(real_disks),
		cmocka_unit_test(real_refusals),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
