/* page.c - the channels of a grid as one picture. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/picture/fieldplot.h"
#include "../shared/chartof.h"
#include "chosen.h"
#include "page.h"

/* A picture of fewer pixels is too small to be seen, and its title would be wider than its map. */
enum { LEAST = 256 };

typedef struct Page {
	const CmdInput *in;
	const Lhg      *g;
	const PageOpt  *o;
	int             n, columns, width, height;      /* of maps; of a row; of each map with its bar */
	const LhgChannel *c[LHG_MAXCHAN];
	FieldPlot       plot[LHG_MAXCHAN];
} Page;

/* "lambda (mm, log), frame 2 of 5": the unit of length is that of the metadatum unit. */
static void
set_title(const Lhg *g, const LhgChannel *c, FieldPlot *p)
{
	char unit[LHG_NAMELEN] = "length", frame[32] = "";
	const char *at = strstr(c->unit, "length");

	lhg_getmeta(g, "unit", unit, sizeof unit);
	if (g->frames > 1)
		snprintf(frame, sizeof frame, ", frame %d of %d", g->frame, g->frames);
	snprintf(p->title, sizeof p->title, "%s (%.*s%s%s%s)%s", c->name, at ? (int)(at - c->unit) : 0, c->unit,
	    at ? unit : c->unit, at ? at + strlen("length") : "", p->scale.log ? ", log" : "", frame);
}

/* The range of the values of c.  H is signed also where it happens to have one sign. */
static void
set_scale(const Page *page, const LhgChannel *c, ColourScale *s)
{
	const PageOpt *o = page->o;
	double *x = cmd_alloc(c->n, sizeof *x), low = c->f[0], high = c->f[0];
	size_t i;

	memcpy(x, c->f, c->n*sizeof *x);
	for (i = 1; i < c->n; i++) {
		low = fmin(low, x[i]);
		high = fmax(high, x[i]);
	}
	s->log = o->log && low > 0;
	if (o->log && !s->log && chosen_by_name(o))
		die("%s: channel %s has values down to %g: no --log", page->in->name, c->name, low);
	if (o->log && !s->log)
		note("%s: channel %s has values down to %g: drawn without --log", page->in->name, c->name, low);
	s->map = o->map >= 0 ? (Colourmap)o->map : !s->log && (strcmp(c->name, "H") == 0 || (low < 0 && high > 0))
	    ? COLOURMAP_DIVERGING : COLOURMAP_VIRIDIS;
	colourscale_fit(s, c->n, x, o->low, o->high);
	free(x);
	if (!(s->low <= s->high))
		die("%s: channel %s: the range of the colours would go from %g down to %g", page->in->name, c->name,
		    s->low, s->high);
	detail("%s: channel %s: colours from %.6g to %.6g, values from %.6g to %.6g", page->in->name, c->name,
	    s->low, s->high, low, high);
}

/* The width of a map: --size, or the least multiple of the number of nodes that is large enough. */
static int
map_width(const Page *page)
{
	const int nu = page->g->nu;

	return page->o->size ? page->o->size : (LEAST + nu - 1)/nu*nu;
}

static void
lay_out(Page *page)
{
	const int w = map_width(page);
	int k, square, h = fieldplot_height(chart_of(page->g), w, &square);

	if (square)
		note("%s: cells are more than 16 times as long as wide (T %g): drawn as squares", page->in->name,
		    page->g->T);
	page->width = page->height = 0;
	for (k = 0; k < page->n; k++) {
		FieldPlot *p = &page->plot[k];

		p->bare = page->o->bare;
		p->axes = page->o->axes;
		set_scale(page, page->c[k], &p->scale);
		set_title(page->g, page->c[k], p);
		fieldplot_layout(p, w, h);
		page->width = p->width > page->width ? p->width : page->width;
		page->height = p->height > page->height ? p->height : page->height;
	}
	page->columns = (int)ceil(sqrt(page->n));
}

/* The field of c on all nodes: NaN outside a border, on a lattice the value of its nearest node. */
static void
fill_field(const Lhg *g, const LhgChannel *c, double *f)
{
	const int across = c->step ? (g->nu - 1)/c->step + 1 : 0, up = c->step ? (g->nv - 1)/c->step + 1 : 0;
	int i, j, a, b;

	for (j = 0; j < g->nv; j++)
		for (i = 0; i < g->nu; i++)
			f[(size_t)j*g->nu + i] = NAN;
	if (c->support != LHG_LATTICE) {
		lhg_scatter(g, c, f);
		return;
	}
	for (j = 0; j < g->nv; j++)
		for (i = 0; i < g->nu; i++) {
			a = (i + c->step/2)/c->step;
			b = (j + c->step/2)/c->step;
			f[(size_t)j*g->nu + i] = c->f[(size_t)(b < up ? b : up - 1)*across + (a < across ? a : across - 1)];
		}
}

void
page_draw(const CmdInput *in, const Lhg *g, const PageOpt *o, Image *m)
{
	Page *page = cmd_alloc(1, sizeof *page);
	double *f;
	int k, w, h, e;

	*page = (Page){ .in = in, .g = g, .o = o };
	page->n = chosen(in, g, o, page->c);
	lay_out(page);
	w = page->width*(page->n < page->columns ? page->n : page->columns);
	h = page->height*((page->n + page->columns - 1)/page->columns);
	if ((e = image_init(m, w, h)) == IMAGE_ELARGE)
		die("%s: a picture of %d x %d pixels is too large: need a smaller --size, or fewer channels", in->name, w, h);
	if (e)
		die("%s: no memory for a picture of %d x %d pixels", in->name, w, h);
	f = cmd_alloc((size_t)g->nu*g->nv, sizeof *f);
	for (k = 0; k < page->n; k++) {
		fill_field(g, page->c[k], f);
		fieldplot_draw(&page->plot[k], chart_of(g), f, m, k%page->columns*page->width,
		    k/page->columns*page->height);
	}
	free(f);
	free(page);
}
