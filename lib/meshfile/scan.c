/* scan.c - words and numbers of text held in memory. */
#include <ctype.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/cpu.h"
#include "meshpriv.h"

enum { MAXNUMBER = 127 };       /* characters of one number */

size_t
scan_left(const Reader *r)
{
	return (size_t)(r->end - r->p);
}

static int
isspacing(int c)
{
	return c == ' ' || c == '\t' || c == '\v' || c == '\f';
}

static int
iseol(int c)
{
	return c == '\n' || c == '\r';
}

int
scan_word(Reader *r, Token *t)
{
	while (r->p < r->end && isspacing(*r->p))
		r->p++;
	if (r->hash && r->p < r->end && *r->p == '#')
		while (r->p < r->end && !iseol(*r->p))
			r->p++;
	t->s = r->p;
	while (r->p < r->end && !isspacing(*r->p) && !iseol(*r->p))
		r->p++;
	t->n = (size_t)(r->p - t->s);
	return t->n > 0;
}

int
scan_token(Reader *r, Token *t)
{
	while (!scan_word(r, t)) {
		if (r->p == r->end)
			return 0;
		r->line += *r->p++ == '\n';
	}
	return 1;
}

void
scan_skipline(Reader *r)
{
	while (r->p < r->end && !iseol(*r->p))
		r->p++;
}

int
scan_is(Token t, const char *word)
{
	size_t i;

	for (i = 0; i < t.n && word[i]; i++)
		if (tolower((unsigned char)t.s[i]) != tolower((unsigned char)word[i]))
			return 0;
	return i == t.n && !word[i];
}

char *
scan_show(Token t, char buf[SCAN_SHOW])
{
	size_t i, n = t.n < SCAN_SHOW - 4 ? t.n : SCAN_SHOW - 4;

	for (i = 0; i < n; i++)
		buf[i] = t.s[i] > ' ' && t.s[i] < 127 ? t.s[i] : '?';
	strcpy(buf + n, n < t.n ? "..." : "");
	return buf;
}

/* Reads nan, inf or infinity, with or without a sign, and sets *x to infinity for all of them:
 * callers refuse what is not finite. */
static int
notfinite(Token t, double *x)
{
	if (t.n > 0 && (*t.s == '-' || *t.s == '+'))
		t.s++, t.n--;
	*x = HUGE_VAL;
	return scan_is(t, "nan") || scan_is(t, "inf") || scan_is(t, "infinity") ||
	    (t.n > 5 && scan_is((Token){ t.s, 4 }, "nan(") && t.s[t.n-1] == ')');
}

static int
viastrtod(Token t, double *x)
{
	char buf[MAXNUMBER + 1], *end;

	if (t.n > MAXNUMBER)
		return 0;
	memcpy(buf, t.s, t.n);
	buf[t.n] = '\0';
	*x = strtod(buf, &end);
	return end == buf + t.n;
}

/* Appends the decimal digits at *p to the number *w, which has `had` digits so far.  Returns how
 * many were appended, or -1 if there would be more than 18 in all. */
static int
digits(const char **p, const char *end, uint64_t *w, int had)
{
	int n = 0;

	for (; *p < end && **p >= '0' && **p <= '9'; (*p)++, n++) {
		if (had + n == 18)
			return -1;
		*w = 10 * *w + (uint64_t)(**p - '0');
	}
	return n;
}

/* Integers up to 2^53 and powers of ten up to 10^22 are exact doubles, so their quotient is rounded
 * once and equals the result of strtod.  All other numbers are read by strtod. */
int
scan_number(Token t, double *x)
{
	static const double ten[] = { 1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10,
	    1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
	const char *p = t.s, *end = t.s + t.n;
	uint64_t w = 0;
	int whole, part = 0, minus;

	minus = p < end && *p == '-';
	if (p < end && (*p == '-' || *p == '+'))
		p++;
	whole = digits(&p, end, &w, 0);
	if (whole >= 0 && p < end && *p == '.') {
		p++;
		part = digits(&p, end, &w, whole);
	}
	if (p == end && whole >= 0 && part >= 0 && whole + part > 0 && w <= (uint64_t)1 << 53) {
		*x = (double)w / ten[part];
		if (minus)
			*x = -*x;
		return 1;
	}
	for (p = t.s; p < end; p++)
		if (!strchr("0123456789+-.eE", *p) || !*p)
			return notfinite(t, x);
	return viastrtod(t, x);
}

int
scan_int(Token t, long long *i)
{
	size_t k = t.n > 0 && (*t.s == '-' || *t.s == '+');
	long long x = 0;

	if (k == t.n)
		return 0;
	for (; k < t.n; k++) {
		if (t.s[k] < '0' || t.s[k] > '9' || x > (LLONG_MAX - 9) / 10)
			return 0;
		x = 10*x + (t.s[k] - '0');
	}
	*i = *t.s == '-' ? -x : x;
	return 1;
}

INLINE unsigned long long
bytes(const char *p, int n, int big)
{
	unsigned long long w = 0;
	int i;

#pragma GCC unroll 8
	for (i = 0; i < n; i++)
		w = w << 8 | (unsigned char)p[big ? i : n-1 - i];
	return w;
}

/* With n and big constant, the compiler turns the loop in bytes() into a single load. */
unsigned long long
scan_bytes(const char *p, int n, int big)
{
	switch (n) {
	case 1:  return (unsigned char)*p;
	case 4:  return big ? bytes(p, 4, 1) : bytes(p, 4, 0);
	case 8:  return big ? bytes(p, 8, 1) : bytes(p, 8, 0);
	default: return bytes(p, n, big);
	}
}

double
scan_float(const char *p, int n, int big)
{
	uint64_t w = scan_bytes(p, n, big);
	uint32_t w4 = (uint32_t)w;
	double x;
	float y;

	if (n == 4) {
		memcpy(&y, &w4, 4);
		return (double)y;
	}
	memcpy(&x, &w, 8);
	return x;
}
