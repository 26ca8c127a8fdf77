/* vtp.c - fuzz target: VTP. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_xml("<VTKFile ", data, n);
	return 0;
}
