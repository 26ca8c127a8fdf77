/* vtk.c - fuzz target: legacy VTK.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("# vtk DataFile Version", 22, data, n);
	return 0;
}
