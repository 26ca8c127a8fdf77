/* text.c - a file that grows in memory. */
#include <stdint.h>
#include <stdlib.h>

#include "writepriv.h"

int
text_room(Text *t)
{
	char *p;

	if (t->cap - t->n > TEXT_MAX)
		return 1;
	if (t->cap > SIZE_MAX / 4 || !(p = realloc(t->p, 2*t->cap + 4096)))
		return 0;
	t->p = p;
	t->cap = 2*t->cap + 4096;
	return 1;
}

void
text_bytes(Text *t, uint64_t w, int n)
{
	for (; n > 0; n--, w >>= 8)
		t->p[t->n++] = (char)(w & 0xff);
}
