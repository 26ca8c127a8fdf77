/* jsonstring.c - strings of JSON without their escapes. */
#include <string.h>

#include "json.h"

long
json_hex(const char *p, int n)
{
	long x = 0;

	for (; n > 0; n--, p++)
		if (*p >= '0' && *p <= '9')
			x = 16*x + *p - '0';
		else if ((*p | 32) >= 'a' && (*p | 32) <= 'f')
			x = 16*x + (*p | 32) - 'a' + 10;
		else
			return -1;
	return x;
}

/* Writes the character in UTF-8 and returns its length, at most 4. */
static size_t
utf8(long w, char *to)
{
	static const int first[] = { 0, 0xc0, 0xe0, 0xf0 };
	const int more = w < 0x80 ? 0 : w < 0x800 ? 1 : w < 0x10000 ? 2 : 3;
	int k;

	for (k = more; k > 0; k--, w >>= 6)
		to[k] = (char)(0x80 | (w & 63));
	to[0] = (char)(first[more] | w);
	return (size_t)more + 1;
}

/* The four digits of \u00e9 at p; -1 if there is no such escape. */
static long
sixteen(const char *p, const char *end)
{
	return end - p >= 6 && p[0] == '\\' && p[1] == 'u' ? json_hex(p + 2, 4) : -1;
}

/* Writes the character of the escape at *p, goes past it, and returns the length; 0 if there is no such escape. */
static size_t
escaped(const char **p, const char *end, char *to)
{
	static const char letter[] = "\"\\/bfnrt", means[] = "\"\\/\b\f\n\r\t";
	const long w = sixteen(*p, end), low = w >> 10 == 0xd800 >> 10 ? sixteen(*p + 6, end) : -1;
	const char *e = end - *p >= 2 && (*p)[1] ? strchr(letter, (*p)[1]) : NULL;

	if (low >> 10 == 0xdc00 >> 10) {                /* two halves of a character beyond 16 bits */
		*p += 12;
		return utf8(0x10000 + ((w & 0x3ff) << 10 | (low & 0x3ff)), to);
	}
	if (w >= 0) {
		*p += 6;
		return utf8(w, to);
	}
	if (!e)
		return 0;
	*p += 2;
	*to = means[e - letter];
	return 1;
}

long
json_unescaped(const Json *j, long long v, char *to, size_t size)
{
	const Token t = json_text(j, v);
	const char *p = t.s, *end = t.s + t.n;
	size_t n = 0, k;

	while (p < end) {
		if (size - n < 4)
			return -1;
		if (*p != '\\')
			to[n++] = *p++;
		else if ((k = escaped(&p, end, to + n)) == 0)
			return -1;
		else
			n += k;
	}
	return (long)n;
}
