/* test_beside.c - glTF buffers and GIFTI arrays in files beside the mesh: what is read of them, which names are refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/mesh/channel.h"
#include "../lib/meshfile/fieldfile.h"
#include "../lib/meshfile/meshfile.h"

/* Four float vertices (0,0,0) (1,0,0) (0,1,0) (1,1,.5), the triangles 0 1 2 and 2 1 3 as integers of 32 bits. */
#define POINTS "\0\0\0\0\0\0\0\0\0\0\0\0" "\0\0\x80?\0\0\0\0\0\0\0\0" "\0\0\0\0\0\0\x80?\0\0\0\0" "\0\0\x80?\0\0\x80?\0\0\0?"
#define CORNERS "\0\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\1\0\0\0\3\0\0\0"
enum { NPOINTS = 48, NCORNERS = 24, BOTH = NPOINTS + NCORNERS };

/* A folder in memory with a file of any name but "none", and what was read last. */
typedef struct Folder {
	const char *bytes;
	size_t n;
	char name[300];
	unsigned long long from;
	size_t want;
	int count;
} Folder;

static Folder folder;

static int
read_file(const void *arg, const char *name, unsigned long long from, size_t want, char **bytes, size_t *n,
	char err[MESH_ERRLEN])
{
	const size_t left = from < folder.n ? folder.n - (size_t)from : 0;

	assert_ptr_equal(arg, &folder);
	snprintf(folder.name, sizeof folder.name, "%s", name);
	folder.from = from;
	folder.want = want;
	folder.count++;
	if (strcmp(name, "none") == 0) {
		snprintf(err, MESH_ERRLEN, "it is not there");
		return MESH_EFORMAT;
	}
	*n = want < left ? want : left;
	*bytes = malloc(*n + !*n);
	memcpy(*bytes, folder.bytes + (left ? from : 0), *n);
	return 0;
}

static const MeshBeside beside = { read_file, &folder };

static void
holds(const char *bytes, size_t n)
{
	folder = (Folder){ .bytes = bytes, .n = n };
}

/* Checks that the file is read as the two triangles. */
static void
reads(const char *text)
{
	static const int corners[] = { 0, 1, 2, 2, 1, 3 };
	Soup s;

	if (meshfile_parse_as(&s, text, strlen(text), &(MeshParse){ .most = 1 << 20, .beside = &beside }))
		fail_msg("'%s': %s", text, s.err);
	assert_int_equal(s.nv, 4);
	assert_int_equal(s.nf, 2);
	assert_memory_equal(s.idx, corners, sizeof corners);
	assert_float_equal(s.xyz[11], .5, 0);
	soup_free(&s);
}

static void
refuses(const char *text, size_t most, const MeshBeside *files, const char *why)
{
	Soup s;
	int e = meshfile_parse_as(&s, text, strlen(text), &(MeshParse){ .most = most, .beside = files });

	if (!e)
		soup_free(&s);
	if (e != MESH_EFORMAT || !strstr(s.err, why))
		fail_msg("'%.60s': code %d, '%s', not '%s'", text, e, e ? s.err : "", why);
}

/* ---- glTF ---- */

#define GLTF_HEAD "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[0]}],\"nodes\":[{\"mesh\":0}],\"meshes\":[{\"primitives\":" \
	"[{\"attributes\":{\"POSITION\":0},\"indices\":1}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4," \
	"\"type\":\"VEC3\"},{\"bufferView\":1,\"componentType\":5125,\"count\":6,\"type\":\"SCALAR\"}],"
#define GLTF(size, uri) GLTF_HEAD "\"bufferViews\":[{\"buffer\":0,\"byteLength\":48},{\"buffer\":0,\"byteOffset\":48," \
	"\"byteLength\":24}],\"buffers\":[{\"byteLength\":" size ",\"uri\":\"" uri "\"}]}"

static void
named(const char *text, const char *name)
{
	holds(POINTS CORNERS, BOTH);
	reads(text);
	assert_string_equal(folder.name, name);
	assert_int_equal(folder.count, 1);
	assert_int_equal(folder.from, 0);
	assert_int_equal(folder.want, BOTH);
}

static void
gltf_names(void **state)
{
	(void)state;
	named(GLTF("72", "a.bin"), "a.bin");
	named(GLTF("72", "sub/./a.bin"), "sub/./a.bin");
	named(GLTF("72", "my%20mesh%2e.bin"), "my mesh..bin");
	named(GLTF("72", "100%.bin"), "100%.bin");
	named(GLTF("72", "a\\/b\\\\\\\".bin"), "a/b\\\".bin");
	named(GLTF("72", "\\u00e9\\u20ac\\ud83d\\ude00"), "\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80");
	named(GLTF("72", "..a/b..c/...."), "..a/b..c/....");
	named(GLTF("72", ":30.bin"), ":30.bin");
}

static void
gltf_refused(void **state)
{
	const size_t most = 1 << 20;

	(void)state;
	holds(POINTS CORNERS, BOTH);
	refuses(GLTF("72", "a.bin"), most, NULL, "buffer 0 is in another file, 'a.bin', which cannot be found from a pipe");
	refuses(GLTF("72", "/etc/passwd"), most, &beside, "buffer 0 is in '/etc/passwd', which is read only from the folder");
	refuses(GLTF("72", "../a.bin"), most, &beside, "without .. and without / at its start");
	refuses(GLTF("72", "a/../../b"), most, &beside, "without .. and without / at its start");
	refuses(GLTF("72", "a/%2e%2E"), most, &beside, "without .. and without / at its start");
	refuses(GLTF("72", "%2fa"), most, &beside, "without .. and without / at its start");
	refuses(GLTF("72", "\\u002e\\u002e/a"), most, &beside, "without .. and without / at its start");
	refuses(GLTF("72", "https://a.b/c.bin"), most, &beside, "the uri 'https://a.b/c.bin', which is neither data:");
	refuses(GLTF("72", "file:a.bin"), most, &beside, "neither data: nor the name of a file");
	refuses(GLTF("72", "\\q.bin"), most, &beside, "neither data: nor the name of a file");
	refuses(GLTF("72", "a%00.bin"), most, &beside, "whose name has the byte 0x00");
	refuses(GLTF("72", "a\\nb"), most, &beside, "whose name has the byte 0x0a");
	refuses(GLTF("72", "data:"), most, &beside, "neither data: nor the name of a file");
	refuses(GLTF("72", "data:AAAA"), most, &beside, "buffer 0: its data: uri has no comma");
	assert_int_equal(folder.count, 0);
	refuses(GLTF("72", "none"), most, &beside, "buffer 0 is in 'none' beside the mesh: it is not there");
	refuses(GLTF("73", "a.bin"), most, &beside, "buffer 0 is in 'a.bin' beside the mesh, which has 72 bytes from 0 on, need 73");
	refuses(GLTF("72", "a.bin"), 71, &beside, "of which 72 bytes from 0 on are more than can be read");
	refuses(GLTF("71", "a.bin"), most, &beside, "the bufferView of accessor 1 is beyond the 71 bytes");
	holds(POINTS CORNERS "more", BOTH + 4);
	reads(GLTF("72", "a.bin"));
	reads(GLTF("76", "a.bin"));
}

/* Files beside the mesh count together. */
static void
gltf_two_files(void **state)
{
	static const char text[] = GLTF_HEAD "\"bufferViews\":[{\"buffer\":1,\"byteOffset\":2,\"byteLength\":48},{\"buffer\":0,"
	    "\"byteOffset\":50,\"byteLength\":24}],\"buffers\":[{\"byteLength\":74,\"uri\":\"a\"},{\"byteLength\":50,\"uri\":\"b\"}]}";

	(void)state;
	holds("ab" POINTS CORNERS, BOTH + 2);
	reads(text);
	assert_int_equal(folder.count, 2);
	refuses(text, 123, &beside, "buffer 0 is in 'a', of which 74 bytes from 0 on are more than can be read");
}

/* ---- GIFTI ---- */

#define GIFTI(arrays) "<?xml version=\"1.0\"?>\n<GIFTI Version=\"1.0\" NumberOfDataArrays=\"2\">\n" arrays "</GIFTI>\n"
#define OPEN(intent, type, dim, endian, file, offset) "<DataArray Intent=\"NIFTI_INTENT_" intent "\" DataType=\"NIFTI_TYPE_" type \
	"\" ArrayIndexingOrder=\"RowMajorOrder\" Dimensionality=\"2\" Dim0=\"" dim "\" Dim1=\"3\" Encoding=\"ExternalFileBinary\" " \
	"Endian=\"" endian "\" ExternalFileName=\"" file "\" ExternalFileOffset=\"" offset "\">"
#define ARRAY(intent, type, dim, endian, file, offset) \
	OPEN(intent, type, dim, endian, file, offset) "<Data></Data></DataArray>\n"
#define GII_POINTS(file, offset) ARRAY("POINTSET", "FLOAT32", "4", "LittleEndian", file, offset)
#define GII_FACES(file, offset) ARRAY("TRIANGLE", "INT32", "2", "LittleEndian", file, offset)

static void
gifti_offsets(void **state)
{
	static const char big[] = "\0\0\0\0\0\0\0\0\0\0\0\0" "?\x80\0\0\0\0\0\0\0\0\0\0" "\0\0\0\0?\x80\0\0\0\0\0\0"
	    "?\x80\0\0?\x80\0\0?\0\0\0" "\0\0\0\0\0\0\0\1\0\0\0\2\0\0\0\2\0\0\0\1\0\0\0\3";

	(void)state;
	holds(POINTS CORNERS, BOTH);
	reads(GIFTI(GII_POINTS("a.dat", "0") GII_FACES("a.dat", "48")));
	assert_int_equal(folder.from, 48);
	assert_int_equal(folder.want, NCORNERS);
	reads(GIFTI(GII_POINTS("a.dat", "") GII_FACES("my &amp; a.dat", "48")));
	assert_string_equal(folder.name, "my & a.dat");
	holds("abc" CORNERS POINTS "more", BOTH + 7);
	reads(GIFTI(GII_FACES("a.dat", "3") GII_POINTS("a.dat", "27")));
	holds(big, BOTH);
	reads(GIFTI(ARRAY("POINTSET", "FLOAT32", "4", "BigEndian", "a.dat", "0") ARRAY("TRIANGLE", "INT32", "2", "BigEndian", "a.dat",
	    "48")));
}

static void
gifti_refused(void **state)
{
	const size_t most = 1 << 20;

	(void)state;
	holds(POINTS CORNERS, BOTH);
	refuses(GIFTI(GII_POINTS("a.dat", "0")), most, NULL, "array 0 is in another file, 'a.dat', which cannot be found from a pipe");
	refuses(GIFTI(GII_POINTS("/a.dat", "0")), most, &beside, "array 0 is in '/a.dat', which is read only from the folder");
	refuses(GIFTI(GII_POINTS("", "0")), most, &beside, "array 0 is in another file, whose name has 0 bytes");
	refuses(GIFTI(GII_POINTS("a.dat", "-4")), most, &beside, "ExternalFileOffset=\"-4\" is not a number");
	refuses(GIFTI(GII_POINTS("a.dat", "x")), most, &beside, "ExternalFileOffset=\"x\" is not a number");
	refuses(GIFTI(ARRAY("POINTSET", "FLOAT32", "4294967296", "LittleEndian", "a.dat", "0")), most, &beside,
	    "51539607552 bytes from 0 on are more than can be read");
	refuses(GIFTI(ARRAY("POINTSET", "FLOAT32", "9000000000000000000", "LittleEndian", "a.dat", "0")), most, &beside,
	    "array 0 announces 9000000000000000000 rows");
	assert_int_equal(folder.count, 0);
	refuses(GIFTI(GII_POINTS("none", "0")), most, &beside, "array 0 is in 'none' beside the mesh: it is not there");
	refuses(GIFTI(GII_POINTS("a.dat", "0") GII_FACES("a.dat", "49")), most, &beside,
	    "array 1 is in 'a.dat' beside the mesh, which has 23 bytes from 49 on, need 24");
	refuses(GIFTI(GII_POINTS("a.dat", "9000000000000000000")), most, &beside, "has 0 bytes from 9000000000000000000 on, need 48");
	refuses(GIFTI(GII_POINTS("a.dat", "0") GII_POINTS("a.dat", "0")), most, &beside, "more than one array of points");
	refuses("<GIFTI NumberOfDataArrays=\"1\"><DataArray Intent=\"NIFTI_INTENT_POINTSET\"><DataArray>", most, &beside, "DataType");
	refuses("<GIFTI NumberOfDataArrays=\"1\">" OPEN("POINTSET", "FLOAT32", "4", "LittleEndian", "a.dat", "0")
	    "<DataArray Intent=\"NIFTI_INTENT_SHAPE\"/></DataArray></GIFTI>", most, &beside, "array 0 has another in it");
	refuses(GIFTI("<A>" GII_POINTS("a.dat", "0") "</B>"), most, &beside, "mismatched tag");
}

/* ---- numbers at vertices ---- */

#define SHAPE "<DataArray Intent=\"NIFTI_INTENT_SHAPE\" DataType=\"NIFTI_TYPE_FLOAT32\" Dim0=\"5\" " \
	"Encoding=\"ExternalFileBinary\" Endian=\"LittleEndian\" ExternalFileName=\"x.dat\" ExternalFileOffset=\"36\">"

static void
fields(void **state)
{
	static const char text[] = "<?xml version=\"1.0\"?>\n<GIFTI NumberOfDataArrays=\"1\">" SHAPE "<Data/></DataArray></GIFTI>";
	static const char nested[] = "<GIFTI NumberOfDataArrays=\"1\">" SHAPE SHAPE "</DataArray></DataArray></GIFTI>";
	char err[MESH_ERRLEN];
	FieldFile f;

	(void)state;
	holds(POINTS CORNERS, BOTH);
	assert_int_equal(fieldfile_parse(nested, sizeof nested - 1, "name", &beside, &f, err), MESH_EFORMAT);
	assert_non_null(strstr(err, "array 0 has another in it"));
	assert_int_equal(fieldfile_parse(text, sizeof text - 1, "name", &beside, &f, err), 0);
	assert_int_equal(f.nv, 5);
	assert_float_equal(channel_values(&f.c, "name")[2], .5, 0);
	fieldfile_free(&f);
	holds(POINTS, NPOINTS);
	assert_int_equal(fieldfile_parse(text, sizeof text - 1, "name", &beside, &f, err), MESH_EFORMAT);
	assert_non_null(strstr(err, "array 0 is in 'x.dat' beside the mesh, which has 12 bytes from 36 on, need 20"));
	assert_int_equal(fieldfile_parse(text, sizeof text - 1, "name", NULL, &f, err), MESH_EFORMAT);
	assert_non_null(strstr(err, "cannot be found from a pipe"));
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(gltf_names),
		cmocka_unit_test(gltf_refused),
		cmocka_unit_test(gltf_two_files),
		cmocka_unit_test(gifti_offsets),
		cmocka_unit_test(gifti_refused),
		cmocka_unit_test(fields)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
