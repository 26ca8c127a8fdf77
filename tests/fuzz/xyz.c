/* xyz.c - fuzz target: XYZ.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("1 2 3", 5, data, n);
	return 0;
}
