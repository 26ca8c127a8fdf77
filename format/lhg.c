/* lhg.c - grids in memory: channels, supports, metadata, history. */
#include <stdlib.h>
#include <string.h>

#include "lhgpriv.h"

void
lhg_init(Lhg *g, int nu, int nv, double T)
{
	memset(g, 0, sizeof *g);
	g->nu = nu;
	g->nv = nv;
	g->T = T;
	g->frame = g->frames = 1;
}

void
lhg_free(Lhg *g)
{
	int c;

	for (c = 0; c < g->nchan; c++)
		free(g->chan[c].f);
	free(g->meta);
	free(g->hist);
	lhg_init(g, 0, 0, 0);
}

/* ---- channels -------------------------------------------------------- */

static const char *const chart_word[] = { "rectangle", "sock", "pillow" };

const char *
lhg_chartname(int chart)
{
	return chart_word[chart];
}

int
lhg_chart(const char *name)
{
	int k;

	for (k = LHG_PILLOW; k >= 0 && strcmp(name, chart_word[k]) != 0; k--)
		;
	return k;
}

size_t
lhg_count(const Lhg *g, int support, int step)
{
	int nu = g->nu, nv = g->nv;
	size_t inner;

	if (nu < LHG_MINN || nu > LHG_MAXN || nv < LHG_MINN || nv > LHG_MAXN)
		return 0;
	if (support == LHG_GRID)
		return step == 0 ? (size_t)nu*nv : 0;
	if (step < 1 || step >= (nu > nv ? nu : nv))
		return 0;
	if (support == LHG_LATTICE && g->chart == LHG_RECTANGLE)
		return (size_t)((nu-1)/step + 1)*((nv-1)/step + 1);
	if (support != LHG_BORDER || g->chart == LHG_PILLOW)
		return 0;
	if (g->chart == LHG_SOCK)
		return (size_t)nu*(step < nv ? step : nv);
	inner = nu > 2*step && nv > 2*step ? (size_t)(nu - 2*step)*(nv - 2*step) : 0;
	return (size_t)nu*nv - inner;
}

LhgChannel *
lhg_find(const Lhg *g, const char *name)
{
	int c;

	for (c = 0; c < g->nchan; c++)
		if (strcmp(g->chan[c].name, name) == 0)
			return (LhgChannel *)&g->chan[c];
	return NULL;
}

double *
lhg_add(Lhg *g, const char *name, const char *unit, int support, int step)
{
	LhgChannel *c = &g->chan[g->nchan];
	size_t n = lhg_count(g, support, step);

	if (g->nchan == LHG_MAXCHAN || n == 0 || lhg_find(g, name) ||
	    !lhg_goodname(name, strlen(name), LHG_NAMELEN, "") ||
	    !lhg_goodname(unit, strlen(unit), LHG_NAMELEN, "/^*"))
		return NULL;
	if (!(c->f = calloc(n, sizeof *c->f)))
		return NULL;
	strcpy(c->name, name);
	strcpy(c->unit, unit);
	c->support = support;
	c->step = step;
	c->n = n;
	g->nchan++;
	return c->f;
}

void
lhg_drop(Lhg *g, const char *name)
{
	LhgChannel *c = lhg_find(g, name);

	if (!c)
		return;
	free(c->f);
	g->nchan--;
	memmove(c, c + 1, (size_t)(&g->chan[g->nchan] - c)*sizeof *c);
}

size_t
lhg_first(const Lhg *g, const LhgChannel *c)
{
	if (c->support == LHG_BORDER && g->chart == LHG_SOCK && c->step < g->nv)
		return (size_t)(g->nv - c->step)*g->nu;
	return 0;
}

/* The order of the nodes is that of LHG.md 2.2. */
size_t
lhg_next(const Lhg *g, const LhgChannel *c, size_t p)
{
	size_t nu = g->nu, nv = g->nv, w = c->step, i = ++p % nu, j = p / nu;

	if (c->support == LHG_LATTICE && j % w)
		return (j/w + 1)*w < nv ? (j/w + 1)*w*nu : nu*nv;
	if (c->support == LHG_LATTICE && i % w)
		return (i/w + 1)*w < nu ? j*nu + (i/w + 1)*w : lhg_next(g, c, j*nu + nu - 1);
	if (c->support == LHG_BORDER && g->chart == LHG_RECTANGLE && i >= w && i + w < nu && j >= w &&
	    j + w < nv)
		return j*nu + nu - w;
	return p;
}

void
lhg_gather(const Lhg *g, LhgChannel *c, const double *f)
{
	size_t k, p = lhg_first(g, c);

	for (k = 0; k < c->n; k++, p = lhg_next(g, c, p))
		c->f[k] = f[p];
}

void
lhg_scatter(const Lhg *g, const LhgChannel *c, double *f)
{
	size_t k, p = lhg_first(g, c);

	for (k = 0; k < c->n; k++, p = lhg_next(g, c, p))
		f[p] = c->f[k];
}

/* ---- metadata and history -------------------------------------------- */

/* The line of key in g->meta, or NULL. */
static char *
datum(const Lhg *g, const char *key)
{
	size_t n = strlen(key);
	char *p, *end;

	for (p = g->meta; p && (end = strchr(p, '\n')); p = end + 1)
		if (strncmp(p, key, n) == 0 && p[n] == ' ')
			return p;
	return NULL;
}

/* Replaces the `old` bytes at offset `at` of *s by the n bytes of text, which must not be a part of
 * *s.  An empty *s is NULL, before and after.  Returns 0 or LHG_ENOMEM. */
static int
splice(char **s, size_t at, size_t old, const char *text, size_t n)
{
	size_t tail = *s ? strlen(*s + at + old) : 0;
	char *t = at + n + tail ? malloc(at + n + tail + 1) : NULL;

	if (!t && at + n + tail)
		return LHG_ENOMEM;
	if (t) {
		if (at)
			memcpy(t, *s, at);
		memcpy(t + at, text, n);
		if (tail)
			memcpy(t + at + n, *s + at + old, tail);
		t[at + n + tail] = '\0';
	}
	free(*s);
	*s = t;
	return 0;
}

int
lhg_setmeta(Lhg *g, const char *key, const char *value)
{
	char line[LHG_MAXLINE + 2], *p = datum(g, key);
	size_t at = p ? (size_t)(p - g->meta) : g->meta ? strlen(g->meta) : 0;
	size_t old = p ? strcspn(p, "\n") + 1 : 0;
	int n = 0;

	if (!lhg_goodname(key, strlen(key), LHG_KEYLEN, ""))
		return LHG_ELIMIT;
	if (value && (!lhg_goodtext(value, strlen(value)) ||
	    strlen("meta  ") + strlen(key) + strlen(value) > LHG_MAXLINE))
		return LHG_ELIMIT;
	if (value)
		n = snprintf(line, sizeof line, "%s %s\n", key, value);
	return n || old ? splice(&g->meta, at, old, line, (size_t)n) : 0;
}

const char *
lhg_getmeta(const Lhg *g, const char *key, char *value, size_t n)
{
	const char *p = datum(g, key);
	size_t len;

	if (!p || n == 0)
		return NULL;
	p += strlen(key) + 1;
	len = strcspn(p, "\n");
	if (len >= n)
		len = n - 1;
	memcpy(value, p, len);
	value[len] = '\0';
	return value;
}

int
lhg_note(Lhg *g, const char *step)
{
	enum { ROOM = LHG_MAXLINE - 8 };        /* beside "history " */
	char line[LHG_MAXLINE];
	size_t n = 0, i, len, left, cut = 0;

	step += strspn(step, " ");
	for (left = strlen(step); left && step[left-1] == ' '; left--)
		;
	for (i = 0; left && n <= ROOM; i += len, left -= len) {
		if (n + 3 <= ROOM)
			cut = n;                /* "..." still fits here */
		len = lhg_utf8(step + i, left);
		memcpy(line + n, len ? step + i : "?", len ? len : 1);
		n += len ? len : 1;
		len += !len;
	}
	if (n > ROOM) {
		memcpy(line + cut, "...", 3);
		n = cut + 3;
	}
	if (n == 0)
		line[n++] = '?';
	line[n++] = '\n';
	return splice(&g->hist, g->hist ? strlen(g->hist) : 0, 0, line, n);
}
