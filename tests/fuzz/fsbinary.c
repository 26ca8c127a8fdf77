/* fsbinary.c - fuzz target: FreeSurfer binary.  The first bytes of the input are replaced by its own. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_mesh_from("\xff\xff\xfe", 3, data, n);
	return 0;
}
