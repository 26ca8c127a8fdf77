/* lhgpriv.h - declarations shared by the files of format/; not for callers. */
#ifndef LHGPRIV_H
#define LHGPRIV_H

#include "lhg.h"

/* ---- lhgio.c ---- */

enum {
	LHG_ALIGN = 64,         /* every part of a grid starts at a multiple of so many bytes */
	LHG_BLOCK = 8192        /* samples read or written at a time, 64 KiB */
};

extern const char lhg_end[LHG_ALIGN];   /* the end mark, LHG.md 4 */

/* Bytes that follow n samples up to the end of the block: CRC and padding. */
size_t lhg_taillen(size_t n);

/* Leaves "place: message" in s->err.  The place is the number of the frame or grid that is being
 * read or written; g is that grid, as far as it is known.  Returns code. */
int lhg_fail(LhgStream *s, const Lhg *g, int code, const char *fmt, ...);

/* The same with LHG_EIO and the reason from errno; `what` is "read" or "write". */
int lhg_failio(LhgStream *s, const Lhg *g, const char *what);

/* Checks that frame and frames of g may follow those of the grid before, by LHG.md 5.  Returns 0 or
 * LHG_EORDER. */
int lhg_checkorder(LhgStream *s, const Lhg *g);

/* The CRC that line 4 of the next header repeats. */
uint32_t lhg_lastcrc(const LhgStream *s);

/* Records that g was read or written completely; its last CRC is crc. */
void lhg_passed(LhgStream *s, const Lhg *g, uint32_t crc);

/* ---- lhgspell.c ---- */

/* Whether the n bytes at p are 1 .. size-1 characters, each a letter, a digit, one of . _ + - or
 * one of those in extra. */
int lhg_goodname(const char *p, size_t n, size_t size, const char *extra);

/* Whether the n bytes at p are a value or a text by LHG.md 2.3. */
int lhg_goodtext(const char *p, size_t n);

/* lhg_putheight writes T > 0 in the notation of LHG.md 2, lhg_getheight reads it.  Both are
 * independent of the locale.  lhg_getheight returns 0 if the text is not a decimal number. */
enum { LHG_HEIGHTLEN = 40 };
void   lhg_putheight(char text[LHG_HEIGHTLEN], double T);
double lhg_getheight(const char *p, size_t n);

/* ---- lhgrule.c ---- */

/* Checks that everything in g, except the values of samples, is within the limits of LHG.md.
 * Returns 0 or LHG_ELIMIT. */
int lhg_check(LhgStream *s, const Lhg *g);

/* ---- lhghead.c ---- */

/* Writes the header of g, which lhg_check has accepted, to h[LHG_MAXHEAD + 1].  Line 4 of the header
 * repeats the CRC prev.  Returns its length, or 0 if it is longer than LHG_MAXHEAD. */
size_t lhg_puthead(char *h, const Lhg *g, uint32_t prev);

/* Computes the CRC that ends a header of n bytes. */
uint32_t lhg_headcrc(const char *h, size_t n);

/* Parses a header of n bytes, whose CRC has been checked and whose last byte is an LF, into g and
 * *prev.  g is empty before; afterwards its channels have no samples yet.  Returns 0 or a negative
 * code; lhg_free(g) in both cases. */
int lhg_gethead(LhgStream *s, Lhg *g, const char *h, size_t n, uint32_t *prev);

#endif
