/* fsascii.c - fuzz target: FreeSurfer ASCII.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("#!ascii version of", 18, data, n);
	return 0;
}
