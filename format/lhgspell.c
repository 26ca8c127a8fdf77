/* lhgspell.c - names, text and numbers as a header spells them.  Section numbers: LHG.md. */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "lhgpriv.h"

int
lhg_goodname(const char *p, size_t n, size_t size, const char *extra)
{
	size_t i;

	for (i = 0; i < n; i++)
		if (!((p[i] >= 'A' && p[i] <= 'Z') || (p[i] >= 'a' && p[i] <= 'z') ||
		    (p[i] >= '0' && p[i] <= '9') || (p[i] && strchr("._+-", p[i])) ||
		    (p[i] && strchr(extra, p[i]))))
			return 0;
	return n > 0 && n < size;
}

size_t
lhg_utf8(const char *p, size_t n)
{
	static const uint32_t least[] = { 0, 0, 0xa0, 0x800, 0x10000 };
	const unsigned char *s = (const unsigned char *)p;
	size_t len = s[0] >= 0xf0 ? 4 : s[0] >= 0xe0 ? 3 : 2, i;
	uint32_t c;

	if (s[0] < 0x80)
		return s[0] >= 0x20 && s[0] < 0x7f;
	if (s[0] < 0xc2 || s[0] > 0xf4 || n < len)
		return 0;
	for (c = s[0] & (0x7fu >> len), i = 1; i < len; i++) {
		if ((s[i] & 0xc0) != 0x80)
			return 0;
		c = c << 6 | (s[i] & 0x3f);
	}
	return c < least[len] || c > 0x10ffff || (c >= 0xd800 && c < 0xe000) ? 0 : len;
}

int
lhg_goodtext(const char *p, size_t n)
{
	size_t i, len;

	if (n == 0 || p[0] == ' ' || p[n-1] == ' ')
		return 0;
	for (i = 0; i < n; i += len)
		if (!(len = lhg_utf8(p + i, n - i)))
			return 0;
	return 1;
}

/* In some locales the decimal point is not '.', and it may have several bytes. */
void
lhg_putheight(char text[LHG_HEIGHTLEN], double T)
{
	char s[LHG_HEIGHTLEN];
	const char *p;
	int digits = 15;

	do
		snprintf(s, sizeof s, "%.*g", digits, T);
	while (strtod(s, NULL) != T && ++digits <= 17);
	for (p = s; *p; p++)
		if (strchr("0123456789e+-", *p))
			*text++ = *p;
		else if (p == s || text[-1] != '.')
			*text++ = '.';
	*text = '\0';
}

double
lhg_getheight(const char *p, size_t n)
{
	char point[16], s[LHG_HEIGHTLEN + 16], *t = s;
	size_t i;

	snprintf(point, sizeof point, "%.1f", 0.0);             /* 0, the point, 0 */
	point[strlen(point) - 1] = '\0';
	if (n == 0 || n >= LHG_HEIGHTLEN || p[0] < '0' || p[0] > '9')
		return 0;
	for (i = 0; i < n; i++)
		if (p[i] && strchr("0123456789e+-", p[i]))
			*t++ = p[i];
		else if (p[i] == '.' && !memchr(p, '.', i))
			t += strlen(strcpy(t, point + 1));
		else
			return 0;
	*t = '\0';
	return strtod(s, &t);
}
