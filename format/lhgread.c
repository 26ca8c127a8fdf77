/* lhgread.c - read streams of grids.  Section numbers: LHG.md. */
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

#include "lhgpriv.h"

enum { FIRST = 131072 };        /* samples allocated before any has been read, 1 MiB */

/* Reads n bytes, or fewer if the input ends.  Interruption by a signal is not an error. */
static size_t
take(FILE *f, void *to, size_t n)
{
	size_t got = 0;

	errno = 0;
	while ((got += fread((char *)to + got, 1, n - got, f)) < n && ferror(f) && errno == EINTR)
		clearerr(f);
	return got;
}

/* Whether the n < LHG_MAGICLEN bytes at b begin a line 1 that lhg_magic knows. */
static int
magicbegins(const char *b, size_t n)
{
	return memcmp(b, "lhg ", n < 4 ? n : 4) == 0 && (n < 5 || b[4] == '1' || b[4] == '2');
}

/* Reads line 1 of a header.  Returns its version, 0 if the input ends before it, or a negative
 * code. */
static int
readmagic(LhgStream *s, const Lhg *g)
{
	char b[LHG_MAGICLEN];
	size_t n = take(s->f, b, sizeof b);

	if (n < sizeof b && ferror(s->f))
		return lhg_failio(s, g, "read");
	if (n < sizeof b && magicbegins(b, n))
		return n > 0 ? lhg_fail(s, g, LHG_ESHORT, "input ends in line 1 of a header") : 0;
	if (n == sizeof b && lhg_magic(b))
		return lhg_magic(b);
	if (g->nchan > 0 || s->grids > 0)
		return lhg_fail(s, g, LHG_EDATA, "bytes follow the end mark%s", g->nchan > 0 ? "" : " before it");
	if (n == sizeof b && magicbegins(b, n - 1) && b[n-1] == '\r')
		return lhg_fail(s, g, LHG_EMAGIC, "input is an lhg stream whose line ends were changed");
	if (n == sizeof b && memcmp(b, "lhg ", 4) == 0)
		return lhg_fail(s, g, LHG_EMAGIC, "input is not version 1 or 2 of lhg");
	return lhg_fail(s, g, LHG_EFOREIGN, "input is not an lhg stream");
}

static int
shorthead(LhgStream *s, const Lhg *g, const char *h, size_t n)
{
	int line = 1;

	while (n-- > 0)
		line += h[n] == '\n';
	return ferror(s->f) ? lhg_failio(s, g, "read") :
	    lhg_fail(s, g, LHG_ESHORT, "input ends in header line %d", line);
}

/* Section 2: reads a header whose line 1, of this version, has been read already.  h gets the whole
 * header, with line 1, and a NUL. */
static int
takehead(LhgStream *s, const Lhg *g, int version, char h[LHG_MAXHEAD + 1], size_t *n)
{
	char *line = h, *lf = NULL;
	size_t want, got;

	snprintf(h, LHG_MAGICLEN + 1, "lhg %d\n", version);
	for (*n = LHG_MAGICLEN; *n < LHG_MAXHEAD;) {
		want = LHG_ALIGN - *n % LHG_ALIGN;
		*n += got = take(s->f, h + *n, want);
		h[*n] = '\0';
		if (got < want)
			return shorthead(s, g, h, *n);
		while ((lf = memchr(line, '\n', (size_t)(h + *n - line))) && strncmp(line, "end", 3) != 0)
			line = lf + 1;
		if (lf == h + *n - 1)
			return 0;
		if (lf)
			return lhg_fail(s, g, LHG_EHEAD, "header does not end at a multiple of %d bytes", LHG_ALIGN);
	}
	return lhg_fail(s, g, LHG_EHEAD, "header has no end in its first %d bytes", LHG_MAXHEAD);
}

/* Reads a header whose line 1, of this version, has been read already, and parses it into g.  *crc:
 * the CRC at its end. */
static int
readhead(LhgStream *s, Lhg *g, int version, uint32_t *crc)
{
	char h[LHG_MAXHEAD + 1], digits[16];
	uint32_t prev = 0;
	size_t n;
	int e;

	if ((e = takehead(s, g, version, h, &n)) != 0)
		return e;
	*crc = lhg_headcrc(h, n);
	snprintf(digits, sizeof digits, " %08lx\n", (unsigned long)*crc);
	if (strcmp(h + n - strlen(digits), digits) != 0)
		return lhg_fail(s, g, LHG_EHEAD, "header CRC is wrong");
	if ((e = lhg_gethead(s, g, h, n, &prev)) != 0 || (e = lhg_checkorder(s, g)) != 0)
		return e;
	if (prev != lhg_lastcrc(s))
		return lhg_fail(s, g, LHG_EORDER, g->frame == 1 ? "frame 1 does not begin with CRC 0" :
		    "it does not belong to the frame before it");
	return 0;
}

/* Converts samples, least significant byte first, to numbers in place.  Returns the number of
 * samples before the first that is not finite. */
static size_t
unpack(double *f, size_t n)
{
	size_t p, i, good = n;
	unsigned char b[8];
	uint64_t w;

	for (p = 0; p < n; p++) {
		memcpy(b, &f[p], 8);
		for (w = 0, i = 8; i-- > 0;)
			w = w << 8 | b[i];
		memcpy(&f[p], &w, 8);
		if (!isfinite(f[p]) && p < good)
			good = p;
	}
	return good;
}

/* Make room for more than `room` samples of c. */
static int
grow(LhgChannel *c, size_t *room)
{
	size_t want = *room ? 2 * *room : FIRST;
	double *f;

	if (want > c->n)
		want = c->n;
	if (want > SIZE_MAX/sizeof *f || !(f = realloc(c->f, want*sizeof *f)))
		return LHG_ENOMEM;
	c->f = f;
	*room = want;
	return 0;
}

/* Reads the samples of c; *good is how many come before the first that is not finite. */
static int
readsamples(LhgStream *s, const Lhg *g, LhgChannel *c, uint32_t *crc, size_t *good)
{
	size_t got = 0, room = 0, want, bytes, fine;

	for (*good = c->n; got < c->n; got += want) {
		if (got == room && grow(c, &room))
			return lhg_fail(s, g, LHG_ENOMEM, "no memory for the %zu samples of channel %s", c->n, c->name);
		want = room - got < LHG_BLOCK ? room - got : LHG_BLOCK;
		bytes = take(s->f, c->f + got, 8*want);
		if (bytes < 8*want)
			return ferror(s->f) ? lhg_failio(s, g, "read") : lhg_fail(s, g, LHG_ESHORT,
			    "channel %s ends at sample %zu of %zu", c->name, got + bytes/8, c->n);
		*crc = (uint32_t)crc32(*crc, (const Bytef *)(c->f + got), (uInt)bytes);
		fine = unpack(c->f + got, want);
		if (fine < want && *good == c->n)
			*good = got + fine;
	}
	return 0;
}

/* Section 3: reads a channel block.  *crc: in, the CRC before the block; out, the CRC in it. */
static int
readchannel(LhgStream *s, const Lhg *g, LhgChannel *c, uint32_t *crc)
{
	size_t good, i, n = lhg_taillen(c->n);
	unsigned char b[LHG_ALIGN];
	uint32_t is;
	int e;

	if ((e = readsamples(s, g, c, crc, &good)) != 0)
		return e;
	if (take(s->f, b, n) < n)
		return ferror(s->f) ? lhg_failio(s, g, "read") :
		    lhg_fail(s, g, LHG_ESHORT, "channel %s ends after its samples", c->name);
	is = b[0] | (uint32_t)b[1] << 8 | (uint32_t)b[2] << 16 | (uint32_t)b[3] << 24;
	if (is != *crc)
		return lhg_fail(s, g, LHG_EDATA, "channel %s: CRC is wrong", c->name);
	for (i = 4; i < n; i++)
		if (b[i])
			return lhg_fail(s, g, LHG_EDATA, "channel %s: padding is not zero", c->name);
	if (good < c->n)
		return lhg_fail(s, g, LHG_EVALUE, "channel %s is not finite at sample %zu of %zu", c->name, good,
			c->n);
	return 0;
}

static int
readend(LhgStream *s, const Lhg *g)
{
	char b[LHG_ALIGN];

	if (take(s->f, b, sizeof b) < sizeof b)
		return ferror(s->f) ? lhg_failio(s, g, "read") : lhg_fail(s, g, LHG_ESHORT, "end mark is missing");
	if (memcmp(b, lhg_end, sizeof b) != 0)
		return lhg_fail(s, g, LHG_EDATA, "end mark is wrong");
	return 0;
}

/* Reads a grid behind line 1 of its header, of this version.  After the last frame of a set also reads
 * line 1 of the next header, if the input does not end there. */
static int
readgrid(LhgStream *s, Lhg *g, int version, uint32_t *crc)
{
	int c, e;

	e = readhead(s, g, version, crc);
	for (c = 0; !e && c < g->nchan; c++)
		e = readchannel(s, g, &g->chan[c], crc);
	if (!e)
		e = readend(s, g);
	if (!e && g->frame == g->frames && (e = readmagic(s, g)) > 0) {
		s->ahead = e;
		e = 0;
	}
	return e;
}

int
lhg_read(LhgStream *s, Lhg *g)
{
	uint32_t crc;
	int e;

	lhg_init(g, 0, 0, 0);
	e = s->ahead ? s->ahead : readmagic(s, g);
	if (e == 0 && s->grids == 0)
		return lhg_fail(s, g, LHG_EMAGIC, "empty input");
	if (e == 0 && s->frame < s->frames)
		return lhg_fail(s, g, LHG_ESHORT, "input ends before it");
	if (e <= 0)
		return e;
	s->ahead = 0;
	if ((e = readgrid(s, g, e, &crc)) != 0) {
		lhg_free(g);
		return e;
	}
	lhg_passed(s, g, crc);
	return 1;
}
