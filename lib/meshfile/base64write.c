/* base64write.c - bytes as base64 text in a file that grows in memory. */
#include "../base/base64.h"
#include "writepriv.h"

enum { CHUNK = 270 };   /* bytes, a multiple of 3: 360 characters, for which text_room makes room */

int
text_base64(Text *t, const void *bytes, size_t n)
{
	const char *p = bytes;
	size_t k;

	for (; n > 0; n -= k, p += k) {
		if (!text_room(t))
			return MESH_ENOMEM;
		k = n < CHUNK ? n : CHUNK;
		base64_encode(p, k, t->p + t->n);
		t->n += base64_length(k);
	}
	return 0;
}
