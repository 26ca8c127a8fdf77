/* lhgwrite.c - write streams of grids.  Section numbers: LHG.md. */
#include <errno.h>
#include <math.h>
#include <string.h>
#include <zlib.h>

#include "lhgpriv.h"

static int
checkfinite(LhgStream *s, const Lhg *g)
{
	const LhgChannel *c;
	size_t p;

	for (c = g->chan; c < g->chan + g->nchan; c++)
		for (p = 0; p < c->n; p++)
			if (!isfinite(c->f[p]))
				return lhg_fail(s, g, LHG_EVALUE, "channel %s is not finite at sample %zu of %zu",
				    c->name, p, c->n);
	return 0;
}

static int
give(FILE *f, const void *bytes, size_t n)
{
	errno = 0;
	return fwrite(bytes, 1, n, f) != n;
}

/* Stores n samples at b, in 8 bytes each, least significant byte first. */
static void
pack(unsigned char *b, const double *f, size_t n)
{
	size_t p, i;
	uint64_t w;

	for (p = 0; p < n; p++) {
		memcpy(&w, &f[p], 8);
		for (i = 0; i < 8; i++, w >>= 8)
			*b++ = w & 0xff;
	}
}

static int
writechannel(FILE *f, const LhgChannel *c, uint32_t *crc)
{
	unsigned char b[8*LHG_BLOCK], tail[LHG_ALIGN] = { 0 };
	size_t p, n, i;

	for (p = 0; p < c->n; p += n) {
		n = c->n - p < LHG_BLOCK ? c->n - p : LHG_BLOCK;
		pack(b, c->f + p, n);
		*crc = (uint32_t)crc32(*crc, b, (uInt)(8*n));
		if (give(f, b, 8*n))
			return -1;
	}
	for (i = 0; i < 4; i++)
		tail[i] = *crc >> 8*i & 0xff;
	return give(f, tail, lhg_taillen(c->n));
}

int
lhg_begin_next(LhgStream *s, int version)
{
	Lhg next = { .frames = 1 };

	if (fprintf(s->f, "lhg %d\n", version) < 0 || fflush(s->f) == EOF)
		return lhg_failio(s, &next, "write");
	s->ahead = version;
	return 0;
}

int
lhg_write(LhgStream *s, const Lhg *g)
{
	char h[LHG_MAXHEAD + 1];
	uint32_t crc;
	size_t n, written = s->ahead ? LHG_MAGICLEN : 0;
	int c, e;

	if ((e = lhg_check(s, g)) != 0 || (e = lhg_checkorder(s, g)) != 0 || (e = checkfinite(s, g)) != 0)
		return e;
	if (s->ahead && s->ahead != lhg_version(g))
		return lhg_fail(s, g, LHG_EORDER, "its chart is not that of the version begun");
	if ((n = lhg_puthead(h, g, lhg_lastcrc(s))) == 0)
		return lhg_fail(s, g, LHG_ELIMIT, "header is longer than %d bytes", LHG_MAXHEAD);
	crc = lhg_headcrc(h, n);
	e = give(s->f, h + written, n - written);
	s->ahead = 0;
	for (c = 0; !e && c < g->nchan; c++)
		e = writechannel(s->f, &g->chan[c], &crc);
	if (e || give(s->f, lhg_end, sizeof lhg_end) || fflush(s->f) == EOF)
		return lhg_failio(s, g, "write");
	lhg_passed(s, g, crc);
	return 0;
}
