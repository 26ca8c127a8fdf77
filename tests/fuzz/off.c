/* off.c - fuzz target: OFF, ASCII and binary.  If the input does not have OFF near its beginning, or
 * if it begins as gzip data, its first four bytes are replaced by "OFF\n". */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

static int
saysoff(const uint8_t *p, size_t n)
{
	size_t i;

	for (i = 0; i + 3 <= n && i < 24 && p[0] != 0x1f; i++)
		if (memcmp(p + i, "OFF", 3) == 0)
			return 1;
	return 0;
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	uint8_t *p;

	if (n < 4)
		return 0;
	if (saysoff(data, n)) {
		fuzz_mesh(data, n, fuzz_meshbound(n));
		return 0;
	}
	p = malloc(n);
	memcpy(p, data, n);
	memcpy(p, "OFF\n", 4);
	fuzz_mesh(p, n, fuzz_meshbound(n));
	free(p);
	return 0;
}
