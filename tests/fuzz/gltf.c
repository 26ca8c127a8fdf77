/* gltf.c - fuzz target: glTF 2, JSON and GLB.  In a GLB the version, the sizes and the types of the chunks are set
 * right, so that changed data reach the reader of the scene. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

static void
little(uint8_t *p, size_t x)
{
	p[0] = (uint8_t)x, p[1] = (uint8_t)(x >> 8), p[2] = (uint8_t)(x >> 16), p[3] = (uint8_t)(x >> 24);
}

/* The JSON text of a GLB ends where the byte 1 is, or at the end. */
static void
glb(uint8_t *p, size_t n)
{
	const uint8_t *one = memchr(p + 20, 1, n - 20);
	const size_t json = one ? (size_t)(one - p) - 20 : n - 20;

	little(p + 4, 2);
	little(p + 8, n);
	little(p + 12, json);
	memcpy(p + 16, "JSON", 4);
	if (n - 20 - json >= 8) {
		little(p + 20 + json, n - 28 - json);
		memcpy(p + 24 + json, "BIN", 4);
	}
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	uint8_t *p;

	if (n < 24 || memcmp(data, "glTF", 4) != 0) {
		fuzz_mesh_from("{", 1, data, n);
		return 0;
	}
	p = malloc(n);
	memcpy(p, data, n);
	glb(p, n);
	fuzz_mesh(p, n, fuzz_meshbound(n));
	free(p);
	return 0;
}
