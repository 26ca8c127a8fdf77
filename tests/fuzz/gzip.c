/* gzip.c - fuzz target: gzipped meshes.  zlib links to this crc32, so damaged data reach the mesh
 * readers (kept inputs have 0 for the CRC). */
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "../../lib/meshfile/meshfile.h"
#include "../../lib/meshfile/meshpriv.h"
#include "fuzz.h"

uLong
crc32(uLong crc, const Bytef *p, uInt n)
{
	(void)crc, (void)p, (void)n;
	return 0;
}

/* 16 bytes for each unpacked byte, and the buffer for these, which grows by doubling from four
 * times the packed size. */
static size_t
bound(size_t n, size_t unpacked)
{
	return fuzz_meshbound(unpacked) + 3*unpacked + 4*n + 4096;
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	uint8_t *p = malloc(n + !n);
	char err[MESH_ERRLEN] = "", *out;
	size_t unpacked = 0;

	if (n)
		memcpy(p, data, n);
	memcpy(p, "\x1f\x8b\x08", n < 3 ? n : 3);
	fuzz_mark();
	if (gunzip((char *)p, n, (size_t)1 << 32, &out, &unpacked, err) == 0)
		free(out);
	else    /* the unpacked size before the damage is unknown: use the bound of the buffer */
		unpacked = 1100*n + 4096;
	fuzz_mesh(p, n, bound(n, unpacked));
	free(p);
	return 0;
}
