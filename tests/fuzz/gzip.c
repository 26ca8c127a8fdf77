/* gzip.c - fuzz target: gzipped meshes.  zlib calls the crc32 below, which is always 0, as is the CRC
 * of the kept inputs.  So zlib does not refuse changed data, and they reach the mesh readers. */
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

/* The memory that reading n packed bytes may use.  The buffer of unpacked bytes begins at 4n + 4096
 * and is doubled when it is full; then the old and the new one together have at most three times the
 * bytes unpacked so far. */
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
	else    /* how much was unpacked before the damage is unknown: take gunzip's limit */
		unpacked = 1100*n + 4096;
	fuzz_mesh_uv(p, n, bound(n, unpacked));
	free(p);
	return 0;
}
