/* lhg_nocrc.c - fuzz target: the .lhg reader with its checksums off: every CRC is 0, also
 * those that inputs for this target hold. */
#include <zlib.h>

#include "lhg.c"

uLong
crc32(uLong crc, const Bytef *p, uInt n)
{
	(void)crc, (void)p, (void)n;
	return 0;
}
