/* base64read.c - bytes from base64 text. */
#include <stdint.h>
#include <string.h>

#include "meshpriv.h"

static int
sixbits(char c)
{
	if (c >= 'A' && c <= 'Z')
		return c - 'A';
	if (c >= 'a' && c <= 'z')
		return c - 'a' + 26;
	if (c >= '0' && c <= '9')
		return c - '0' + 52;
	return c == '+' ? 62 : c == '/' ? 63 : -1;
}

/* The next four characters, blanks before each skipped, as 24 bits.  Characters that stand for none of the n
 * bytes that are needed may be '='. */
static int
group(Reader *r, const char *what, const char **p, const char *end, size_t n, uint32_t *w)
{
	int k, six;

	for (*w = 0, k = 0; k < 4; k++) {
		while (*p < end && strchr(" \t\r\n", **p) && **p)
			++*p;
		if (*p == end)
			return mesh_fail(r->s->err, MESH_EFORMAT, "%s: data end early", what);
		six = **p == '=' && (size_t)k > n ? 0 : sixbits(**p);
		if (six < 0)
			return mesh_fail(r->s->err, MESH_EFORMAT, "%s: data end early, or byte 0x%02x is no base64", what,
			    (unsigned char)**p);
		*w = *w << 6 | (uint32_t)six;
		++*p;
	}
	return 0;
}

int
base64_read(Reader *r, const char *what, const char **p, const char *end, size_t n, char *out)
{
	uint32_t w;
	size_t k;
	int e;

	for (; n > 0; n -= k, out += k) {
		k = n < 3 ? n : 3;
		if ((e = group(r, what, p, end, k, &w)) != 0)
			return e;
		out[0] = (char)(w >> 16);
		if (k > 1)
			out[1] = (char)(w >> 8);
		if (k > 2)
			out[2] = (char)w;
	}
	return 0;
}
