/* json.c - text as JSON strings. */
#include "json.h"

/* The length of the UTF-8 character at s; 0 if it is cut off, overlong, a surrogate, or beyond
 * U+10FFFF (Unicode 15, table 3-7). */
static int
utf8(const unsigned char *s)
{
	int n = s[0] < 0x80 ? 1 : s[0] < 0xc2 ? 0 : s[0] < 0xe0 ? 2 : s[0] < 0xf0 ? 3 : s[0] < 0xf5 ? 4 : 0;
	int i;

	for (i = 1; i < n; i++)
		if ((s[i] & 0xc0) != 0x80)
			return 0;
	if ((s[0] == 0xe0 && s[1] < 0xa0) || (s[0] == 0xed && s[1] > 0x9f))
		return 0;
	if ((s[0] == 0xf0 && s[1] < 0x90) || (s[0] == 0xf4 && s[1] > 0x8f))
		return 0;
	return n;
}

void
json_string(FILE *f, const char *s)
{
	const unsigned char *c = (const unsigned char *)s;
	int n;

	putc('"', f);
	for (; *c; c += n ? n : 1) {
		n = utf8(c);
		if (*c == '"' || *c == '\\')
			fprintf(f, "\\%c", *c);
		else if (*c < ' ' || *c == 0x7f)
			fprintf(f, "\\u%04x", *c);
		else if (n)
			fwrite(c, 1, (size_t)n, f);
		else
			fputs("\\ufffd", f);
	}
	putc('"', f);
}
