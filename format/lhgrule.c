/* lhgrule.c - the limits of what a header may hold.  Section numbers: LHG.md. */
#include <math.h>
#include <string.h>

#include "lhgpriv.h"

/* Section 2.2: checks channel number c. */
static int
checkchannel(LhgStream *s, const Lhg *g, int c)
{
	const LhgChannel *ch = &g->chan[c];
	size_t n = lhg_count(g, ch->support, ch->step);

	if (!memchr(ch->name, '\0', LHG_NAMELEN) || !lhg_goodname(ch->name, strlen(ch->name), LHG_NAMELEN, ""))
		return lhg_fail(s, g, LHG_ELIMIT, "the name of channel %d is not 1 to %d letters, digits or ._+-",
		    c + 1, LHG_NAMELEN - 1);
	if (!memchr(ch->unit, '\0', LHG_NAMELEN) || !lhg_goodname(ch->unit, strlen(ch->unit), LHG_NAMELEN,
		"/^*"))
		return lhg_fail(s, g, LHG_ELIMIT, "the unit of channel %s is not 1 to %d letters, digits or ._+-/^*",
		    ch->name, LHG_NAMELEN - 1);
	if (lhg_find(g, ch->name) != ch)
		return lhg_fail(s, g, LHG_ELIMIT, "channel %s is there twice", ch->name);
	if (n == 0)
		return lhg_fail(s, g, LHG_ELIMIT, "the support of channel %s does not suit a grid of %d x %d nodes",
		    ch->name, g->nu, g->nv);
	if (ch->n != n)
		return lhg_fail(s, g, LHG_ELIMIT, "channel %s has %zu samples, its support %zu", ch->name, ch->n, n);
	return 0;
}

/* Sections 2.3 and 2.4: checks every line of text.  In the header a word of w bytes comes before it;
 * the two together must not be too long.  `what` names the text in messages. */
static int
checklines(LhgStream *s, const Lhg *g, const char *text, const char *what, size_t w)
{
	const char *p, *end;
	int no = 1;

	for (p = text; p && *p; p = end + 1, no++)
		if (!(end = strchr(p, '\n')) || w + (size_t)(end - p) > LHG_MAXLINE ||
		    !lhg_goodtext(p, (size_t)(end - p)))
			return lhg_fail(s, g, LHG_ELIMIT, "%s line %d is not text, or too long", what, no);
	return 0;
}

/* Section 2.3: checks the keys of the metadata, whose lines checklines has accepted. */
static int
checkkeys(LhgStream *s, const Lhg *g)
{
	const char *p, *q;
	size_t n;
	int no = 1;

	for (p = g->meta; p && *p; p = strchr(p, '\n') + 1, no++) {
		n = strcspn(p, " \n");
		if (!lhg_goodname(p, n, LHG_KEYLEN, "") || p[n] != ' ' || p[n+1] == ' ')
			return lhg_fail(s, g, LHG_ELIMIT, "meta line %d is not a key and a value", no);
		for (q = g->meta; q < p; q = strchr(q, '\n') + 1)
			if (strncmp(p, q, n + 1) == 0)
				return lhg_fail(s, g, LHG_ELIMIT, "meta key %.*s is there twice", (int)n, p);
	}
	return 0;
}

int
lhg_check(LhgStream *s, const Lhg *g)
{
	int c, e = 0;

	if (g->nu < LHG_MINN || g->nu > LHG_MAXN || g->nv < LHG_MINN || g->nv > LHG_MAXN)
		return lhg_fail(s, g, LHG_ELIMIT, "size is not %d to %d nodes each way", LHG_MINN, LHG_MAXN);
	if (g->chart != LHG_RECTANGLE && g->chart != LHG_SOCK && g->chart != LHG_PILLOW)
		return lhg_fail(s, g, LHG_ELIMIT, "the chart is not known");
	if (g->chart != LHG_RECTANGLE && g->nu % 2)
		return lhg_fail(s, g, LHG_ELIMIT, "a %s has an even number of nodes along u, not %d",
		    lhg_chartname(g->chart), g->nu);
	if (!(g->T > 0) || !isfinite(g->T))
		return lhg_fail(s, g, LHG_ELIMIT, "height is not a positive number");
	if (g->frame < 1 || g->frame > g->frames || g->frames > LHG_MAXFRAMES)
		return lhg_fail(s, g, LHG_ELIMIT, "frame and number of frames are not 1 <= k <= n <= %d",
			LHG_MAXFRAMES);
	if (g->nchan < 1 || g->nchan > LHG_MAXCHAN)
		return lhg_fail(s, g, LHG_ELIMIT, "number of channels is not 1 to %d", LHG_MAXCHAN);
	for (c = 0; !e && c < g->nchan; c++)
		e = checkchannel(s, g, c);
	if (!e)
		e = checklines(s, g, g->meta, "meta", strlen("meta "));
	if (!e)
		e = checkkeys(s, g);
	if (!e)
		e = checklines(s, g, g->hist, "history", strlen("history "));
	return e;
}
