/* test_meshfile.c - meshfile.h: the rules of every format; refusals and their messages; files
 * that are cut, changed or malicious; writing and reading back. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>
#include <zlib.h>
#include <cmocka.h>

#include "../lib/mesh/channel.h"
#include "../lib/mesh/filled.h"
#include "../lib/meshfile/meshfile.h"
#include "meshreads.h"

static void
off_rules(void **state)
{
	(void)state;
	reads("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF 3 1 0\r\n0 0 0\r\n1 0 0\r\n0 1 0\r\n3 0 1 2", 3, "0 1 2");
	reads("# c\nOFF # c\n3 1 # no edges\n\n0 0 0 # c\n1 0 0\n0 1 0\n3 0 1 2 # c\n# end", 3, "0 1 2");
	reads("\xef\xbb\xbfOFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("COFF\n3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n", 3, "0 1 2");
	reads("STCNOFF\n3 1 0\n0 0 0 nan 1\n1 0 0 1 1\n0 1 0 1 1\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF\n3 2 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 255 0 0\n3 0 2 1 0.5 0.5 0.5 1\n", 3, "0 1 2/0 2 1");
	reads("OFF\n4 2 0\n0 0\n0\n1 0 0\n0 1 0\n1 1 1\n4 0\n1\n\n2 3\n3\n2\n1\n0\n", 4, "0 1 2 3/2 1 0");
	reads("OFF\n0 0 0\n", 0, "");
	reads("OFF3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("off\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("off3 1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("COFF3 1 0\n0 0 0 1 1 1 1\n1 0 0 1 1 1 1\n0 1 0 1 1 1 1\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF\n3\n1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF\n# c\n3 # v\n\n1\n# c\n0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF\n3\n1\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("OFF\n3 1\n\n0 # e\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	refuses("OFF3x 1 0\n", MESH_EFORMAT, "not an OFF");
	refuses("Off\n3 1 0\n", MESH_EFORMAT, "not an OFF");
	refuses("OFF\n3", MESH_EFORMAT, "file ends in the header");
	refuses("OFF", MESH_EFORMAT, "file ends in the header");
	refuses("OFF\n3 1 0 7\n", MESH_EFORMAT, "'7' is not expected");
	refuses("OFF\nx 1 0\n", MESH_EFORMAT, "'x' is not a number of vertices");
	refuses("4OFF\n0 0 0\n", MESH_EFORMAT, "three dimensions");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0 1 1 1\n3 0 1 2\n", MESH_EFORMAT,
	    "vertex 2 has 6 numbers, those before have 3");
	refuses("OFF\n2 2 0\n0 0 0\n1 0 0\n3 0 1 1 3 0 1 1\n", MESH_EFORMAT, "file ends in face 1 of 2");
	refuses("OFF\n2 3 0\n0 0 0\n1 0 0\n3 0 1 1 3 0 1 1 3 0 1 1\n", MESH_EFORMAT,
	    "8 numbers after the 3 corners of face 0");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 2\n", MESH_EFORMAT,
	    "line 7: '3' is not expected after the last face");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0 \n0 1 0\n3 0 1 3\n", MESH_EINDEX,
		"face 0 refers to vertex 3, there are 3");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0 \n0 1 0\n3 0 1 -1\n", MESH_EINDEX,
		"face 0 refers to vertex -1, there are 3");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0 \n0 1 0\n3 0 1 4294967296\n", MESH_EINDEX,
		"vertex 4294967296, there are 3");
	refuses("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 1.5\n", MESH_EFORMAT, "'1.5' is not a vertex number");
	refuses("OFF\n3 1 0\n0.00 0.00 0.00\n1 0 0\n0 1\n", MESH_EFORMAT, "file ends in vertex 2 of 3");
}

static void
number_rules(void **state)
{
	static const char *const good[] = { "0", "-0", "+1", "1.", ".5", "1e3", "1E-3", "-1.25e+2",
	    "9007199254740993", "0.1", "123456789012345678901234567890", "2.2250738585072011e-308",
	    "179769313486231570814527423731704356798070e267", "4.35", "0.000001234567890123",
	    "5e-324", "1.00000000000000011102230246251565404", "41.846923828100003", "1e23" };
	static const char *const bad[] = { "1,5", "0x10", "1e", "--1", ".", "-", "1-2", "1e5.", "e5" };
	static const char *const huge[] = { "nan", "-NaN", "nan(1)", "inf", "+Infinity", "1e999" };
	char text[400];
	size_t i;
	Soup s;

	(void)state;
	for (i = 0; i < sizeof good / sizeof *good; i++) {
		snprintf(text, sizeof text, "v %s 0 0", good[i]);
		assert_int_equal(parse(&s, text, strlen(text)), 0);
		if (s.xyz[0] != strtod(good[i], NULL) || !signbit(s.xyz[0]) != (*good[i] != '-'))
			fail_msg("%s read as %.17g", good[i], s.xyz[0]);
		soup_free(&s);
	}
	for (i = 0; i < sizeof bad / sizeof *bad; i++) {
		snprintf(text, sizeof text, "v 0 0 0\nv 0 %s 0", bad[i]);
		refuses(text, MESH_EFORMAT, "is not a coordinate");
		snprintf(text, sizeof text, "ply\nformat ascii 1.0\nelement vertex 1\nproperty int x\n"
		    "property int y\nproperty int z\nend_header\n0 0 %s\n", bad[i]);
		refuses(text, MESH_EFORMAT, "is not a number");
	}
	for (i = 0; i < sizeof huge / sizeof *huge; i++) {
		snprintf(text, sizeof text, "v 0 0 0\nv 0 %s 0", huge[i]);
		refuses(text, MESH_EVALUE, "vertex 1 has a coordinate that is not finite");
	}
	snprintf(text, sizeof text, "v 0 %0200d 0", 1);
	refuses(text, MESH_EFORMAT, "0000...' is not a coordinate");
	refuses("v 0 \x1b[31m 0", MESH_EFORMAT, "'?[31m' is not a coordinate");
}

static void
obj_rules(void **state)
{
	(void)state;
	reads("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3", 3, "0 1 2");
	reads("# c\r\nmtllib a\\\r\no x\r\nv 0 0 0\r\nv 1 0 0 1\r\nv 0 1 0 .1 .2 .3\r\nvt 0 0\r\nvn 0 0 1\r\n"
	    "usemtl m\r\nf 1/1 2//1 3/1/1 # c\r\ns off\r\n", 3, "0 1 2");
	reads("v 0 0 0\nv 1 0 0\nv 0 1 0\nf -3 -2 -1\nv 1 1 0\nf -1 -2 -3", 4, "0 1 2/3 2 1");
	reads("f 1 2 3 4\nv 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n", 4, "0 1 2 3");
	reads("v 0 0 0\nv 1 \\\n0 0\nv 0 1 0\nf 1 \\\r\n 2\\\n 3\n", 3, "0 1 2");
	reads("v 0 0 0\nl 1 1\nfo 1 1 1\nvp 1\n", 1, "");
	refuses("v 0 0 0\nf 0 1 1", MESH_EINDEX, "face 0 has the index 0, OBJ counts from 1");
	refuses("v 0 0 0\nf 1 1 2", MESH_EINDEX, "face 0 refers to vertex 1, there are 1");
	refuses("v 0 0 0\nf 1 1 1\nf -1 -2 1", MESH_EINDEX, "face 1 refers back by 2 vertices, there are 1");
	refuses("v 0 0 0\nf 1 1 99999999999", MESH_EINDEX, "refers to vertex 99999999998, there are 1");
	refuses("v 0 0 0\nf 1 1 a", MESH_EFORMAT, "'a' is not a corner");
	refuses("v 0 0 0\nf 1 1 1x", MESH_EFORMAT, "'1x' is not a corner");
	refuses("v 0 0 0\nf 1 1 /1", MESH_EFORMAT, "'/1' is not a corner");
	refuses("v 0 0 0\nf 1/x 1 1", MESH_EFORMAT, "line 2: '1/x' is not a corner");
	refuses("v 0 0 0\nv 0 0\n", MESH_EFORMAT, "vertex 1 has 2 numbers");
	refuses("v 0 0 0 0 0 0 0 0 0\n", MESH_EFORMAT, "vertex 0 has 9 numbers");
	refuses("o name\n", MESH_EFORMAT, "without vertices");
}

#define HEAD(fmt, nv) "ply\nformat " fmt " 1.0\ncomment c\nelement vertex " nv \
	"\nproperty float x\nproperty float y\nproperty float z\n"
#define FACES(nf) "element face " nf "\nproperty list uchar int vertex_indices\n"

static void
ply_rules(void **state)
{
	(void)state;
	reads(HEAD("ascii", "3") FACES("1") "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", 3, "0 1 2");
	reads("ply\r\nformat ascii 1.0\r\nelement edge 2\r\nproperty uchar r\r\nproperty list int int q\r\n"
	    "element none 4000000000\r\nelement vertex 3\r\nproperty double z\r\nproperty list uchar float w\r\n"
	    "property int16 y\r\nproperty uint8 x\r\nelement face 1\r\nproperty float32 a\r\n"
	    "property list uint32 uint16 vertex_index\r\nproperty list uchar float texcoord\r\nend_header\r\n"
	    "7 0\r\n7 2 1 1\r\n0 0 0 0\r\n0 1 .5 0 1\r\n0 0 1 0\r\n.5 3 2 1 0 1 nan\r\n", 3, "2 1 0");
	reads("ply\nformat ascii 1.0\nelement face 1\nproperty list uchar int vertex_indices\nelement vertex 3\n"
	    "property float x\nproperty float y\nproperty float z\nend_header\n3 0 1 2\n0 0 0 1 0 0 0 1 0", 3, "0 1 2");
	reads(HEAD("ascii", "4") "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
	    "0 0 0\n1 0 0\n0 1 0\n1 1 0\n10 0 1 2 3 3 2 -1 3 2 1\n", 4, "0 1 2/2 1 3/3 2 1");
	refuses("ply\nformat ascii 1.0\n", MESH_EFORMAT, "file ends in the header");
	refuses("ply\nformat text 1.0\n", MESH_EFORMAT, "'text' is not a PLY format");
	refuses("ply\nelement vertex x\n", MESH_EFORMAT, "'x' is not a number of records");
	refuses("ply\nelement vertex -1\n", MESH_EFORMAT, "'-1' is not a number of records");
	refuses("ply\nproperty float x\n", MESH_EFORMAT, "before the first element");
	refuses("ply\nelement vertex 1\nproperty real x\n", MESH_EFORMAT, "'real' is not a type");
	refuses("ply\nelement face 1\nproperty list float int vertex_indices\n", MESH_EFORMAT,
		"to count with");
	refuses("ply\nelement vertex 1\nproperty int x\nproperty int x\n", MESH_EFORMAT,
		"'x' is not a new name");
	refuses("ply\nelement vertex 0\nproperty int x\nend_header\n", MESH_EFORMAT, "no format line");
	refuses("ply\nformat ascii 1.0\nelement vertex 0\nproperty int x\nend_header\n", MESH_EFORMAT,
		"lack x, y or z");
	refuses("ply\nformat ascii 1.0\nend_header\n", MESH_EFORMAT, "no element vertex");
	refuses(HEAD("ascii", "0") "element vertex 0\nend_header\n", MESH_EFORMAT,
		"'vertex' is not a new element");
	refuses(HEAD("ascii", "0") "element face 0\nend_header\n", MESH_EFORMAT, "lack a list vertex_indices");
	refuses("ply\nnonsense\n", MESH_EFORMAT, "header line 2: 'nonsense' is not a header keyword");
	refuses(HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n3 0 0 1\n", MESH_EINDEX,
	    "face 0 refers to vertex 1, there are 1");
	refuses(HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n3 0 0 -1\n", MESH_EINDEX,
		"refers to vertex -1, there are 1");
	refuses(HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n3 0 0 .5\n", MESH_EFORMAT,
		"face 0 has 0.5 where");
	refuses(HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n-3 0 0 0\n", MESH_EFORMAT,
		"face 0 has -3 where");
	refuses(HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n3 0 0 0\n9", MESH_EFORMAT, "1 bytes follow");
	refuses(HEAD("ascii", "0") "element a\x1b[2J 1\nproperty list int int q\nend_header\n-1\n",
		MESH_EFORMAT,
	    "a?[2J 0 has -1 where a whole number belongs");
	refuses(HEAD("ascii", "1") FACES("2") "end_header\n0 0 0\n3 0 0 0\n 3 0", MESH_EFORMAT,
		"file ends in face 1 of 2");
	refuses(HEAD("ascii", "2") "end_header\n0 0 0\n0 inf 0\n", MESH_EVALUE, "vertex 1");
}

/* Binary PLY data may begin with bytes that look like a line end: they must not be taken for one,
 * whatever the line ends of the header. */
static void
ply_line_ends(void **state)
{
	static const char *const end[] = { "\n", "\r\n", "\r" };
	char buf[300];
	int i, n;
	Soup s;

	(void)state;
	for (i = 0; i < 3; i++) {
		n = snprintf(buf, sizeof buf, "ply%sformat binary_big_endian 1.0%selement vertex 1%s"
		    "property uchar x%sproperty uchar y%sproperty char z%send_header%s\n\r\377",
		    end[i], end[i], end[i], end[i], end[i], end[i], end[i]);
		if (parse(&s, buf, (size_t)n))
			fail_msg("line end %d: %s", i, s.err);
		assert_true(s.xyz[0] == 10 && s.xyz[1] == 13 && s.xyz[2] == -1);
		soup_free(&s);
	}
}

#define FACET "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\n"

static void
stl_rules(void **state)
{
	char bin[84 + 50] = "solid but binary";
	Soup s;

	(void)state;
	reads("solid a b\n" FACET "endsolid a", 3, "0 1 2");
	reads("  SOLID\r\n" FACET FACET "endsolid\nsolid 2\n" FACET "endsolid", 9, "0 1 2/3 4 5/6 7 8");
	refuses("solid a\n" FACET, MESH_EFORMAT, "file ends after facet 0: no 'endsolid'");
	refuses("solid a\n" FACET "facet normal 0 0", MESH_EFORMAT, "file ends in facet 1");
	refuses("solid a\n" FACET "facet normal 0 0 1 outer endloop", MESH_EFORMAT,
		"'endloop' where 'loop' belongs");
	refuses("solid a\n" FACET "vertex", MESH_EFORMAT, "'vertex' where 'facet' belongs");
	refuses("solid a\nfacet normal 0 0 z", MESH_EFORMAT, "'z' is not a number");
	bin[80] = 1;
	assert_int_equal(parse(&s, bin, sizeof bin), 0);
	assert_int_equal(s.nv, 3);
	assert_int_equal(s.nf, 1);
	soup_free(&s);
	assert_int_equal(parse(&s, bin, sizeof bin - 1), MESH_EFORMAT);
	assert_non_null(strstr(s.err, "binary STL of 1 triangles has 134 bytes, not 133"));
	memcpy(bin + 84 + 12 + 12, "\0\0\x80\x7f", 4);
	assert_int_equal(parse(&s, bin, sizeof bin), MESH_EVALUE);
	assert_non_null(strstr(s.err, "vertex 1"));
}

/* Text in UTF-16 or UTF-32, with and without a byte order mark, is named with the remedy. */
static void
utf16_text(void **state)
{
	static const char *const text[] = { "\xff\xfe" "v\0 \0" "1\0 \0", "\xfe\xff" "\0v\0 \0" "1",
	    "O\0F\0F\0\n\0" "3", "\0O\0F\0F\0\n" };
	const size_t n[] = { 10, 8, 9, 8 };
	size_t i;
	Soup s;

	(void)state;
	for (i = 0; i < 4; i++) {
		assert_int_equal(parse(&s, text[i], n[i]), MESH_EFORMAT);
		assert_non_null(strstr(s.err, "this is UTF-16 text (iconv"));
	}
	assert_int_equal(parse(&s, "\xff\xfe\0\0v\0\0\0", 8), MESH_EFORMAT);
	assert_non_null(strstr(s.err, "this is UTF-32 text (iconv"));
}

static void
other_kinds(void **state)
{
	(void)state;
	refuses("", MESH_EFORMAT, "empty input");
	refuses("\xef\xbb\xbf", MESH_EFORMAT, "empty input");
	refuses("\n \n", MESH_EFORMAT, "not an OFF, OBJ, PLY, STL, ");
	refuses("hello", MESH_EFORMAT, "not an OFF, OBJ, PLY, STL, ");
	refuses("plywood", MESH_EFORMAT, "not an OFF, OBJ, PLY, STL, ");
	refuses("<?xml version='1.0'?><GIFTI>", MESH_EFORMAT, "NumberOfDataArrays=\"\" is not a number");
	refuses("<?xml version='1.0'?><X3D>", MESH_EFORMAT, "this is another XML or HTML file");
	refuses("<html>", MESH_EFORMAT, "XML");
	refuses("\xff\xff\xff\xff" "x", MESH_EFORMAT, "this is a FreeSurfer patch");
	refuses("\xff\xff\xfd" "x", MESH_EFORMAT, "this is a FreeSurfer surface of quadrangles");
	refuses("MATLAB 5.0 MAT-file, x", MESH_EFORMAT, "MATLAB");
	refuses("lhg 1\n", MESH_EFORMAT, "lhg grid");
}

/* Limits the memory.  A reader that trusts a false count then returns MESH_ENOMEM, which the test
 * takes for an error.  A sanitizer needs much address space itself, and reports large allocations
 * anyway, so there is no limit with one. */
static void
limit(const struct rlimit *old)
{
#ifdef __SANITIZE_ADDRESS__
	(void)old;
#else
	struct rlimit tight = *old;

	tight.rlim_cur = (rlim_t)1 << 27;
	setrlimit(RLIMIT_AS, &tight);
#endif
}

/* Counts and indices that are impossible in a file of a hundred bytes are refused, without
 * allocating memory for them. */
static void
hostile_counts(void **state)
{
	static const char *const count[] = { "4000000000", "-1", "2147483648", "2147483647",
		"1000000000000000000",
	    "99999999999999999999999999" };
	static const char *const text[] = {
		"OFF\n%s 1 0\n0 0 0\n3 0 0 0\n", "OFF\n1 %s 0\n0 0 0\n3 0 0 0\n", "OFF\n1 1 0\n0 0 0\n%s 0 0 0\n",
		"OFF\n1 1 0\n0 0 0\n3 0 0 %s\n", "v 0 0 0\nf 1 1 %s\n", "v 0 0 0\nf 1 1 -%s\n",
		HEAD("ascii", "%s") "end_header\n0 0 0\n", HEAD("binary_little_endian", "%s") "end_header\n0 0 0\n",
		HEAD("ascii", "1") FACES("%s") "end_header\n0 0 0\n3 0 0 0\n",
		HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n%s 0 0 0\n",
		HEAD("ascii", "1") FACES("1") "end_header\n0 0 0\n3 0 0 %s\n",
		HEAD("ascii",
			"1") "element tristrips %s\nproperty list int int vertex_indices\nend_header\n0 0 0\n3 0 0 0\n",
		HEAD("ascii", "1") "element e %s\nproperty int a\nend_header\n0 0 0\n3 0 0 0\n"
	};
	struct rlimit old;
	char file[600];
	size_t i, k;
	Soup s;
	int e;

	(void)state;
	getrlimit(RLIMIT_AS, &old);
	limit(&old);
	for (i = 0; i < sizeof text / sizeof *text; i++)
		for (k = 0; k < sizeof count / sizeof *count; k++) {
			snprintf(file, sizeof file, text[i], count[k]);
			e = parse(&s, file, strlen(file));
			if (!e)
				soup_free(&s);
			if (e != MESH_EFORMAT && e != MESH_EINDEX && !(i == 4 && k == 1)) /* OBJ: -1 */
				fail_msg("%s: code %d %s", file, e, e ? s.err : "");
		}
	setrlimit(RLIMIT_AS, &old);
	refuses("OFF\n4000000000 1 0\n0 0 0\n3 0 0 0\n", MESH_EFORMAT,
	    "header announces 4000000000 vertices, file has room for 2");
	refuses("OFF\n1 1 0\n0 0 0\n2000000000 0 0\n", MESH_EFORMAT, "file ends in face 0 of 1");
}

/* A fan of k triangles around vertex 0, not flat, with coordinates of very different magnitudes. */
static Mesh
fan(int k)
{
	Mesh m = { k + 2, k, malloc((size_t)(k + 2) * 3 * sizeof(double)),
		malloc((size_t)k * 3 * sizeof(int)) };
	int i;

	for (i = 0; i < k + 2; i++) {
		m.xyz[3*i] = i ? cos(i / 3.0) * 1e-7 : 0;
		m.xyz[3*i+1] = i ? sin(i / 3.0) / 3 : -0.0;
		m.xyz[3*i+2] = i * i * 1e17;
	}
	for (i = 0; i < k; i++)
		m.tri[3*i] = 0, m.tri[3*i+1] = i + 1, m.tri[3*i+2] = i + 2;
	return m;
}

static int
same(const Soup *s, const Mesh *m, int single)
{
	size_t i;
	int f;

	for (f = 0; f < s->nf; f++)
		if (s->first[f] != 3*f)
			return 0;
	for (i = 0; s->nv == m->nv && i < (size_t)m->nv * 3; i++)
		if (s->xyz[i] != (single ? (double)(float)m->xyz[i] : m->xyz[i]))
			return 0;
	return s->nv == m->nv && s->nf == m->nf && s->first[s->nf] == 3*m->nf &&
	    memcmp(s->idx, m->tri, (size_t)m->nf * 3 * sizeof(int)) == 0;
}

/* A mesh that was written in any format is read back: bit for bit from formats of doubles with shared
 * vertices; from STL, GIFTI and FreeSurfer with coordinates rounded to float. */
static void
round_trip(void **state)
{
	const MeshFormat *f;
	Mesh m = fan(7);
	int row, i, c;
	char *p;
	size_t n;
	Soup s;

	(void)state;
	for (row = 0; (f = meshformat(row)); row++) {
		if (!(f->can & MESHFORMAT_WRITE))
			continue;
		assert_int_equal(meshfile_write_mesh(&m, f, &p, &n), 0);
		assert_int_equal(parse(&s, p, n), 0);
		if (f->can & MESHFORMAT_SHARED)
			assert_true(same(&s, &m, (f->can & MESHFORMAT_SINGLE) != 0));
		for (i = 0; !(f->can & MESHFORMAT_SHARED) && i < 3*m.nf; i++)
			for (c = 0; c < 3; c++)
				assert_true(s.idx[i] == i &&
				    s.xyz[3*i+c] == (double)(float)m.xyz[3*m.tri[i]+c]);
		soup_free(&s);
		free(p);
	}
	m.xyz[0] = 1e39;
	assert_int_equal(meshfile_write_mesh(&m, meshformat_of("x.stl"), &p, &n), MESH_EVALUE);
	mesh_free(&m);
}

/* A quad cannot be written as STL, which has triangles only. */
static void
stl_holds_triangles(void **state)
{
	static const char quad[] = "OFF\n4 1 0\n0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n";
	size_t n;
	char *p;
	Soup s;

	(void)state;
	assert_int_equal(parse(&s, quad, strlen(quad)), 0);
	assert_int_equal(meshfile_write(&s, meshformat_of("x.stl"), &p, &n), MESH_EFACE);
	soup_free(&s);
}

static void
table_of_formats(void **state)
{
	static const char *const target[] = { "off", "obj", "ply", "stl", "xyz", "mni", "hoppe", "fsbinary", "fsascii",
	    "vtk", "vtp", "gifti", "gltf" };
	char list[MESHFORMAT_LIST], file[100];
	const MeshFormat *f;
	int row;

	(void)state;
	assert_string_equal(meshformat_of("a.OFF")->name, "OFF");
	assert_string_equal(meshformat_of("a.b.stl")->name, "STL");
	assert_null(meshformat_of(".ply"));
	assert_null(meshformat_of("plyx"));
	assert_null(meshformat_of("off"));
	assert_null(meshformat(-1));
	assert_string_equal(meshformat_names(0, "or", list), "OFF, OBJ, PLY, STL, XYZ, MNI OBJ, Hoppe M, FreeSurfer, "
	    "FreeSurfer ASCII, VTK, VTP, GIFTI or glTF");
	assert_string_equal(meshformat_names(MESHFORMAT_WRITE, "or", list), "OFF, OBJ, PLY, STL, FreeSurfer, VTP or GIFTI");
	assert_string_equal(meshformat_names(MESHFORMAT_UV, "and", list), "OBJ and PLY");
	assert_string_equal(meshformat_ends(MESHFORMAT_WRITE, list), ".off .obj .ply .stl .pial .white .vtp or .gii");
	assert_string_equal(meshformat_ends(MESHFORMAT_SHARED | MESHFORMAT_WRITE, list), ".off .obj .ply .pial .white .vtp or .gii");
	for (row = 0; (f = meshformat(row)); row++) {
		snprintf(file, sizeof file, "x%.*s", (int)strcspn(f->ends, " "), f->ends);
		assert_true(meshformat_of(file) == f || !(f->can & MESHFORMAT_WRITE));
		assert_true(!f->write == !(f->can & MESHFORMAT_WRITE));
		assert_true(row < (int)(sizeof target/sizeof *target));
		snprintf(file, sizeof file, "tests/fuzz/%s.c", target[row]);
		assert_int_equal(access(file, R_OK), 0);        /* every format has a fuzz target */
	}
}

/* Appends the n low bytes of w, in big-endian order if `big`, else in little-endian order. */
static void
bytes(char **p, unsigned long w, int n, int big)
{
	int i;

	for (i = 0; i < n; i++)
		*(*p)++ = (char)(w >> 8*(big ? n-1 - i : i));
}

/* The bits of the float with the value i. */
static unsigned long
asfloat(int i)
{
	float x = (float)i;
	uint32_t w;

	memcpy(&w, &x, 4);
	return w;
}

/* Writes two faces of a tetrahedron to buf as binary OFF or PLY; `colours` (OFF only) adds colours to
 * the faces.  Returns the length. */
static size_t
binaryfile(char *buf, int ply, int big, int colours)
{
	static const int at[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 0, 1, 0 }, { 0, 0, 1 } };
	char *p = buf;
	int i, f;

	if (ply) {
		p += sprintf(p, HEAD("binary_%s_endian", "4") FACES("2") "end_header\n", big ? "big" : "little");
	} else {
		p += sprintf(p, "OFF BINARY\n");
		bytes(&p, 4, 4, big), bytes(&p, 2, 4, big), bytes(&p, 0, 4, big);
	}
	for (i = 0; i < 12; i++)
		bytes(&p, asfloat(at[i/3][i%3]), 4, big);
	for (f = 0; f < 2; f++) {
		bytes(&p, 3, ply ? 1 : 4, big);
		bytes(&p, 0, 4, big), bytes(&p, (unsigned)f + 1, 4, big), bytes(&p, (unsigned)f + 2, 4, big);
		if (colours)
			bytes(&p, (unsigned)f, 4, big), bytes(&p, 0, f ? 4 : 0, big);
	}
	return (size_t)(p - buf);
}

static void
binary_files(void **state)
{
	char buf[500];
	int ply, big, colours, e;
	size_t n, k;
	Soup s;

	(void)state;
	for (ply = 0; ply < 2; ply++)
		for (big = 0; big < 2; big++)
			for (colours = 0; colours <= !ply; colours++) {
				n = binaryfile(buf, ply, big, colours);
				e = parse(&s, buf, n);
				if (e)
					fail_msg("ply %d big %d: %s", ply, big, s.err);
				assert_int_equal(s.nv, 4);
				assert_int_equal(s.nf, 2);
				assert_true(s.xyz[3] == 1 && s.xyz[7] == 1 && s.xyz[11] == 1);
				assert_true(s.idx[1] == 1 && s.idx[2] == 2 && s.idx[4] == 2 && s.idx[5] == 3);
				soup_free(&s);
				for (k = 0; k < n; k++)
					assert_true(parse(&s, buf, k) < 0);
				assert_int_equal(parse(&s, buf, n + 1), MESH_EFORMAT);
				assert_true(colours || strstr(s.err, "1 bytes follow"));
			}
}

/* A file that is cut anywhere is refused, except an OFF file that lacks only its line end or digits
 * of its last number. */
static void
every_cut(void **state)
{
	static const char *const ends[] = { ".off", ".ply", ".stl" };
	Mesh m = fan(12);
	char name[8], *p;
	size_t i, k, n;
	Soup s;

	(void)state;
	for (i = 0; i < 3; i++) {
		snprintf(name, sizeof name, "x%s", ends[i]);
		assert_int_equal(meshfile_write_mesh(&m, meshformat_of(name), &p, &n), 0);
		for (k = 0; k < n; k++)
			if (parse(&s, p, k) == 0) {
				if (i != 0 || k < n - 2)
					fail_msg("%s cut at %zu of %zu passes", ends[i], k, n);
				soup_free(&s);
			}
		free(p);
	}
	mesh_free(&m);
}

/* Each byte of a file is replaced by each of a few values.  The reader may accept or refuse the
 * result, but must not crash, access memory out of bounds or return an index out of range. */
static void
changed(const char *bytes, size_t n)
{
	static const unsigned char to[] = { 0, '\n', '-', '/', '0', '9', '\\', 'e', 0x7f, 0x80, 0xff };
	char *copy = malloc(n);
	size_t i, k;
	int c;
	Soup s;

	for (i = 0; i < n; i++)
		for (k = 0; k < sizeof to; k++) {
			memcpy(copy, bytes, n);
			copy[i] = (char)to[k];
			if (parse(&s, copy, n))
				continue;
			for (c = 0; c < s.first[s.nf]; c++)
				assert_true(s.idx[c] >= 0 && s.idx[c] < s.nv);
			for (c = 0; c < 3*s.nv; c++)
				assert_true(isfinite(s.xyz[c]));
			soup_free(&s);
		}
	free(copy);
}

static void
every_byte(void **state)
{
	static const char obj[] = "v 0 0 0\r\nv 1 \\\r\n0 0\nv 0 1.5e-1 0\nf 1/1/1 2//2 -1\nf -3 -2 3";
	static const char strips[] = HEAD("ascii", "3")
	    "element tristrips 1\nproperty list int int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n5 0 1 2 -1 0";
	static const char stl[] = "solid\n" FACET "endsolid";
	char buf[500];
	int row;
	Mesh m = fan(3);
	size_t n;
	char *p;

	(void)state;
	for (row = 0; meshformat(row); row++) {
		if (!(meshformat(row)->can & MESHFORMAT_WRITE))
			continue;
		assert_int_equal(meshfile_write_mesh(&m, meshformat(row), &p, &n), 0);
		changed(p, n);
		free(p);
	}
	mesh_free(&m);
	changed(obj, sizeof obj - 1);
	changed(strips, sizeof strips - 1);
	changed(stl, sizeof stl - 1);
	changed(buf, binaryfile(buf, 0, 1, 1));
	changed(buf, binaryfile(buf, 1, 1, 0));
}

/* Compresses the bytes to one gzip member.  Returns its length. */
static size_t
deflated(const char *bytes, size_t n, unsigned char *out, size_t room)
{
	z_stream z;

	memset(&z, 0, sizeof z);
	assert_int_equal(deflateInit2(&z, 9, Z_DEFLATED, 15 + 16, 8, Z_DEFAULT_STRATEGY), Z_OK);
	z.next_in = (Bytef *)(uintptr_t)bytes;
	z.avail_in = (uInt)n;
	z.next_out = out;
	z.avail_out = (uInt)room;
	assert_int_equal(deflate(&z, Z_FINISH), Z_STREAM_END);
	deflateEnd(&z);
	return room - z.avail_out;
}

/* meshfile_plausible decides from the first bytes of a file whether it can be a mesh. */
static void
first_bytes_tell_a_mesh(void **state)
{
	static const char *const good[] = { "OFF\n3 1 0\n", "v 0 0 0\n", "ply\nformat ascii 1.0\n",
		"solid a\n",
	    "# a comment\n\n", "\x1f\x8b\b", "\xef\xbb\xbfOFF\n3" };
	static const char *const bad[] = { "y\ny\n", "hello ", "<html> ", "lhg 1\nu ", "plywood ",
		"\x89HDF\r\n " };
	unsigned char z[500];
	char head[1000], err[MESH_ERRLEN];
	size_t i, n;

	(void)state;
	for (i = 0; i < sizeof good/sizeof *good; i++)
		if (meshfile_plausible(good[i], strlen(good[i]), MOST, err))
			fail_msg("'%s': %s", good[i], err);
	for (i = 0; i < sizeof bad/sizeof *bad; i++) {
		assert_int_equal(meshfile_plausible(bad[i], strlen(bad[i]), MOST, err), MESH_EFORMAT);
		n = deflated(bad[i], strlen(bad[i]), z, sizeof z);
		assert_int_equal(meshfile_plausible(z, n - 8, MOST, err), MESH_EFORMAT);
	}
	n = deflated(good[0], strlen(good[0]), z, sizeof z);
	assert_int_equal(meshfile_plausible(z, n - 8, MOST, err), 0);
	memset(head, 0, sizeof head);   /* one word, longer than any that begins a format */
	assert_int_equal(meshfile_plausible(head, sizeof head, MOST, err), MESH_EFORMAT);
	head[0] = 'x', head[9] = ' ';   /* like a binary STL, but of 0 triangles */
	assert_int_equal(meshfile_plausible(head, sizeof head, MOST, err), MESH_EFORMAT);
	head[81] = 1;                   /* now of 256 triangles: 12884 bytes */
	assert_int_equal(meshfile_plausible(head, sizeof head, 12884, err), 0);
	assert_int_equal(meshfile_plausible(head, sizeof head, 12883, err), MESH_EFORMAT);
}

static void
gzipped(void **state)
{
	static const char a[] = "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n", b[] = "3 0 1 2\n";
	unsigned char z[400], bad[400], *big;
	size_t i, n;
	char *zeros;
	Soup s;

	(void)state;
	n = deflated(a, strlen(a), z, sizeof z);
	n += deflated(b, strlen(b), z + n, sizeof z - n);
	assert_int_equal(parse(&s, z, n), 0);
	assert_int_equal(s.nf, 1);
	soup_free(&s);
	for (i = 0; i < n; i++)
		assert_int_equal(parse(&s, z, i), MESH_EFORMAT);
	assert_int_equal(parse(&s, z, n - 1), MESH_EFORMAT);
	assert_string_equal(s.err, "gzip data end early");
	for (i = 10; i < n; i++) {
		memcpy(bad, z, n);
		bad[i] ^= 0x10;
		if (parse(&s, bad, n) == 0)
			soup_free(&s);          /* some bits of a gzip header have no effect */
		else
			assert_true(strstr(s.err, "gzip") || strstr(s.err, "face") || strstr(s.err, "header"));
	}
	memcpy(z + n, "x", 1);
	assert_int_equal(parse(&s, z, n + 1), MESH_EFORMAT);
	n = deflated("", 0, z, sizeof z);
	assert_int_equal(parse(&s, z, n), MESH_EFORMAT);
	assert_string_equal(s.err, "empty input");
	zeros = calloc(1, 1 << 22);
	big = malloc(1 << 16);
	n = deflated(zeros, 1 << 22, big, 1 << 16);     /* 1000:1 is allowed */
	assert_int_equal(parse(&s, big, n), MESH_EFORMAT);
	assert_null(strstr(s.err, "gzip data"));
	free(zeros);
	free(big);
}

/* A file of any format gives the same soup when it is compressed with gzip. */
static void
same_gzipped(const char *bytes, size_t n)
{
	unsigned char *z = malloc(n + 500);
	size_t nz = deflated(bytes, n, z, n + 500);
	Soup s, g;

	if (parse(&s, bytes, n) || parse(&g, z, nz))
		fail_msg("'%.20s': %s %s", bytes, s.err, g.err);
	assert_true(s.nv > 0 && s.nf > 0);
	assert_true(g.nv == s.nv && g.nf == s.nf);
	assert_memory_equal(g.xyz, s.xyz, (size_t)s.nv * 3 * sizeof(double));
	assert_memory_equal(g.first, s.first, ((size_t)s.nf + 1) * sizeof(int));
	assert_memory_equal(g.idx, s.idx, (size_t)s.first[s.nf] * sizeof(int));
	soup_free(&s);
	soup_free(&g);
	free(z);
}

static void
every_kind_gzipped(void **state)
{
	static const char *const text[] = {
		"OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n",
		HEAD("ascii", "3") FACES("1") "end_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n",
		"solid\n" FACET "endsolid"
	};
	char buf[500], *p;
	Mesh m = fan(5);
	size_t i, n;
	int k;

	(void)state;
	for (i = 0; i < sizeof text / sizeof *text; i++)
		same_gzipped(text[i], strlen(text[i]));
	for (k = 0; meshformat(k); k++) {
		if (!(meshformat(k)->can & MESHFORMAT_WRITE))
			continue;
		assert_int_equal(meshfile_write_mesh(&m, meshformat(k), &p, &n), 0);
		same_gzipped(p, n);
		free(p);
	}
	mesh_free(&m);
	for (k = 0; k < 8; k++)                         /* binary OFF and PLY, in both byte orders */
		if (!(k & 1) || !(k & 4))
			same_gzipped(buf, binaryfile(buf, k & 1, k >> 1 & 1, k >> 2 & 1));
}

static double *
uv_of(const Soup *s)
{
	return channel_values(&s->channels, MESH_UV);
}

static int
parseuv(Soup *s, const void *bytes, size_t n)
{
	char *copy = malloc(n + !n);
	int e;

	memcpy(copy, bytes, n);
	e = meshfile_parse_as(s, copy, n, &(MeshParse){ .most = MOST, .what = MESHFILE_UV });
	free(copy);
	if (e)
		assert_true(!s->xyz && !s->first && !s->idx && !s->channels.n && s->err[0] && !strchr(s->err, '\n'));
	return e;
}

/* Checks that the text is read with this T and these (u,v), and that it can also be read without
 * them. */
static void
readsuv(const char *text, double T, int nv, const double *uv)
{
	int i;
	Soup s;

	if (parseuv(&s, text, strlen(text)))
		fail_msg("'%s': %s", text, s.err);
	assert_int_equal(s.nv, nv);
	for (i = 0; i < 2*nv; i++)
		if (uv_of(&s)[i] != uv[i])
			fail_msg("'%s': number %d is %g", text, i, uv_of(&s)[i]);
	assert_true(s.T == T);
	soup_free(&s);
	assert_int_equal(parse(&s, text, strlen(text)), 0);
	assert_true(!uv_of(&s) && s.T == 0 && s.nv == nv);
	soup_free(&s);
}

static void
refusesuv(const char *text, int code, const char *why)
{
	Soup s;
	int e = parseuv(&s, text, strlen(text));

	if (!e)
		soup_free(&s);
	if (e != code || !strstr(s.err, why))
		fail_msg("'%.60s': code %d, '%s', not %d, '%s'", text, e, e ? s.err : "", code, why);
}

#define TRI "v 0 0 0\nv 1 0 0\nv 0 1 0\n"
#define VT "vt .5 .25\nvt 0 1\nvt 1 0\n"
#define PLYUV(c, p) "ply\nformat ascii 1.0\n" c "element vertex 3\nproperty float x\nproperty float y\n" \
	"property float z\n" p FACES("1") "end_header\n"

static void
obj_uv(void **state)
{
	static const double uv[8] = { .5, .25, 0, 1, 1, 0, -1, -1 }, turned[6] = { 1, 0, .5, .25, 0, 1 };

	(void)state;
	readsuv(TRI VT "f 1/1 2/2 3/3\n", 0, 3, uv);
	readsuv("# lhgrid T 0.75\n" TRI VT "f 1/1 2/2 3/3\n", 0.75, 3, uv);
	readsuv("# by hand\n#\n#lhgrid T 3\n# lhgrid 5\n" TRI "# lhgrid T 1e-3 # so\n" VT "f 1/1 2/2 3/3",
		1e-3, 3, uv);
	readsuv(TRI "v 1 1 0\n" VT "f 1/1/1 2/2/1 3/3/1 # lhgrid T 7\n", 0, 4, uv);  /* 3: no face */
	readsuv("f 1/1/7 2/2/7 3/3/7\n" VT TRI, 0, 3, uv);
	readsuv(TRI VT "f 1/-3 2/-2 3/-1\n", 0, 3, uv);
	readsuv(TRI VT "f 2/1 3/2 1/3\n", 0, 3, turned);
	readsuv(TRI "vt .5 .25 0\nvt 0 1 0\nvt 1 0 0\nvt .5 .25\nf 1/1 2/2 3/3\nf 1/4 3/3 2/2\n", 0, 3, uv);
	readsuv("# lhgrid chart sock\n" TRI VT "vt 1.5 .25\nvt 0 -1\nf 1/4 2/5 3/3\n", 0, 3, uv);    /* images */
	refusesuv("# lhgrid chart sock\n" TRI VT "vt .5 -.3\nf 1/1 2/2 3/3\nf 1/4 3/3 2/2\n", MESH_EVALUE,
	    "vertex 0 has two (u,v)");
	refusesuv("# lhgrid chart rectangle\n" TRI VT "vt 1.5 .25\nf 1/1 2/2 3/3\nf 1/4 3/3 2/2\n", MESH_EVALUE,
	    "vertex 0 has two (u,v)");
	refusesuv("#\n# lhgrid chart shoe\n" TRI VT "f 1/1 2/2 3/3\n", MESH_EVALUE, "line 2: no chart is called 'shoe'");
	refusesuv(TRI "f 1 2 3\n", MESH_EFORMAT, "face 0 gives no vt for vertex 0");
	refusesuv(TRI VT "f 1/1 2//2 3/3\n", MESH_EFORMAT, "face 0 gives no vt for vertex 1");
	refusesuv(TRI VT "f 1/1 2/2 3/3\nf 1/1 3/2 2/2\n", MESH_EVALUE,
	    "vertex 2 has two (u,v), the second in face 1: a seam");
	refusesuv(TRI VT "vt 1 .1\nf 1/1 2/2 3/3\nf 1/1 3/4 2/2\n", MESH_EVALUE, "vertex 2 has two (u,v)");
	refusesuv(TRI VT "f 1/1 2/2 3/4\n", MESH_EINDEX, "face 0 refers to vt 3, there are 3");
	refusesuv(TRI VT "f 1/1 2/2 3/99999999999\n", MESH_EINDEX, "face 0 refers to vt");
	refusesuv(TRI VT "f 1/1 2/0 3/3\n", MESH_EINDEX, "index 0");
	refusesuv(TRI VT "f 1/1 2/2 3/-4\n", MESH_EINDEX, "refers back by 4 vt lines, there are 3");
	refusesuv(TRI "vt 0\nf 1/1 2/1 3/1\n", MESH_EFORMAT, "line 4: vt 0 has 1 numbers");
	refusesuv(TRI "vt 0 nan\nf 1/1 2/1 3/1\n", MESH_EVALUE, "line 4: vt 0 is not finite");
	refusesuv(TRI "vt 0 x\nf 1/1 2/1 3/1\n", MESH_EFORMAT, "'x' is not a coordinate");
	refusesuv(TRI VT "# lhgrid T\nf 1/1 2/2 3/3\n", MESH_EVALUE, "T '' is not a positive number");
	refusesuv(TRI VT "# lhgrid T -1\nf 1/1 2/2 3/3\n", MESH_EVALUE, "line 7: T '-1' is not a positive");
	refusesuv(TRI VT "# lhgrid T nan\nf 1/1 2/2 3/3\n", MESH_EVALUE, "is not a positive number");
	refusesuv(TRI VT "f 1/1 2/2 4/3\n", MESH_EINDEX, "face 0 refers to vertex 3, there are 3");
	refusesuv("OFF\n0 0 0\n", MESH_EFORMAT, "only OBJ and PLY carry (u,v)");
	reads(TRI VT "f 1/1 2/2 3/3\nf 1/1 3/2 2/2\n", 3, "0 1 2/0 2 1"); /* allowed if (u,v) are not read */
	reads(TRI "vt nan\n# lhgrid T x\nf 1/7 2/7 3/7\n", 3, "0 1 2");
}

static void
ply_uv(void **state)
{
	static const double uv[6] = { .5, .25, 0, 1, -1, -1 };
	static const char data[] = "0 0 0 .5 .25\n1 0 0 0 1\n0 1 0 -1 -1\n3 0 1 2\n";
	static const char *const pair[][2] = { { "s", "t" }, { "u", "v" }, { "texture_u", "texture_v" } };
	char text[600];
	int i;

	(void)state;
	for (i = 0; i < 3; i++) {
		snprintf(text, sizeof text, PLYUV("comment lhgrid T .5\ncomment x\n",
			"property double %s\nproperty float %s\n")
		    "%s", pair[i][0], pair[i][1], data);
		readsuv(text, .5, 3, uv);
	}
	readsuv(PLYUV("",
		"property float u\nproperty float q\nproperty float t\nproperty float s\nproperty float v\n")
	    "0 0 0 9 9 .25 .5 9\n1 0 0 9 9 1 0 9\n0 1 0 9 9 -1 -1 9\n3 0 1 2\n", 0, 3, uv); /* s t first */
	refusesuv(PLYUV("", "property float s\nproperty float v\n") "0 0 0 0 0\n", MESH_EFORMAT,
		"vertices lack (u,v)");
	refusesuv(PLYUV("", "") "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", MESH_EFORMAT, "vertices lack (u,v)");
	refusesuv(PLYUV("", "property list int int s\nproperty float t\n"), MESH_EFORMAT,
		"vertices lack (u,v)");
	refusesuv(PLYUV("",
		"property float s\nproperty float t\n") "0 0 0 1 nan\n1 0 0 0 0\n0 1 0 0 0\n3 0 1 2\n",
	    MESH_EVALUE, "vertex 0 has a (u,v) that is not finite");
	refusesuv("ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float s\n"
	    "property float t\nend_header\n0 0 0 0\n", MESH_EFORMAT, "vertices lack x, y or z");
	refusesuv(PLYUV("comment lhgrid T inf\n", ""), MESH_EVALUE, "T 'inf' is not a positive number");
	refusesuv(PLYUV("", "property float s\nproperty float s\nproperty float t\n"), MESH_EFORMAT,
		"not a new name");
	refusesuv("ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty int x\nproperty int y\nproperty int z\n"
	    "property int s\nproperty int t\nend_header\n0 0 0 0 0\n", MESH_EFORMAT, "file has room for");
}

/* The offsets of three vertices are read from comments of an OBJ and from properties of a PLY. */
static void
offsets(void **state)
{
	static const double o[12] = { 1, -.5, .25, 0, 0, 0, 0, 0, 3, 4, 5e-3, .125 };
	static const char one[] = "# lhgrid offset 1 -.5 .25 0\n", two[] = "# lhgrid offset 0 0 0 0\n",
	    three[] = "# lhgrid offset\n# lhgrid offset 3 4 5e-3 .125 # the last\n";
	char text[600];
	Soup s;
	int i;

	(void)state;
	for (i = 0; i < 2; i++) {
		if (i)
			snprintf(text, sizeof text, PLYUV("",
			    "property float s\nproperty double offset_n\nproperty float t\n"
			    "property double offset_u\nproperty double offset_r\nproperty double offset_v\n")
			    "0 0 0 0 .25 0 1 0 -.5\n1 0 0 1 0 0 0 0 0\n0 1 0 0 5e-3 1 3 .125 4\n3 0 1 2\n");
		else
			snprintf(text, sizeof text, TRI VT "%s" "f 1/1 2/2 3/3\n" "%s%s", one, two, strchr(three, '\n') + 1);
		assert_int_equal(parseuv(&s, text, strlen(text)), 0);
		assert_memory_equal(channel_values(&s.channels, MESH_OFFSET), o, sizeof o);
		soup_free(&s);
		assert_int_equal(parse(&s, text, strlen(text)), 0);
		assert_null(channel_values(&s.channels, MESH_OFFSET));
		soup_free(&s);
	}
	snprintf(text, sizeof text, TRI VT "f 1/1 2/2 3/3\n" "%s%s", one, two);
	refusesuv(text, MESH_EFORMAT, "2 offsets for 3 vertices");
	snprintf(text, sizeof text, TRI VT "f 1/1 2/2 3/3\n" "%s%s", one, three);
	refusesuv(text, MESH_EFORMAT, "line 9: offset 1 ends in '', need four numbers");
	refusesuv(TRI VT "# lhgrid offset 1 2 x 4\nf 1/1 2/2 3/3\n", MESH_EFORMAT,
	    "line 7: offset 0 ends in 'x'");
	snprintf(text, sizeof text, TRI VT "f 1/1 2/2 3/3\n" "%s%s# lhgrid offset 0 0 0 -1\n", one, two);
	refusesuv(text, MESH_EVALUE, "vertex 2 has an offset that is not finite, or of negative extent");
	snprintf(text, sizeof text, TRI VT "f 1/1 2/2 3/3\n" "%s# lhgrid offset 0 inf 0 1\n%s", one, two);
	refusesuv(text, MESH_EVALUE, "vertex 1 has an offset that is not finite");
	refusesuv(PLYUV("",
	    "property float s\nproperty float t\nproperty float offset_u\nproperty float offset_n\n"),
	    MESH_EFORMAT, "vertices have 2 of the properties offset_u offset_v offset_n offset_r");
}

/* A soup of a triangle, a quad, a polygon of n corners and a vertex without a face, with (u,v) and
 * offsets. */
static Soup
polygons(int n)
{
	Soup s = { .nv = n + 1, .nf = 3, .T = 1/3., .xyz = malloc((size_t)(n + 1) * 24), .first = malloc(16),
	    .idx = malloc((size_t)(n + 7) * 4) };
	double *uv = channel_add(&s.channels, MESH_UV, 2, (size_t)n + 1);
	double *o = channel_add(&s.channels, MESH_OFFSET, 4, (size_t)n + 1);
	int i;

	for (i = 0; i < 4*n + 4; i++)
		o[i] = i%4 == 1 ? -1/(i + 3.) : i/7e9;

	for (i = 0; i <= n; i++) {
		s.xyz[3*i] = cos(i), s.xyz[3*i+1] = sin(i)*1e-9, s.xyz[3*i+2] = i/7.;
		uv[2*i] = i < n ? i/(n + 1.) : -1, uv[2*i+1] = i < n ? s.T/(i + 1) : -1;
	}
	for (i = 0; i < n + 7; i++)
		s.idx[i] = i < 3 ? i : i < 7 ? n - i + 2 : i - 7;
	s.first[0] = 0, s.first[1] = 3, s.first[2] = 7, s.first[3] = n + 7;
	return s;
}

/* Formats of doubles with shared vertices give soups back bit for bit; those of floats have only triangles.  Polygons stay polygons; (u,v) and offsets
 * come back from OBJ and PLY, if they were written (OFF cannot store them).  Writing the soup that was
 * read gives the same file. */
static void
soup_round_trip(void **state)
{
	const unsigned both = MESHFORMAT_SHARED | MESHFORMAT_WRITE;
	static const int corners[] = { 5, 255, 256, 1000 };
	Soup a, b, plain;
	char *p, *q;
	const MeshFormat *f;
	size_t i, n, nq;
	int row, uv;

	(void)state;
	for (i = 0; i < 4; i++) {
		a = polygons(corners[i]);
		for (row = 0; (f = meshformat(row)); row++)
			for (uv = 0; (f->can & both) == both && !(f->can & MESHFORMAT_SINGLE) && uv < (f->can & MESHFORMAT_UV ? 2 : 1); uv++) {
				plain = a;
				if (!uv)
					plain.channels = (Channels){ 0 };
				assert_int_equal(meshfile_write(&plain, f, &p, &n), 0);
				assert_int_equal(uv ? parseuv(&b, p, n) : parse(&b, p, n), 0);
				assert_true(b.nv == a.nv && b.nf == a.nf && b.T == (uv ? a.T : 0));
				assert_memory_equal(b.xyz, a.xyz, (size_t)a.nv * 24);
				assert_memory_equal(b.first, a.first, 16);
				assert_memory_equal(b.idx, a.idx, (size_t)a.first[3] * 4);
				assert_true(!uv_of(&b) == !uv);
				if (uv)
					assert_memory_equal(uv_of(&b), uv_of(&a), (size_t)a.nv * 16);
				if (uv)
					assert_memory_equal(channel_values(&b.channels, MESH_OFFSET),
					    channel_values(&a.channels, MESH_OFFSET), (size_t)a.nv * 32);
				assert_int_equal(meshfile_write(&b, f, &q, &nq), 0);
				assert_true(nq == n && memcmp(p, q, n) == 0);
				free(p);
				free(q);
				soup_free(&b);
			}
		soup_free(&a);
	}
}

/* PLY carries the numbers that vertices had in another file, and the marks of faces that fill holes;
 * remarks become comments. */
static void
marks_of_mesh2disk(void **state)
{
	Soup a = polygons(5), b, out;
	const double *source;
	char *p, *q;
	size_t n, nq;
	int v, f;

	(void)state;
	channels_free(&a.channels);
	assert_non_null(channel_add(&a.channels, MESH_SOURCE, 1, (size_t)a.nv));
	assert_non_null(a.filled = malloc((size_t)a.nf));
	for (v = 0; v < a.nv; v++)
		channel_values(&a.channels, MESH_SOURCE)[v] = v == 1 ? -1 : 2147483647 - v;
	for (f = 0; f < a.nf; f++)
		a.filled[f] = f%2;
	a.remarks = "one\ntwo\n";
	assert_int_equal(meshfile_write(&a, meshformat_of("x.ply"), &p, &n), 0);
	assert_non_null(strstr(p, "comment one\ncomment two\n"));
	assert_int_equal(parse(&b, p, n), 0);
	source = channel_values(&b.channels, MESH_SOURCE);
	assert_memory_equal(source, channel_values(&a.channels, MESH_SOURCE), (size_t)a.nv*sizeof *source);
	assert_memory_equal(b.filled, a.filled, (size_t)a.nf);
	b.remarks = a.remarks;
	assert_int_equal(meshfile_write(&b, meshformat_of("x.ply"), &q, &nq), 0);
	assert_true(nq == n && memcmp(p, q, n) == 0);
	assert_int_equal(filled_drop(&b), a.nf/2);
	assert_null(b.filled);
	assert_int_equal(b.nf, a.nf - a.nf/2);
	assert_int_equal(filled_drop(&b), 0);
	soup_free(&b);
	free(q);

	assert_int_equal(meshfile_write(&a, meshformat_of("x.off"), &q, &nq), 0);
	assert_int_equal(parse(&out, q, nq), 0);        /* OFF has no place for them */
	assert_true(!out.filled && !channel_find(&out.channels, MESH_SOURCE));
	soup_free(&out);
	free(p);
	free(q);
	soup_free(&a);
}

/* What is no error of the file, but of the mesh, is left to those who read loosely. */
static void
loose_reading(void **state)
{
	static const char text[] = "OFF\n3 2 0\n0 0 nan\n1 0 0\n0 1 0\n3 0 1 2\n3 0 1 7\n";
	const MeshParse loose = { .most = MESHFILE_MOST, .what = MESHFILE_LOOSE };
	Soup s;

	(void)state;
	assert_int_equal(meshfile_parse(&s, text, sizeof text - 1, MESHFILE_MOST), MESH_EVALUE);
	assert_int_equal(meshfile_parse_as(&s, text, sizeof text - 1, &loose), 0);
	assert_int_equal(s.nf, 2);
	assert_int_equal(s.idx[5], 7);
	assert_false(isfinite(s.xyz[2]));
	soup_free(&s);
	assert_int_equal(meshfile_parse_as(&s, text, 20, &loose), MESH_EFORMAT);
}

/* A file with (u,v) that is cut anywhere or has a changed byte is refused, or gives a soup with
 * finite (u,v). */
static void
damaged_uv(void **state)
{
	static const char to[] = { 0, '\n', '-', '/', '0', '9', 'e', '#', (char)0x80, (char)0xff };
	Soup a = polygons(5), s;
	char *p, *copy;
	size_t n, i, k;
	int row, c;

	(void)state;
	for (row = 0; meshformat(row); row++) {
		if (!(meshformat(row)->can & MESHFORMAT_UV))
			continue;
		assert_int_equal(meshfile_write(&a, meshformat(row), &p, &n), 0);
		copy = malloc(n);
		for (i = 0; i < n; i++) {
			if (!parseuv(&s, p, i))
				soup_free(&s);
			for (k = 0; k < sizeof to; k++) {
				memcpy(copy, p, n);
				copy[i] = to[k];
				if (parseuv(&s, copy, n))
					continue;
				for (c = 0; c < 2*s.nv; c++)
					assert_true(isfinite(uv_of(&s)[c]));
				assert_true(s.T >= 0 && isfinite(s.T));
				soup_free(&s);
			}
		}
		free(p);
		free(copy);
	}
	soup_free(&a);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(off_rules),
		cmocka_unit_test(number_rules),
		cmocka_unit_test(obj_rules),
		cmocka_unit_test(ply_rules),
		cmocka_unit_test(ply_line_ends),
		cmocka_unit_test(stl_rules),
		cmocka_unit_test(utf16_text), cmocka_unit_test(other_kinds),
		cmocka_unit_test(hostile_counts),
		cmocka_unit_test(round_trip),
		cmocka_unit_test(stl_holds_triangles),
		cmocka_unit_test(table_of_formats),
		cmocka_unit_test(first_bytes_tell_a_mesh),
		cmocka_unit_test(binary_files),
		cmocka_unit_test(every_cut),
		cmocka_unit_test(every_byte),
		cmocka_unit_test(gzipped),
		cmocka_unit_test(every_kind_gzipped),
		cmocka_unit_test(obj_uv),
		cmocka_unit_test(ply_uv),
		cmocka_unit_test(offsets),
		cmocka_unit_test(soup_round_trip),
		cmocka_unit_test(marks_of_mesh2disk),
		cmocka_unit_test(loose_reading),
		cmocka_unit_test(damaged_uv),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
