/* ply.c - fuzz target: PLY, ASCII and binary, with (u,v) and without.  The first three
 * bytes are set to "ply". */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	uint8_t *p = malloc(n + !n);

	if (n)
		memcpy(p, data, n);
	memcpy(p, "ply", n < 3 ? n : 3);
	fuzz_mesh_uv(p, n, fuzz_meshbound(n));
	free(p);
	return 0;
}
