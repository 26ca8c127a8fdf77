/* base64.c - three bytes as four characters. */
#include <stdint.h>

#include "base64.h"

void
base64_encode(const void *bytes, size_t n, char *out)
{
	static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	const unsigned char *p = bytes;
	uint32_t w;
	size_t i, have;
	unsigned k;

	for (i = 0; i < n; i += 3) {
		have = n - i < 3 ? n - i : 3;
		w = (uint32_t)p[i] << 16 | (have > 1 ? (uint32_t)p[i+1] << 8 : 0) | (have > 2 ? p[i+2] : 0);
		for (k = 0; k < 4; k++)
			*out++ = k <= have ? digit[w >> (18 - 6*k) & 63] : '=';
	}
}
