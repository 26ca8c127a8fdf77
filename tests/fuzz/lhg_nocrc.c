/* lhg_nocrc.c - fuzz target: the .lhg reader without checksums: every CRC is 0, also in the inputs of
 * this target. */
#include <zlib.h>

#include "lhg.c"

uLong
crc32(uLong crc, const Bytef *p, uInt n)
{
	(void)crc, (void)p, (void)n;
	return 0;
}
