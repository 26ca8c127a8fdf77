/* lhgpriv.h - declarations shared by the files of format/; not for callers. */
#ifndef LHGPRIV_H
#define LHGPRIV_H

#include "lhg.h"

/* ---- lhgio.c ---- */

enum {
	LHG_MAGICLEN = sizeof LHG_MAGIC - 1,
	LHG_ALIGN = 64,         /* every part of a grid starts at a multiple of this */
	LHG_BLOCK = 8192        /* samples read or written at a time, 64 KiB */
};

extern const char lhg_end[LHG_ALIGN];   /* 4. End mark */

/* Bytes that follow n samples up to the end of the block: CRC and padding. */
size_t lhg_taillen(size_t n);

/* Leave "place: message" in s->err, the place being the frame or grid that g, the grid
 * under way, is or is to be.  Returns code. */
int lhg_fail(LhgStream *s, const Lhg *g, int code, const char *fmt, ...);

/* The same with LHG_EIO and the reason in errno; what is "read" or "write". */
int lhg_failio(LhgStream *s, const Lhg *g, const char *what);

/* Checks that frame and frames of g may follow the grid before, section 5.  Returns 0 or
 * LHG_EORDER. */
int lhg_checkorder(LhgStream *s, const Lhg *g);

/* The CRC that line 4 of the next header repeats. */
uint32_t lhg_lastcrc(const LhgStream *s);

/* Records that g was read or written completely; its last CRC is crc. */
void lhg_passed(LhgStream *s, const Lhg *g, uint32_t crc);

/* ---- lhgspell.c ---- */

/* The n bytes at p are 1 .. size-1 letters, digits and . _ + - or of those in extra. */
int lhg_goodname(const char *p, size_t n, size_t size, const char *extra);

/* Whether the n bytes at p are a value or a text by LHG.md 2.3. */
int lhg_goodtext(const char *p, size_t n);

/* T > 0 in the notation of LHG.md 2, and back; both are independent of the locale.  lhg_getheight
 * gives 0 if the text is not a decimal number. */
enum { LHG_HEIGHTLEN = 40 };
void   lhg_putheight(char text[LHG_HEIGHTLEN], double T);
double lhg_getheight(const char *p, size_t n);

/* ---- lhgrule.c ---- */

/* All of g but its samples is within the limits of LHG.md.  Returns 0 or LHG_ELIMIT. */
int lhg_check(LhgStream *s, const Lhg *g);

/* ---- lhghead.c ---- */

/* The header of a checked g, whose line 4 repeats prev, into h[LHG_MAXHEAD + 1].  Returns
 * its length, or 0: longer than LHG_MAXHEAD. */
size_t lhg_puthead(char *h, const Lhg *g, uint32_t prev);

/* The CRC that ends a header of n bytes, as computed. */
uint32_t lhg_headcrc(const char *h, size_t n);

/* Parse a header of n bytes, ended by an LF, whose CRC is right, into an empty g, whose
 * channels then have no samples yet, and *prev.  Returns 0 or a negative code; lhg_free(g)
 * in either case. */
int lhg_gethead(LhgStream *s, Lhg *g, const char *h, size_t n, uint32_t *prev);

#endif
