/* lhgsample.c - a small stream of two frames with channels of every support, for lhgpy.bats:
 *
 *   lhgsample        writes the stream to stdout
 *   lhgsample check  reads stdin and fails unless it is that stream
 *
 * Sample k of channel c (from 0) in frame m (from 1) is (k^2 - 7)/8 + 100 c + m. */
#include <stdio.h>
#include <string.h>

#include "../format/lhg.h"

enum { NU = 5, NV = 4, FRAMES = 2, CHANNELS = 3 };

static const struct { const char *name, *unit; int support, step; } channel[CHANNELS] = {
	{ "x",       "length",   LHG_GRID,    0 },
	{ "band.H",  "1/length", LHG_BORDER,  1 },
	{ "start.x", "length",   LHG_LATTICE, 2 }
};

static double
value(size_t k, int c, int frame)
{
	return ((double)(k*k) - 7)/8 + 100*c + frame;
}

static int
make(Lhg *g, int frame)
{
	size_t k;
	double *f;
	int c;

	lhg_init(g, NU, NV, 0.1 + 0.2);         /* 0.30000000000000004 */
	g->frame = frame;
	g->frames = FRAMES;
	for (c = 0; c < CHANNELS; c++) {
		if (!(f = lhg_add(g, channel[c].name, channel[c].unit, channel[c].support, channel[c].step)))
			return -1;
		for (k = 0; k < g->chan[c].n; k++)
			f[k] = value(k, c, frame);
	}
	return lhg_setmeta(g, "unit", "mm") || lhg_setmeta(g, "title", "Fl\xc3\xa4""che  2") ||
	    lhg_note(g, "mkmesh --n=20") || lhg_note(g, "mesh2rect -");
}

static int
same(const Lhg *a, const Lhg *b)
{
	int c;

	if (a->nu != b->nu || a->nv != b->nv || a->T != b->T || a->frame != b->frame ||
	    a->frames != b->frames || a->nchan != b->nchan || strcmp(a->meta, b->meta) ||
		strcmp(a->hist, b->hist))
		return 0;
	for (c = 0; c < a->nchan; c++)
		if (strcmp(a->chan[c].name, b->chan[c].name) || strcmp(a->chan[c].unit, b->chan[c].unit) ||
		    a->chan[c].support != b->chan[c].support || a->chan[c].step != b->chan[c].step ||
		    memcmp(a->chan[c].f, b->chan[c].f, a->chan[c].n*sizeof(double)))
			return 0;
	return 1;
}

/* Writes the frame g to s or, if `check`, compares it with the next frame of s.  Frees g.  Returns 0,
 * or nonzero with the reason in s->err. */
static int
frame(LhgStream *s, Lhg *g, int check)
{
	Lhg in;
	int bad;

	if (!check)
		bad = lhg_write(s, g) != 0;
	else if (!(bad = lhg_read(s, &in) != 1)) {
		if ((bad = !same(g, &in)) != 0)
			snprintf(s->err, sizeof s->err, "frame %d is not the sample's", g->frame);
		lhg_free(&in);
	}
	lhg_free(g);
	return bad;
}

int
main(int argc, char *argv[])
{
	int check = argc == 2 && strcmp(argv[1], "check") == 0, m;
	LhgStream s;
	Lhg g;

	if (argc > 1 + check)
		return 2;
	lhg_open(&s, check ? stdin : stdout);
	for (m = 1; m <= FRAMES; m++)
		if (make(&g, m) || frame(&s, &g, check)) {
			fprintf(stderr, "lhgsample: %s\n", s.err);
			return 1;
		}
	if (check && lhg_read(&s, &g) != 0) {
		fprintf(stderr, "lhgsample: more than the sample's frames\n");
		return 1;
	}
	return 0;
}
