/* lhg.c - fuzz target: the .lhg reader.  Every accepted grid is within the limits of LHG.md, and
 * writing it gives the bytes that were read. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../format/lhg.h"
#include "fuzz.h"

enum { CONSTANT = (1 << 20) + (1 << 17) };      /* bytes: 1.125 MiB, below the 1.2 of LHG.md 8 */

static void
valid(const Lhg *g)
{
	const LhgChannel *c;
	size_t k;

	fuzz_need(g->nu >= LHG_MINN && g->nu <= LHG_MAXN && g->nv >= LHG_MINN && g->nv <= LHG_MAXN, "size");
	fuzz_need(g->T > 0 && isfinite(g->T), "height");
	fuzz_need(g->frame >= 1 && g->frame <= g->frames && g->frames <= LHG_MAXFRAMES, "frame");
	fuzz_need(g->nchan >= 1 && g->nchan <= LHG_MAXCHAN, "number of channels");
	for (c = g->chan; c < g->chan + g->nchan; c++) {
		fuzz_need(c->n > 0 && c->n == lhg_count(g, c->support, c->step), "number of samples");
		fuzz_need(lhg_find(g, c->name) == c, "name");
		for (k = 0; k < c->n; k++)
			fuzz_need(isfinite(c->f[k]), "sample");
	}
}

static void
refused(const LhgStream *s, const Lhg *g)
{
	const char *p;

	fuzz_need(g->nchan == 0 && !g->meta && !g->hist, "a refused grid has something to free");
	fuzz_need(s->err[0] != '\0', "a refusal without a message");
	for (p = s->err; *p; p++)
		fuzz_need(*p >= 0x20 && *p < 0x7f, "a message is not one printable line");
}

/* Writes every grid of in to out.  Returns the last code of lhg_read. */
static int
copy(FILE *in, FILE *out)
{
	LhgStream r, w;
	Lhg g;
	int e;

	lhg_open(&r, in);
	lhg_open(&w, out);
	while ((e = lhg_read(&r, &g)) == 1) {
		valid(&g);
		fuzz_need(lhg_write(&w, &g) == 0, "a grid that was read cannot be written");
		lhg_free(&g);
	}
	if (e < 0)
		refused(&r, &g);
	return e;
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	static char again[1 << 20];
	const size_t before = fuzz_live();
	FILE *in, *out;
	long written;
	int e;

	if (n == 0 || n >= sizeof again)
		return 0;
	in = fmemopen((void *)(uintptr_t)data, n, "rb");
	out = fmemopen(again, sizeof again, "wb");
	fuzz_need(in && out, "fmemopen");
	fuzz_mark();
	e = copy(in, out);
	fuzz_need(fuzz_peak() - before <= 3*n + CONSTANT, "too much memory");
	fuzz_need(fuzz_live() == before, "memory is lost");
	written = ftell(out);
	fuzz_need(written >= 0 && (size_t)written <= n && memcmp(again, data, (size_t)written) == 0,
	    "writing does not give the bytes that were read");
	fuzz_need(e < 0 || (size_t)written == n, "bytes were skipped");
	fclose(in);
	fclose(out);
	return 0;
}
