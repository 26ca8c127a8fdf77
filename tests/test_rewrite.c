/* test_rewrite.c - rewrite.h: files with their vertices moved, all else byte for byte. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/meshfile/meshfile.h"
#include "../lib/meshfile/rewrite.h"

/* The new positions of four vertices, in a plane of normal (0,-1,0). */
static const double TO[12] = { 0, 3, 0,  .1, 3, 0,  0, 3, 1.0/3,  .1, 3, 1e20 };

/* Checks that the bytes become these, with a sanitizer's eye on what is behind their end. */
static void
becomes_bytes(const char *from, size_t n, int nv, const char *to, size_t nto)
{
	char *copy = malloc(n), *out, err[MESH_ERRLEN];
	size_t nout;

	memcpy(copy, from, n);
	if (rewrite(copy, n, nv, TO, &out, &nout, err))
		fail_msg("'%.60s': %s", from, err);
	free(copy);
	if (nout != nto || memcmp(out, to, nto) != 0)
		fail_msg("'%.*s', not '%.*s'", (int)nout, out, (int)nto, to);
	free(out);
}

static void
becomes(const char *from, int nv, const char *to)
{
	becomes_bytes(from, strlen(from), nv, to, strlen(to));
}

static void
refuses(const char *from, int nv, const char *why)
{
	char *out, err[MESH_ERRLEN] = "";
	size_t n;

	assert_int_equal(rewrite(from, strlen(from), nv, TO, &out, &n, err), MESH_EFORMAT);
	if (!strstr(err, why))
		fail_msg("'%.60s': '%s', not '%s'", from, err, why);
}

static void
obj_lines(void **state)
{
	(void)state;
	becomes("# c\nmtllib a.mtl\nv 0 0 0\nv 1 0 0 .5 .5 1\nv\t0\t1 0\r\n\nvt 0 0\ng a\nusemtl m\nf 1/1 2/1 3/1\nl 1 2\n", 3,
	    "# c\nmtllib a.mtl\nv 0 3 0\nv 0.1 3 0 .5 .5 1\nv 0 3 0.3333333333333333\r\n\nvt 0 0\ng a\nusemtl m\nf 1/1 2/1 3/1\nl 1 2\n");
	becomes("v 9 9 9\nv 9 9 9\nv 9 9 9\nv 9 9 9\nf 1 2 4 3", 4,
	    "v 0 3 0\nv 0.1 3 0\nv 0 3 0.3333333333333333\nv 0.1 3 1e+20\nf 1 2 4 3");
	becomes("  v 9 9 9 # first\n\tv 9 9 9\n v 9 9 9\n f 1 2 3\n", 3,
	    "v 0 3 0 # first\nv 0.1 3 0\nv 0 3 0.3333333333333333\n f 1 2 3\n");
	becomes("#\n#v 1 2 3\nv 9 9 9\nvertex 3\nv 9 9 9\nv 9 9 9\nf 1 2 3\nvp 1 2 3\n", 3,
	    "#\n#v 1 2 3\nv 0 3 0\nvertex 3\nv 0.1 3 0\nv 0 3 0.3333333333333333\nf 1 2 3\nvp 1 2 3\n");
}

/* Normals are those of the new faces, whichever way a face names them; one that no face has is (0,0,1). */
static void
obj_normals(void **state)
{
	(void)state;
	becomes("v 9 9 9\nv 9 9 9\nv 9 9 9\nvn 0 0 1\nvn 1 0 0\nf 1//1 2//1 3//1\n", 3,
	    "v 0 3 0\nv 0.1 3 0\nv 0 3 0.3333333333333333\nvn 0 -1 0\nvn 0 0 1\nf 1//1 2//1 3//1\n");
	becomes("v 9 9 9\nv 9 9 9\nv 9 9 9\nvn 1 0 0\nvn 0 0 1\nf 1/7/-1 3//-1 2//-1", 3,
	    "v 0 3 0\nv 0.1 3 0\nv 0 3 0.3333333333333333\nvn 0 0 1\nvn 0 1 0\nf 1/7/-1 3//-1 2//-1");
	refuses("v 9 9 9\nv 9 9 9\nv 9 9 9\nf 1//1 2//1 3//1\n", 3, "face 0 has a normal that is not there");
	refuses("v 9 9 9\nv 9 9 9\nv 9 9 9\nvn 0 0 1\nf 1//-2 2//1 3//1\n", 3, "face 0 has a normal that is not there");
}

static void
refused(void **state)
{
	(void)state;
	refuses("v 9 9 9\nv 9 9 9\nv 9 9 9\nf 1 2 3\n", 4, "the file has 3 vertices, the mesh with (u,v) has 4");
	refuses("v 9 9 9\nv 9 9 \\\n9\nv 9 9 9\nf 1 2 3\n", 3, "a statement is continued by \\ on the next line");
	refuses("OFF\n3 1 0\n0 3 0\n.1 3 0\n0 3 0.3333333333333333\n3 0 1 2\n", 3, "it is no OBJ or PLY");
	refuses("OFF\n3 1 0\n9 9 9\n9 9 9\n9 9 9\n3 0 1 2\n", 3, "its vertices cannot be replaced");
}

#define PLY(format, before, properties, n) "ply\nformat " format " 1.0\ncomment mine\n" before "element vertex " n "\n" properties \
	"element face 1\nproperty list uchar int vertex_indices\nend_header\n"
#define XYZ(type) "property " type " x\nproperty " type " y\nproperty " type " z\n"
#define NORMAL "property float nx\nproperty float ny\nproperty float nz\n"

static void
ply_text(void **state)
{
	(void)state;
	becomes(PLY("ascii", "", XYZ("float"), "3") "9 9 9\n9 9 9\n9 9 9\n3 0 1 2\n", 3,
	    PLY("ascii", "", XYZ("float"), "3") "0 3 0\n0.1 3 0\n0 3 0.3333333333333333\n3 0 1 2\n");
	becomes(PLY("ascii", "element other 2\nproperty list uchar int a\n",
	    "property uchar red\n" XYZ("double") NORMAL "property int id\n", "3")
	    "1 5\n2 6 7\n255 9 9 9 0 0 1 0\n254 9 9 9 0 0 1 1 \r\n253 9 9 9 0 0 1 2\n3 0 2 1", 3,
	    PLY("ascii", "element other 2\nproperty list uchar int a\n",
	    "property uchar red\n" XYZ("double") NORMAL "property int id\n", "3")
	    "1 5\n2 6 7\n255 0 3 0 0 1 0 0\n254 0.1 3 0 0 1 0 1 \r\n253 0 3 0.3333333333333333 0 1 0 2\n3 0 2 1");
	refuses(PLY("ascii", "", XYZ("float"), "3") "9 9 9 9 9 9\n9 9 9\n3 0 1 2\n", 3, "its vertices cannot be replaced");
	refuses(PLY("ascii", "", XYZ("float"), "3") "9\n9 9\n9 9 9\n9 9 9\n3 0 1 2\n", 3, "its vertices cannot be replaced");
	refuses(PLY("ascii", "", XYZ("int"), "3") "9 9 9\n9 9 9\n9 9 9\n3 0 1 2\n", 3, "property x is of type int, which holds no");
	refuses(PLY("ascii", "", "property list uchar int a\n" XYZ("float"), "3") "0 9 9 9\n0 9 9 9\n0 9 9 9\n3 0 1 2\n", 3,
	    "the vertices have a list");
}

/* Appends a number of `size` bytes to *p. */
static void
put(char **p, double x, int size, int big)
{
	float y = (float)x;
	char b[8];
	int k;

	memcpy(b, size == 8 ? (const void *)&x : (const void *)&y, (size_t)size);
	for (k = 0; k < size; k++)
		*(*p)++ = b[big ? size - 1 - k : k];            /* on a little-endian machine */
}

/* A binary PLY: an element before the vertices, y as a float, x and z as doubles, a byte, a normal. */
static size_t
binary(char *to, int big, const double xyz[9], const double normal[3])
{
	char *p = to;
	int v;

	p += sprintf(p, PLY("%s", "element other 1\nproperty short a\nproperty double b\n",
	    "property double x\nproperty float y\nproperty uchar red\nproperty double z\n" NORMAL, "3"),
	    big ? "binary_big_endian" : "binary_little_endian");
	memcpy(p, "\n\nvertex..", 10);
	p += 10;
	for (v = 0; v < 3; v++) {
		put(&p, xyz[3*v], 8, big);
		put(&p, xyz[3*v+1], 4, big);
		*p++ = (char)(200 + v);
		put(&p, xyz[3*v+2], 8, big);
		put(&p, normal[0], 4, big);
		put(&p, normal[1], 4, big);
		put(&p, normal[2], 4, big);
	}
	*p++ = 3;
	for (v = 0; v < 3; v++) {
		memcpy(p, "\0\0\0\0", 4);
		p[big ? 3 : 0] = (char)v;
		p += 4;
	}
	return (size_t)(p - to);
}

static void
ply_binary(void **state)
{
	static const double from[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
	char a[1000], b[1000];
	size_t n;
	int big;

	(void)state;
	for (big = 0; big < 2; big++) {
		n = binary(a, big, from, (double[]){ 0, 0, 1 });
		assert_int_equal(binary(b, big, TO, (double[]){ 0, -1, 0 }), n);
		becomes_bytes(a, n, 3, b, n);
	}
}

/* A position that the numbers of the file cannot hold. */
static void
too_large(void **state)
{
	static const char text[] = PLY("ascii", "", XYZ("float"), "3") "9 9 9\n9 9 9\n9 9 9\n3 0 1 2\n";
	double far[9] = { 0, 0, 0, 1, 0, 0, 0, 1e300, 0 };
	char binary_text[600], *out, err[MESH_ERRLEN];
	size_t n;

	(void)state;
	n = (size_t)sprintf(binary_text, PLY("binary_little_endian", "", XYZ("float"), "3"));
	memset(binary_text + n, 0, 36);
	memcpy(binary_text + n + 36, "\3\0\0\0\0\1\0\0\0\2\0\0\0", 13);
	assert_int_equal(rewrite(binary_text, n + 49, 3, far, &out, &n, err), MESH_EFORMAT);
	assert_non_null(strstr(err, "beyond a float"));
	assert_int_equal(rewrite(text, sizeof text - 1, 3, far, &out, &n, err), 0);
	free(out);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(obj_lines),
		cmocka_unit_test(obj_normals),
		cmocka_unit_test(refused),
		cmocka_unit_test(ply_text),
		cmocka_unit_test(ply_binary),
		cmocka_unit_test(too_large)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
