/* mni.c - fuzz target: MNI OBJ.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("P 1 1 1 1 1 ", 12, data, n);
	return 0;
}
