/* obj.c - fuzz target: OBJ, with (u,v) and without.  If the first byte cannot begin an OBJ, the first
 * two bytes are replaced by "v ". */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	uint8_t *p;

	if (n < 2 || memchr("#vfoglmu", data[0], 8)) {
		fuzz_mesh_uv(data, n, fuzz_meshbound(n));
		return 0;
	}
	p = malloc(n);
	memcpy(p, data, n);
	memcpy(p, "v ", 2);
	fuzz_mesh_uv(p, n, fuzz_meshbound(n));
	free(p);
	return 0;
}
