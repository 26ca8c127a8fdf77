/* gifti.c - fuzz target: GIFTI. */
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	fuzz_xml("<GIFTI ", data, n);
	return 0;
}
