/* test_gltf.c - the reader of glTF 2: primitives, indices, transforms of nodes, what is refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/meshfile/meshfile.h"
#include "meshreads.h"

/* Four float vertices (0,0,0) (1,0,0) (0,1,0) (1,1,.5), six indices of 16 bits 0 1 2 2 1 3; by Python's base64. */
#define DATA "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAA/AAABAAIAAgABAAMA"
#define ROOT "\"asset\":{\"version\":\"2.0\"},\"scene\":0,\"scenes\":[{\"nodes\":[0]}],"
#define ACCESSORS "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":4,\"type\":\"VEC3\"}," \
	"{\"bufferView\":1,\"componentType\":5123,\"count\":6,\"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":48}," \
	"{\"buffer\":0,\"byteOffset\":48,\"byteLength\":12}],"
#define BUFFER "\"buffers\":[{\"byteLength\":60,\"uri\":\"data:application/octet-stream;base64," DATA "\"}]"
#define FILE_OF(nodes, primitives) "{" ROOT "\"nodes\":[" nodes "],\"meshes\":[{\"primitives\":[" primitives "]}]," ACCESSORS BUFFER "}\n"
#define PRIMITIVE "{\"attributes\":{\"POSITION\":0},\"indices\":1}"
#define ONE "{\"mesh\":0}"

static void
primitives(void **state)
{
	(void)state;
	reads(FILE_OF(ONE, PRIMITIVE), 4, "0 1 2/2 1 3");
	reads(FILE_OF(ONE, PRIMITIVE "," PRIMITIVE), 8, "0 1 2/2 1 3/4 5 6/6 5 7");
	reads(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"mode\":4}"), 4, "0 1 2");
	reads(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"mode\":5}"), 4, "0 1 2/1 3 2");
	reads(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"mode\":6}"), 4, "0 1 2/0 2 3");
	reads(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"mode\":5}"), 4, "0 1 2/2 3 1");
	reads(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"mode\":1}," PRIMITIVE), 4, "0 1 2/2 1 3");
	reads(FILE_OF("{\"children\":[1,2]}," ONE "," ONE, PRIMITIVE), 8, "0 1 2/2 1 3/4 5 6/6 5 7");
	reads(FILE_OF("{\"name\":\"a\\\"{\"}", PRIMITIVE), 0, "");
}

/* Where vertex 3, (1, 1, .5), comes to. */
static void
placed(const char *text, double x, double y, double z, const char *faces)
{
	Soup s;

	reads(text, 4, faces);
	assert_int_equal(parse(&s, text, strlen(text)), 0);
	assert_float_equal(s.xyz[9], x, 1e-14);
	assert_float_equal(s.xyz[10], y, 1e-14);
	assert_float_equal(s.xyz[11], z, 1e-14);
	assert_string_equal(s.facts, "source glTF\nunit m\n");
	soup_free(&s);
}

static void
transforms(void **state)
{
	(void)state;
	placed(FILE_OF(ONE, PRIMITIVE), 1, 1, .5, "0 1 2/2 1 3");
	placed(FILE_OF("{\"mesh\":0,\"translation\":[10,20,30]}", PRIMITIVE), 11, 21, 30.5, "0 1 2/2 1 3");
	placed(FILE_OF("{\"mesh\":0,\"scale\":[2,3,4]}", PRIMITIVE), 2, 3, 2, "0 1 2/2 1 3");
	/* A quarter turn about z: (x,y) -> (-y,x). */
	placed(FILE_OF("{\"mesh\":0,\"rotation\":[0,0,0.70710678118654752,0.70710678118654752],\"scale\":[2,3,4],\"translation\":[10,0,0]}",
	    PRIMITIVE), 7, 2, 2, "0 1 2/2 1 3");
	/* By columns; the determinant is -3. */
	placed(FILE_OF("{\"mesh\":0,\"matrix\":[1,2,3,0,4,5,6,0,7,8,10,0,100,200,300,1]}", PRIMITIVE), 108.5, 211, 314, "0 2 1/2 3 1");
	/* The child first, then its parent. */
	placed(FILE_OF("{\"children\":[1],\"scale\":[2,2,2]},{\"mesh\":0,\"translation\":[1,0,0]}", PRIMITIVE), 4, 2, 1, "0 1 2/2 1 3");
	/* A reflection turns the triangles, so that they have their outer side outside; two do not. */
	placed(FILE_OF("{\"mesh\":0,\"scale\":[-1,1,1]}", PRIMITIVE), -1, 1, .5, "0 2 1/2 3 1");
	placed(FILE_OF("{\"children\":[1],\"scale\":[1,-1,1]},{\"mesh\":0,\"scale\":[-1,1,1]}", PRIMITIVE), -1, -1, .5, "0 1 2/2 1 3");
	/* A mesh with a skin is not placed by its node. */
	placed(FILE_OF("{\"mesh\":0,\"skin\":0,\"translation\":[10,20,30]}", PRIMITIVE), 1, 1, .5, "0 1 2/2 1 3");
}

static void
refused(void **state)
{
	(void)state;
	refuses(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"indices\":1,\"extensions\":{\"KHR_draco_mesh_compression\":{}}}"),
	    MESH_EFORMAT, "DRACO compressed meshes are not read");
	refuses("{\"extensionsRequired\":[\"EXT_meshopt_compression\"]," ROOT "\"nodes\":[]}", MESH_EFORMAT,
	    "meshopt compressed meshes are not read");
	refuses(FILE_OF("{\"children\":[1]},{\"children\":[0]}", PRIMITIVE), MESH_EFORMAT, "node 0 is reached twice");
	refuses(FILE_OF("{\"mesh\":1}", PRIMITIVE), MESH_EFORMAT, "refers to number 1 of meshes, there are 1");
	refuses(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":2}}"), MESH_EFORMAT, "refers to number 2 of accessors, there are 2");
	refuses(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":1}}"), MESH_EFORMAT, "accessor 1 is not of type VEC3");
	refuses(FILE_OF(ONE, "{\"attributes\":{\"POSITION\":0},\"mode\":7}"), MESH_EFORMAT, "mode 7 is not read");
	refuses("{" ROOT "\"nodes\":[" ONE "],\"meshes\":[{\"primitives\":[" PRIMITIVE "]}]," ACCESSORS
	    "\"buffers\":[{\"byteLength\":60,\"uri\":\"x.bin\"}]}", MESH_EFORMAT, "buffer 0 is in another file, 'x.bin', which cannot be found");
	refuses("{" ROOT "\"nodes\":[" ONE "],\"meshes\":[{\"primitives\":[" PRIMITIVE "]}]," ACCESSORS
	    "\"buffers\":[{\"byteLength\":2000000000,\"uri\":\"data:;base64,AAAA\"}]}", MESH_EFORMAT, "buffer 0 announces 2000000000 bytes");
	refuses("{" ROOT "\"nodes\":[" ONE "],\"meshes\":[{\"primitives\":[" PRIMITIVE "]}],\"accessors\":[{\"bufferView\":0,"
	    "\"componentType\":5126,\"count\":5,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":48}]," BUFFER "}",
	    MESH_EFORMAT, "accessor 0 announces 5 items");
	refuses("{\"asset\":{\"version\":\"1.0\"}}", MESH_EFORMAT, "glTF of version 1.0 is not read, only 2");
	refuses("{\"a\":1}", MESH_EFORMAT, "no glTF");
	refuses("{\"a\":1", MESH_EFORMAT, "byte 6 of the JSON text: it ends here");
	refuses("{\"a\" 1}", MESH_EFORMAT, "byte 5 of the JSON text: no ':'");
	refuses("{\"a\":[1 2]}", MESH_EFORMAT, "byte 8 of the JSON text: no ',' or closing bracket");
	refuses_bytes("glTF\1\0\0\0\x14\0\0\0\0\0\0\0JSON", 20, MESH_EFORMAT, "glTF of version 1 is not read");
	refuses_bytes("glTF\2\0\0\0\x20\0\0\0\0\0\0\0JSON", 20, MESH_EFORMAT, "header announces 32 bytes, file has 20");
}

/* A mesh that many nodes use would fill the memory. */
static void
many_instances(void **state)
{
	static const char head[] = "{\"asset\":{\"version\":\"2.0\"},\"scenes\":[{\"nodes\":[";
	static char file[60000];
	size_t n = (size_t)sprintf(file, "%s0", head);
	int i;

	(void)state;
	for (i = 1; i < 2000; i++)
		n += (size_t)sprintf(file + n, ",%d", i);
	n += (size_t)sprintf(file + n, "]}],\"nodes\":[{\"mesh\":0}");
	for (i = 1; i < 2000; i++)
		n += (size_t)sprintf(file + n, ",{\"mesh\":0}");
	sprintf(file + n, "],\"meshes\":[{\"primitives\":[%s,%s]}],%s%s}", PRIMITIVE, PRIMITIVE, ACCESSORS, BUFFER);
	refuses(file, MESH_EFORMAT, "meshes used many times");
}

/* A GLB, and each of its beginnings. */
static void
binary(void **state)
{
	static const char json[] = "{" ROOT "\"nodes\":[" ONE "],\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0}}]}],"
	    "\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":3,\"type\":\"VEC3\"}],\"bufferViews\":[{\"buffer\":0,"
	    "\"byteLength\":36}],\"buffers\":[{\"byteLength\":36}]}   ";
	const uint32_t nj = (sizeof json - 1)/4*4, all = 28 + nj + 36;
	const float xyz[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
	char file[1000];
	uint32_t head[5] = { 0x46546c67, 2, all, nj, 0x4e4f534a }, bin[2] = { 36, 0x004e4942 };
	Soup s;
	size_t n;

	(void)state;
	memcpy(file, head, 20);
	memcpy(file + 20, json, nj);
	memcpy(file + 20 + nj, bin, 8);
	memcpy(file + 28 + nj, xyz, 36);
	reads_bytes(file, all, 3, "0 1 2");
	for (n = 0; n < all; n++)
		if (parse(&s, file, n) == 0)
			fail_msg("%zu of %u bytes are read", n, (unsigned)all);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(primitives), cmocka_unit_test(transforms), cmocka_unit_test(refused),
		cmocka_unit_test(many_instances), cmocka_unit_test(binary)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
