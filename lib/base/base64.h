/* base64.h - bytes as base64 text (RFC 4648). */
#ifndef BASE64_H
#define BASE64_H

#include <stddef.h>

/* The characters for n bytes, = at the end included. */
static inline size_t
base64_length(size_t n)
{
	return (n + 2)/3*4;
}

/* Writes base64_length(n) characters to out, without a final NUL. */
void base64_encode(const void *bytes, size_t n, char *out);

#endif
