/* hoppe.c - fuzz target: Hoppe M.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("Vertex ", 7, data, n);
	return 0;
}
