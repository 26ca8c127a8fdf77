/* lhghead.c - the header of a grid: write and parse.
 *
 * The parser accepts more than the format allows.  Its result is then written again by
 * lhg_puthead and must equal the bytes read, so that only the spelling of the writer is
 * accepted. */
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "lhgpriv.h"

enum { CRCLEN = 9 };            /* eight digits and the LF that end a header */

static const char *const support_word[] = { "grid", "border", "lattice" };

/* ---- write ----------------------------------------------------------- */

typedef struct Text {
	char  *h;               /* [LHG_MAXHEAD + 1] */
	size_t n;               /* more than LHG_MAXHEAD: it was too long */
} Text;

static void
put(Text *t, const char *fmt, ...)
{
	va_list ap;

	if (t->n > LHG_MAXHEAD)
		return;
	va_start(ap, fmt);
	t->n += (size_t)vsnprintf(t->h + t->n, LHG_MAXHEAD + 1 - t->n, fmt, ap);
	va_end(ap);
}

static void
putlines(Text *t, const char *word, const char *text)
{
	const char *p;
	int n;

	for (p = text; p && *p; p += n + 1) {
		n = (int)strcspn(p, "\n");
		put(t, "%s %.*s\n", word, n, p);
	}
}

uint32_t
lhg_headcrc(const char *h, size_t n)
{
	return (uint32_t)crc32(0, (const Bytef *)h, (uInt)(n - CRCLEN));
}

size_t
lhg_puthead(char *h, const Lhg *g, uint32_t prev)
{
	Text t = { h, 0 };
	char T[LHG_HEIGHTLEN];
	const LhgChannel *c;
	size_t n;

	lhg_putheight(T, g->T);
	put(&t, "lhg %d\nsize %d %d\nheight %s\nframe %d %d %08lx\n", lhg_version(g), g->nu, g->nv, T,
	    g->frame, g->frames, (unsigned long)prev);
	if (g->chart != LHG_RECTANGLE)
		put(&t, "chart %s\n", lhg_chartname(g->chart));
	for (c = g->chan; c < g->chan + g->nchan; c++) {
		put(&t, "channel %s %s %s", c->name, c->unit, support_word[c->support]);
		put(&t, c->step ? " %d\n" : "\n", c->step);
	}
	putlines(&t, "meta", g->meta);
	putlines(&t, "history", g->hist);
	n = (t.n + strlen("end ") + CRCLEN + 63)/64*64;
	if (n > LHG_MAXHEAD)
		return 0;
	put(&t, "end%*s", (int)(n - t.n - strlen("end") - CRCLEN), "");
	put(&t, "%08lx\n", (unsigned long)lhg_headcrc(h, n));
	return n;
}

/* ---- parse ----------------------------------------------------------- */

/* Each of these functions parses the item that it is named after at *p, and moves *p behind it.  It
 * returns 0 if the item is not there. */
static int
word(const char **p, const char *w)
{
	size_t n = strlen(w);

	if (strncmp(*p, w, n) != 0)
		return 0;
	*p += n;
	return 1;
}

static int
number(const char **p, int *x)
{
	const char *start = *p;

	for (*x = 0; **p >= '0' && **p <= '9'; ++*p)
		*x = *x < 100000000 ? 10 * *x + (**p - '0') : 1000000000;       /* beyond every limit */
	return *p > start;
}

static int
hex(const char **p, uint32_t *x)
{
	static const char digit[] = "0123456789abcdef";
	const char *d;
	int i;

	for (*x = 0, i = 0; i < 8; i++, ++*p) {
		if (!**p || !(d = strchr(digit, **p)))
			return 0;
		*x = *x << 4 | (uint32_t)(d - digit);
	}
	return 1;
}

/* Copies the word up to the next space or LF.  Returns 0 if it is empty, or too long for `to`, which
 * then has its beginning. */
static int
name(const char **p, char to[LHG_NAMELEN])
{
	size_t n = strcspn(*p, " \n");

	memcpy(to, *p, n < LHG_NAMELEN ? n : LHG_NAMELEN - 1);
	*p += n;
	return n > 0 && n < LHG_NAMELEN;
}

/* Parses "NAME UNIT SUPPORT" at p as the next channel of g.  Returns 0 if it is malformed. */
static int
channel(Lhg *g, const char *p)
{
	LhgChannel *c = &g->chan[g->nchan];
	int k;

	if (!name(&p, c->name) || !word(&p, " ") || !name(&p, c->unit) || !word(&p, " "))
		return 0;
	for (k = LHG_GRID; k <= LHG_LATTICE && !word(&p, support_word[k]); k++)
		;
	if (k > LHG_LATTICE || (k != LHG_GRID && (!word(&p, " ") || !number(&p, &c->step))) || *p != '\n')
		return 0;
	c->support = k;
	c->n = lhg_count(g, k, c->step);
	g->nchan++;
	return 1;
}

/* Parses the header line at p into g and *prev, except meta and history lines, which are left to
 * collect().  Returns 0 if it is malformed. */
static int
headline(Lhg *g, const char *p, uint32_t *prev)
{
	char chart[LHG_NAMELEN] = "";
	size_t n;

	if (word(&p, "meta ") || word(&p, "history "))
		return 1;
	if (word(&p, "channel "))
		return channel(g, p);
	if (word(&p, "size "))
		return number(&p, &g->nu) && word(&p, " ") && number(&p, &g->nv) && *p == '\n';
	if (word(&p, "frame "))
		return number(&p, &g->frame) && word(&p, " ") && number(&p, &g->frames) && word(&p, " ") &&
		    hex(&p, prev) && *p == '\n';
	if (word(&p, "chart "))
		return name(&p, chart) && (g->chart = lhg_chart(chart)) > LHG_RECTANGLE;
	if (word(&p, "height ")) {
		n = strcspn(p, "\n");
		g->T = lhg_getheight(p, n);
		return g->T > 0;
	}
	return 0;
}

/* Sets *text, malloc'd, to what follows w in all lines of h that begin with w, or to NULL if no line
 * does.  Returns 0 or LHG_ENOMEM. */
static int
collect(const char *h, const char *w, char **text)
{
	const char *p, *q;
	size_t n = 0, len;
	char *t;

	for (p = h; *p; p = q + (*q == '\n')) {
		q = p + strcspn(p, "\n");
		if (word(&p, w))
			n += (size_t)(q - p) + 1;
	}
	*text = n ? t = malloc(n + 1) : NULL;
	if (!*text)
		return n ? LHG_ENOMEM : 0;
	for (p = h; *p; p = q + (*q == '\n')) {
		q = p + strcspn(p, "\n");
		len = (size_t)(q - p) - strlen(w) + 1;
		if (word(&p, w))
			t = (char *)memcpy(t, p, len) + len;
	}
	*t = '\0';
	return 0;
}

/* The number of the first line in which h differs from `again`, counted from 1. */
static int
difference(const char *h, const char *again)
{
	int no = 1;

	for (; *h && *h == *again; h++, again++)
		no += *h == '\n';
	return no;
}

/* Checks that the header h consists of the bytes that lhg_puthead writes for g. */
static int
checkspelling(LhgStream *s, const Lhg *g, const char *h, size_t n, uint32_t prev)
{
	char *again = malloc(LHG_MAXHEAD + 1);
	int e = 0;

	if (!again)
		return lhg_fail(s, g, LHG_ENOMEM, "no memory for the header");
	again[0] = '\0';
	if (lhg_puthead(again, g, prev) != n || memcmp(h, again, n) != 0)
		e = lhg_fail(s, g, LHG_EHEAD, "header line %d is out of place or not in its only spelling",
		    difference(h, again));
	free(again);
	return e;
}

int
lhg_gethead(LhgStream *s, Lhg *g, const char *h, size_t n, uint32_t *prev)
{
	const char *p, *end = h + n;
	int e, no;

	for (no = 1, p = h; strncmp(p, "end", 3) != 0; no++) {
		if (no > 1 && strncmp(p, "channel ", 8) == 0 && g->nchan == LHG_MAXCHAN)
			return lhg_fail(s, g, LHG_ELIMIT, "header line %d: more than %d channels", no, LHG_MAXCHAN);
		if (no > 1 && !headline(g, p, prev))
			return lhg_fail(s, g, LHG_EHEAD, "header line %d is malformed", no);
		p = (const char *)memchr(p, '\n', (size_t)(end - p)) + 1;
	}
	if (collect(h, "meta ", &g->meta) || collect(h, "history ", &g->hist))
		return lhg_fail(s, g, LHG_ENOMEM, "no memory for the header");
	if ((e = lhg_check(s, g)) == 0)
		e = checkspelling(s, g, h, n, *prev);
	return e;
}
