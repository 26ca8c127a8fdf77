/* stl.c - fuzz target: STL.  Input is read as it is, unless it begins as gzip data, which have their
 * own target.  Input that does not begin as text is then made a binary STL and read once more: it is
 * cut after a triangle, gets the right count, and its first byte is changed so that the data are not
 * taken for another format. */
#include <stdlib.h>
#include <string.h>

#include "fuzz.h"

enum { HEAD = 84, EACH = 50 };

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	size_t k = n < HEAD ? 0 : (n - HEAD)/EACH, i;
	uint8_t *p;

	if (n == 0 || data[0] != 0x1f)
		fuzz_mesh(data, n, fuzz_meshbound(n));
	if (n < HEAD || memchr("s \n", data[0], 3))
		return 0;
	n = HEAD + EACH*k;
	p = malloc(n);
	memcpy(p, data, n);
	p[0] &= 0xe0;
	for (i = 0; i < 4; i++)
		p[80 + i] = k >> 8*i & 0xff;
	fuzz_mesh(p, n, fuzz_meshbound(n));
	free(p);
	return 0;
}
