/* vtp.c - fuzz target: VTP.  The kept inputs are whole files; others get its root element in place of their first
 * bytes.  Packed data in the file may unpack to 1100 bytes for each of theirs and 4 KiB, three arrays of them. */
#include <string.h>

#include "fuzz.h"

static const char ROOT[] = "<VTKFile ";

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	const size_t unpacked = 3*(1100*n + 4096);

	if (n > 5 && memcmp(data, "<?xml", 5) == 0)
		fuzz_mesh(data, n, fuzz_meshbound(n + unpacked));
	else
		fuzz_mesh_from(ROOT, sizeof ROOT - 1, data, n);
	return 0;
}
