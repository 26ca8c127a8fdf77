/* lhgbytes.h - makes .lhg streams as bytes, including invalid ones that the writer would refuse. */
#ifndef LHGBYTES_H
#define LHGBYTES_H

#include <stdio.h>
#include <zlib.h>

#include "cmock.h"

#define TOOL __attribute__((unused)) static       /* not every test uses all of these */

typedef struct Bytes {
	char  *p;
	size_t n;
} Bytes;

TOOL const Bytes NONE = { NULL, 0 };

TOOL Bytes
join(Bytes a, Bytes b)
{
	Bytes c = { malloc(a.n + b.n + 1), a.n + b.n };

	assert_non_null(c.p);
	if (a.n)
		memcpy(c.p, a.p, a.n);
	if (b.n)
		memcpy(c.p + a.n, b.p, b.n);
	return c;
}

/* The bytes of a and then b; frees both. */
TOOL Bytes
glue(Bytes a, Bytes b)
{
	Bytes c = join(a, b);

	free(a.p);
	free(b.p);
	return c;
}

TOOL Bytes
part(Bytes a, size_t from, size_t to)
{
	Bytes s = { a.p + from, to - from };

	return join(s, NONE);
}

TOOL Bytes
text(const char *s)
{
	Bytes a = { (char *)s, strlen(s) };

	return join(a, NONE);
}

TOOL size_t
headlen(Bytes b)
{
	size_t n = 0;

	while (n + 3 < b.n && memcmp(b.p + n, "end", 3) != 0)
		n += (size_t)((char *)memchr(b.p + n, '\n', b.n - n) - (b.p + n)) + 1;
	return n + (size_t)((char *)memchr(b.p + n, '\n', b.n - n) - (b.p + n)) + 1;
}

/* A header that consists of the n bytes of lines and a valid last line.  It is padded to a multiple
 * of 64 bytes and then by `more` further spaces, which are an error. */
TOOL Bytes
headof(const char *lines, size_t n, size_t more)
{
	size_t len = (n + 13 + 63)/64*64 + more;
	Bytes b = { malloc(len + 1), len };

	assert_non_null(b.p);
	memcpy(b.p, lines, n);
	memset(b.p + n, ' ', len - n);
	memcpy(b.p + n, "end", 3);
	sprintf(b.p + len - 9, "%08lx\n", crc32(0, (Bytef *)b.p, (uInt)(len - 9)));
	return b;
}

/* A complete grid with the header `head` and one channel of n samples; frees head. */
TOOL Bytes
gridof(Bytes head, const double *f, size_t n)
{
	static const char end[65] = "\nlhg end\x89\r\n\x1a\n\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0"
	    "\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0\n";
	Bytes b = { calloc(8*n + 128, 1), 8*n + 64 - 8*n % 64 + 64 };
	uint32_t crc = (uint32_t)strtoul(head.p + head.n - 9, NULL, 16);
	uint64_t w;
	size_t k;

	assert_non_null(b.p);
	for (k = 0; k < 8*n; k++) {
		memcpy(&w, &f[k/8], 8);
		b.p[k] = (char)(w >> k%8*8 & 0xff);
	}
	crc = (uint32_t)crc32(crc, (Bytef *)b.p, (uInt)(8*n));
	for (k = 0; k < 4; k++)
		b.p[8*n + k] = (char)(crc >> 8*k & 0xff);
	memcpy(b.p + b.n - 64, end, 64);
	return glue(head, b);
}

#endif
