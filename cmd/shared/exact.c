/* exact.c - a checksum of lambda, H and the residual channels.
 *
 * A stage that changes lambda or H (lhfft, lhinterp, a user's program) need not update the metadatum: the
 * checksum of the new samples differs from it. */
#include <stdint.h>
#include <string.h>

#include <zlib.h>

#include "cmd.h"
#include "exact.h"

enum { DIGITS = 8 };
static const char KEY[] = "residual";

/* The CRC of the samples as the file has them, little-endian. */
static uint32_t
add_crc(uint32_t crc, size_t n, const double *f)
{
	unsigned char bytes[8];
	uint64_t x;
	size_t p;
	int k;

	for (p = 0; p < n; p++) {
		memcpy(&x, &f[p], sizeof x);
		for (k = 0; k < 8; k++)
			bytes[k] = (unsigned char)(x >> 8*k);
		crc = (uint32_t)crc32(crc, bytes, sizeof bytes);
	}
	return crc;
}

/* Sets *crc; returns 0 if a channel is missing. */
static int
checksum(const Lhg *g, uint32_t *crc)
{
	static const char *const of[] = { "lambda", "H", "nu1", "nu2", "tau1", "tau2" };
	const LhgChannel *c;
	size_t i;

	for (*crc = 0, i = 0; i < sizeof of/sizeof *of; i++) {
		c = lhg_find(g, of[i]);
		if (!c)
			return 0;
		*crc = add_crc(*crc, c->n, c->f);
	}
	return 1;
}

void
exact_promise(Lhg *g)
{
	uint32_t crc;

	if (checksum(g, &crc))
		cmd_meta(g, KEY, "%08lx", (unsigned long)crc);
}

int
exact_holds(const Lhg *g)
{
	char value[LHG_KEYLEN], own[DIGITS + 1];
	uint32_t crc;

	if (!lhg_getmeta(g, KEY, value, sizeof value) || !checksum(g, &crc))
		return 0;
	snprintf(own, sizeof own, "%08lx", (unsigned long)crc);
	return strcmp(value, own) == 0;
}
