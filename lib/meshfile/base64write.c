/* base64write.c - bytes as base64 text. */
#include "writepriv.h"

int
text_base64(Text *t, const void *bytes, size_t n)
{
	static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	const unsigned char *p = bytes;
	uint32_t w;
	size_t i;
	int k, have;

	for (i = 0; i < n; i += 3) {
		if (!text_room(t))
			return MESH_ENOMEM;
		have = n - i < 3 ? (int)(n - i) : 3;
		w = (uint32_t)p[i] << 16 | (have > 1 ? (uint32_t)p[i+1] << 8 : 0) | (have > 2 ? p[i+2] : 0);
		for (k = 0; k < 4; k++)
			t->p[t->n++] = k <= have ? digit[w >> (18 - 6*k) & 63] : '=';
	}
	return 0;
}
