/* test_lhgcorpus.c - the samples of tests/lhg: streams that every version must read with the
 * same content, and streams that every version must refuse, most of them with valid checksums.
 *
 *   test_lhgcorpus              reads them all; run from the top of the repository
 *   test_lhgcorpus write DIR    writes them to DIR/good and DIR/bad, as for tests/lhg
 *   test_lhgcorpus list         prints for each bad sample its name, a tab and its error message
 *
 * Samples of the commands, good/v1-COMMAND.lhg, are written by tests/lhg/commands. */
#include <dirent.h>
#include <float.h>
#include <math.h>

#include "../format/lhg.h"
#include "lhgbytes.h"

enum { FILELEN = 300 };

/* ---- good ------------------------------------------------------------ */

/* Adds a channel: sample k of channel c in frame m is (k^2 - 7)/8 + 100 c + m. */
static void
channel(Lhg *g, const char *name, const char *unit, int support, int step)
{
	double *f = lhg_add(g, name, unit, support, step);
	size_t k;

	assert_non_null(f);
	for (k = 0; k < g->chan[g->nchan-1].n; k++)
		f[k] = ((double)(k*k) - 7)/8 + 100*(g->nchan - 1) + g->frame;
}

static void
smallest(Lhg *g, int m)
{
	(void)m;
	lhg_init(g, 2, 2, 1);
	channel(g, "x", "1", LHG_GRID, 0);
}

static void
supports(Lhg *g, int m)
{
	(void)m;
	lhg_init(g, 5, 4, 0.7);
	channel(g, "all", "length", LHG_GRID, 0);
	channel(g, "b1", "1/length", LHG_BORDER, 1);
	channel(g, "b2", "mm^2*kg", LHG_BORDER, 2);
	channel(g, "b4", "1", LHG_BORDER, 4);
	channel(g, "l1", "1", LHG_LATTICE, 1);
	channel(g, "l2", "1", LHG_LATTICE, 2);
	channel(g, "l3", "1", LHG_LATTICE, 3);
	channel(g, "l4", "1", LHG_LATTICE, 4);
}

/* A set of three frames, a single grid, and a set of two frames. */
static void
sets(Lhg *g, int m)
{
	lhg_init(g, m < 3 ? 4 : 3, m < 4 ? 3 : 2, 0.1 + 0.2);
	g->frame = m < 3 ? m + 1 : m == 3 ? 1 : m - 3;
	g->frames = m < 3 ? 3 : m == 3 ? 1 : 2;
	channel(g, "x", "length", LHG_GRID, 0);
	channel(g, "band.x", "length", LHG_BORDER, 1);
	assert_int_equal(lhg_note(g, m < 3 ? "lhinterp -n 3" : "mkmesh"), 0);
}

static void
thin(Lhg *g, int m)
{
	lhg_init(g, m ? 40 : 2, m ? 2 : 40, 1e-5);
	channel(g, "x", "1", LHG_GRID, 0);
	channel(g, "b", "1", LHG_BORDER, 39);
	channel(g, "l", "1", LHG_LATTICE, 39);
}

static const double number[] = { 0, -0.0, 1, -1, 0.1, 1.0/3, 1 + DBL_EPSILON, DBL_MAX, -DBL_MAX,
	DBL_MIN,
    -DBL_MIN, 5e-324, -5e-324, 2.2250738585072009e-308, 9007199254740993.0, 1e23, 4.35, 3e-310 };

static void
numbers(Lhg *g, int m)
{
	double *f;

	(void)m;
	lhg_init(g, 6, 3, 0.30000000000000004);
	f = lhg_add(g, "x", "1", LHG_GRID, 0);
	memcpy(f, number, sizeof number);
}

static const double height[] = { 1, 0.7, 0.30000000000000004, 1e-5, 0.0001, 1e23, 1e22, 100000,
	1e15, 1e16,
    123456789012345, 5e-324, DBL_MIN, DBL_MAX, 2.0/3, 1.7976931348623155e308 };

static void
heights(Lhg *g, int m)
{
	lhg_init(g, 2, 2, height[m]);
	channel(g, "x", "1", LHG_GRID, 0);
}

static void
channels(Lhg *g, int m)
{
	char name[16];
	int c;

	(void)m;
	lhg_init(g, 2, 2, 1);
	for (c = 0; c < LHG_MAXCHAN; c++) {
		snprintf(name, sizeof name, "c%d", c);
		channel(g, name, "1", LHG_GRID, 0);
	}
}

/* Two surfaces on a sock, and one on a rectangle between them. */
static void
socks(Lhg *g, int m)
{
	lhg_init(g, 6, 4, 0.7);
	g->chart = m == 1 ? LHG_RECTANGLE : LHG_SOCK;
	channel(g, "x", "length", LHG_GRID, 0);
	channel(g, "band.x", "length", LHG_BORDER, 1);
	channel(g, "b5", "1", LHG_BORDER, 5);
}

static void
pillows(Lhg *g, int m)
{
	lhg_init(g, 8, 5, 0.7);
	g->chart = LHG_PILLOW;
	channel(g, m ? "lambda" : "x", "length", LHG_GRID, 0);
	channel(g, "start.x", "length", LHG_GRID, 0);
}

/* The longest names, keys and texts, and all kinds of characters that they may have. */
static void
texts(Lhg *g, int m)
{
	char line[LHG_MAXLINE];

	(void)m;
	lhg_init(g, 2, 2, 1);
	channel(g, "ABCDEFGHIJKLMNOPQRSTUVWXYZ._+-0", "abcdefghijklmnopqrstuvwxyz/^*19", LHG_GRID, 0);
	assert_int_equal(lhg_setmeta(g, "unit", "mm"), 0);
	assert_int_equal(lhg_setmeta(g, "0123456789012345678901234567890123456789012345678901234567890._",
		"x"), 0);
	assert_int_equal(lhg_setmeta(g, "title",
		"Fl\xc3\xa4""che  2 \xe2\x82\xac \xf0\x9f\x98\x80 \"'\\~"), 0);
	memset(line, 'x', sizeof line);
	line[LHG_MAXLINE - strlen("history ")] = '\0';
	assert_int_equal(lhg_note(g, line), 0);
	assert_int_equal(lhg_note(g, "A: mesh2rect -n 4 face.off"), 0);
}

static const struct Good {
	const char *name;
	int grids;
	void (*make)(Lhg *g, int m);
} good[] = {
	{ "v1-smallest", 1, smallest }, { "v1-supports", 1, supports }, { "v1-sets", 6, sets },
	{ "v1-thin", 2, thin }, { "v1-numbers", 1, numbers },
	{ "v1-heights", sizeof height/sizeof *height, heights }, { "v1-channels", 1, channels },
	{ "v1-texts", 1, texts }, { "v2-socks", 3, socks },
	{ "v2-pillows", 2, pillows }
};
enum { GOOD = sizeof good/sizeof *good };

static Bytes
goodbytes(const struct Good *what)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;
	Lhg g;
	int m;

	lhg_open(&s, f);
	for (m = 0; m < what->grids; m++) {
		what->make(&g, m);
		assert_int_equal(lhg_write(&s, &g), 0);
		lhg_free(&g);
	}
	fclose(f);
	return b;
}

/* ---- bad ------------------------------------------------------------- */

/* The functions below damage b, the first three frames of `sets`.  The frames have equal lengths:
 * frame k, counted from 0, begins at byte k n/3. */
static void
replace(Bytes *b, Bytes with)
{
	free(b->p);
	*b = with;
}

static Bytes
frame(Bytes b, int k)
{
	return part(b, (size_t)k*b.n/3, (size_t)(k + 1)*b.n/3);
}

static void
order(Bytes *b, const char *frames)
{
	Bytes all = NONE;

	for (; *frames; frames++)
		all = glue(all, frame(*b, *frames - '1'));
	replace(b, all);
}

/* Positions in the first frame: the 12 samples of x, the end of their block, the 10 samples of
 * band.x, and the end mark. */
enum { SAMPLES = 192, TAIL = SAMPLES + 8*12, BAND = SAMPLES + 128, END = BAND + 128 };

static void cutmagic(Bytes *b) { b->n = 3; }
static void cuthead(Bytes *b) { b->n = 40; }
static void cutsamples(Bytes *b) { b->n = SAMPLES + 20; }
static void cutpadding(Bytes *b) { b->n = TAIL + 10; }
static void cutend(Bytes *b) { b->n = END; }
static void cutinend(Bytes *b) { b->n = END + 63; }
static void cutframe(Bytes *b) { b->n = 2*b->n/3; }
static void empty(Bytes *b) { b->n = 0; }
static void notlhg(Bytes *b) { replace(b, text("solid ascii\n")); }
static void dropped(Bytes *b) { order(b, "13"); }
static void doubled(Bytes *b) { order(b, "1123"); }
static void swapped(Bytes *b) { order(b, "132"); }
static void alone(Bytes *b) { order(b, "2"); }
static void last(Bytes *b) { order(b, "12"); }
static void behind(Bytes *b) { replace(b, glue(part(*b, 0, b->n), text("\n"))); }
static void version3behind(Bytes *b) { replace(b, glue(part(*b, 0, b->n), text("lhg 3\nsize 2 2\n"))); }
static void headbyte(Bytes *b) { b->p[11] ^= 1; }
static void samplebit(Bytes *b) { b->p[SAMPLES + 6] ^= 1; }
static void crcbyte(Bytes *b) { b->p[TAIL] ^= 1; }
static void padding(Bytes *b) { b->p[TAIL + 9] = 1; }
static void endmark(Bytes *b) { b->p[END + 8] &= 0x7f; }
static void inserted(Bytes *b) { replace(b, glue(glue(part(*b, 0, SAMPLES), text("x")),
	part(*b, SAMPLES, b->n))); }
static void unaligned(Bytes *b) { replace(b, glue(text("lhg 1\nend\n"), part(*b, 0, b->n))); }
static void headerof(Bytes *b, const char *lines) { replace(b, headof(lines, strlen(lines), 0)); }

/* The block of x is that of another grid with the same header. */
static void
otherblock(Bytes *b)
{
	static const double f[12] = { 1 };
	Bytes other = gridof(part(*b, 0, SAMPLES), f, 12);

	memcpy(b->p + SAMPLES, other.p + SAMPLES, BAND - SAMPLES);
	free(other.p);
}

static void
othersets(Lhg *g, int m)
{
	sets(g, m);
	g->chan[1].f[0] = 0.5;
}

/* Frame 2 is that of another set with the same sizes, names and history. */
static void
otherframe(Bytes *b)
{
	const struct Good other = { "other", 3, othersets };
	Bytes o = goodbytes(&other);

	memcpy(b->p + b->n/3, o.p + o.n/3, b->n/3);
	free(o.p);
}

static void
blocksswapped(Bytes *b)
{
	Bytes x = part(*b, SAMPLES, BAND), band = part(*b, BAND, END);

	replace(b, glue(glue(part(*b, 0, SAMPLES), glue(band, x)), part(*b, END, b->n)));
}

static void
crlf(Bytes *b)
{
	Bytes t = { malloc(2*b->n), 0 };
	size_t k;

	for (k = 0; k < b->n; k++) {
		if (b->p[k] == '\n')
			t.p[t.n++] = '\r';
		t.p[t.n++] = b->p[k];
	}
	replace(b, t);
}

static void
lf(Bytes *b)
{
	size_t k, n = 0;

	for (k = 0; k < b->n; k++)
		if (b->p[k] != '\r')
			b->p[n++] = b->p[k];
	b->n = n;
}

static void
sevenbits(Bytes *b)
{
	size_t k;

	for (k = 0; k < b->n; k++)
		b->p[k] &= 0x7f;
}

static void
oversize(Bytes *b)
{
	char lines[4000];
	int c, n = snprintf(lines, sizeof lines, "lhg 1\nsize 32768 32768\nheight 1\nframe 1 1 00000000\n");

	for (c = 0; c < LHG_MAXCHAN; c++)
		n += snprintf(lines + n, sizeof lines - (size_t)n, "channel c%d 1 grid\n", c);
	headerof(b, lines);
}

static void
manychannels(Bytes *b)
{
	char lines[4000];
	int c, n = snprintf(lines, sizeof lines, "lhg 1\nsize 2 2\nheight 1\nframe 1 1 00000000\n");

	for (c = 0; c <= LHG_MAXCHAN; c++)
		n += snprintf(lines + n, sizeof lines - (size_t)n, "channel c%d 1 grid\n", c);
	headerof(b, lines);
}

static void
longline(Bytes *b)
{
	char lines[LHG_MAXLINE + 200];
	int n = snprintf(lines, sizeof lines,
		"lhg 1\nsize 2 2\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n");

	snprintf(lines + n, sizeof lines - (size_t)n, "history %0*d\n", LHG_MAXLINE - 7, 0);
	headerof(b, lines);
}

static void
sample(Bytes *b, double x)
{
	const char *lines = "lhg 1\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n";
	double f[20] = { 0 };

	f[7] = x;
	replace(b, gridof(headof(lines, strlen(lines), 0), f, 20));
}

static void samplenan(Bytes *b) { sample(b, NAN); }
static void sampleinf(Bytes *b) { sample(b, -INFINITY); }

#define SIZE(s)    "lhg 1\nsize " s "\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n"
#define HEIGHT(s)  "lhg 1\nsize 5 4\nheight " s "\nframe 1 1 00000000\nchannel x 1 grid\n"
#define FRAME(s)   "lhg 1\nsize 5 4\nheight 1\nframe " s "\nchannel x 1 grid\n"
#define CHANNEL(s) "lhg 1\nsize 5 4\nheight 1\nframe 1 1 00000000\n" s
#define FLAT(size, s) "lhg 1\nsize " size "\nheight 1\nframe 1 1 00000000\n" s "channel x 1 grid\n"
#define SOCK(s)    "lhg 2\nsize 4 5\nheight 1\nframe 1 1 00000000\n" s
#define MORE(s)    CHANNEL("channel x 1 grid\n") s
#define S32        "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"

/* A bad stream: either a header of `lines` with a valid CRC, then 20 samples of 0, their CRC and an
 * end mark; or, if lines is NULL, frames changed by `damage`. */
static const struct Bad {
	const char *name, *lines;
	void (*damage)(Bytes *b);
	const char *message;
} bad[] = {
	{ "empty", NULL, empty, "empty input" },
	{ "not-lhg", NULL, notlhg, "input is not an lhg stream" },
	{ "version-0", "lhg 0\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n", NULL,
	    "input is not version 1 or 2 of lhg" },
	{ "version-3", "lhg 3\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n", NULL,
	    "input is not version 1 or 2 of lhg" },
	{ "version-2-without-chart", SOCK("channel x 1 grid\n"), NULL,
	    "header line 1 is out of place or not in its only spelling" },
	{ "version-1-with-sock", FLAT("4 5", "chart sock\n"), NULL,
	    "header line 1 is out of place or not in its only spelling" },
	{ "chart-rectangle", SOCK("chart rectangle\nchannel x 1 grid\n"), NULL,
	    "header line 5 is malformed" },
	{ "chart-unknown", SOCK("chart glove\nchannel x 1 grid\n"), NULL, "header line 5 is malformed" },
	{ "chart-sock-odd", FLAT("5 4", "chart sock\n"), NULL,
	    "a sock has an even number of nodes along u, not 5" },
	{ "chart-sock-lattice", SOCK("chart sock\nchannel x 1 grid\nchannel y 1 lattice 2\n"), NULL,
	    "the support of channel y does not suit a grid of 4 x 5 nodes" },
	{ "chart-pillow-odd", FLAT("5 4", "chart pillow\n"), NULL,
	    "a pillow has an even number of nodes along u, not 5" },
	{ "chart-pillow-lattice", SOCK("chart pillow\nchannel x 1 grid\nchannel y 1 lattice 2\n"), NULL,
	    "the support of channel y does not suit a grid of 4 x 5 nodes" },
	{ "chart-pillow-border", SOCK("chart pillow\nchannel x 1 grid\nchannel y 1 border 2\n"), NULL,
	    "the support of channel y does not suit a grid of 4 x 5 nodes" },
	{ "order-chart-before-frame",
	    "lhg 2\nsize 4 5\nheight 1\nchart sock\nframe 1 1 00000000\nchannel x 1 grid\n", NULL,
	    "header line 4 is out of place or not in its only spelling" },
	{ "version-10", "lhg 10\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n", NULL,
	    "input is not version 1 or 2 of lhg" },
	{ "cut-in-magic", NULL, cutmagic, "input ends in line 1 of a header" },
	{ "cut-in-header", NULL, cuthead, "input ends in header line 3" },
	{ "cut-in-samples", NULL, cutsamples, "frame 1 of 3: channel x ends at sample 2 of 12" },
	{ "cut-in-padding", NULL, cutpadding, "frame 1 of 3: channel x ends after its samples" },
	{ "cut-before-end-mark", NULL, cutend, "frame 1 of 3: end mark is missing" },
	{ "cut-in-end-mark", NULL, cutinend, "frame 1 of 3: end mark is missing" },
	{ "cut-between-frames", NULL, cutframe, "frame 3 of 3: input ends before it" },
	{ "frame-dropped", NULL, dropped, "frame 2 of 3: frame 3 of 3 comes in its place" },
	{ "frame-doubled", NULL, doubled, "frame 2 of 3: frame 1 of 3 comes in its place" },
	{ "frames-swapped", NULL, swapped, "frame 2 of 3: frame 3 of 3 comes in its place" },
	{ "frame-alone", NULL, alone, "frame 2 of 3: the frames before it are missing" },
	{ "frame-last-missing", NULL, last, "frame 3 of 3: input ends before it" },
	{ "frame-of-another-set", NULL, otherframe,
		"frame 2 of 3: it does not belong to the frame before it" },
	{ "block-of-another-grid", NULL, otherblock, "frame 1 of 3: channel band.x: CRC is wrong" },
	{ "blocks-swapped", NULL, blocksswapped, "frame 1 of 3: channel x: CRC is wrong" },
	{ "bytes-behind", NULL, behind, "frame 3 of 3: bytes follow the end mark" },
	{ "version-3-behind", NULL, version3behind, "frame 3 of 3: bytes follow the end mark" },
	{ "header-byte-changed", NULL, headbyte, "header CRC is wrong" },
	{ "header-not-aligned", NULL, unaligned, "header does not end at a multiple of 64 bytes" },
	{ "sample-bit-changed", NULL, samplebit, "frame 1 of 3: channel x: CRC is wrong" },
	{ "byte-inserted", NULL, inserted, "frame 1 of 3: channel x: CRC is wrong" },
	{ "crc-byte-changed", NULL, crcbyte, "frame 1 of 3: channel x: CRC is wrong" },
	{ "padding-not-zero", NULL, padding, "frame 1 of 3: channel x: padding is not zero" },
	{ "end-mark-changed", NULL, endmark, "frame 1 of 3: end mark is wrong" },
	{ "line-ends-crlf", NULL, crlf, "input is an lhg stream whose line ends were changed" },
	{ "line-ends-lf", NULL, lf, "frame 1 of 3: end mark is wrong" },
	{ "seven-bits", NULL, sevenbits, "frame 1 of 3: channel x: CRC is wrong" },
	{ "sample-nan", NULL, samplenan, "channel x is not finite at sample 7 of 20" },
	{ "sample-infinite", NULL, sampleinf, "channel x is not finite at sample 7 of 20" },
	{ "size-promises-512-gib", NULL, oversize, "channel c0 ends at sample 0 of 1073741824" },
	{ "size-negative", SIZE("-5 4"), NULL, "header line 2 is malformed" },
	{ "size-zero", SIZE("0 4"), NULL, "size is not 2 to 32768 nodes each way" },
	{ "size-one", SIZE("5 1"), NULL, "size is not 2 to 32768 nodes each way" },
	{ "size-32769", SIZE("32769 4"), NULL, "size is not 2 to 32768 nodes each way" },
	{ "size-enormous", SIZE("99999999999999999999999999 4"), NULL,
		"size is not 2 to 32768 nodes each way" },
	{ "size-5-plus-2-to-32", SIZE("4294967301 4"), NULL, "size is not 2 to 32768 nodes each way" },
	{ "size-of-one-number", SIZE("5"), NULL, "header line 2 is malformed" },
	{ "size-leading-zero", SIZE("05 4"), NULL,
		"header line 2 is out of place or not in its only spelling" },
	{ "size-hexadecimal", SIZE("0x5 4"), NULL, "header line 2 is malformed" },
	{ "size-two-spaces", SIZE("5  4"), NULL, "header line 2 is malformed" },
	{ "height-nan", HEIGHT("nan"), NULL, "header line 3 is malformed" },
	{ "height-infinite", HEIGHT("inf"), NULL, "header line 3 is malformed" },
	{ "height-1e999", HEIGHT("1e999"), NULL, "height is not a positive number" },
	{ "height-1e-999", HEIGHT("1e-999"), NULL, "header line 3 is malformed" },
	{ "height-zero", HEIGHT("0"), NULL, "header line 3 is malformed" },
	{ "height-negative", HEIGHT("-1"), NULL, "header line 3 is malformed" },
	{ "height-decimal-comma", HEIGHT("0,5"), NULL, "header line 3 is malformed" },
	{ "height-other-spelling", HEIGHT("1.0"), NULL,
		"header line 3 is out of place or not in its only spelling" },
	{ "height-too-many-digits", HEIGHT("0.69999999999999996"), NULL,
	    "header line 3 is out of place or not in its only spelling" },
	{ "frame-0", FRAME("0 1 00000000"), NULL,
		"frame and number of frames are not 1 <= k <= n <= 1000000" },
	{ "frame-2-of-1", FRAME("2 1 00000000"), NULL,
		"frame and number of frames are not 1 <= k <= n <= 1000000" },
	{ "frames-1000001", FRAME("1 1000001 00000000"), NULL,
	    "frame and number of frames are not 1 <= k <= n <= 1000000" },
	{ "frames-1-plus-2-to-32", FRAME("1 4294967297 00000000"), NULL,
	    "frame and number of frames are not 1 <= k <= n <= 1000000" },
	{ "frame-1-with-a-crc", FRAME("1 1 00000001"), NULL, "frame 1 does not begin with CRC 0" },
	{ "frame-crc-uppercase", FRAME("1 1 0000000A"), NULL, "header line 4 is malformed" },
	{ "channels-none", CHANNEL(""), NULL, "number of channels is not 1 to 64" },
	{ "channels-65", NULL, manychannels, "header line 69: more than 64 channels" },
	{ "channel-twice", MORE("channel x 1 border 1\n"), NULL, "channel x is there twice" },
	{ "channel-without-name", CHANNEL("channel\n"), NULL, "header line 5 is malformed" },
	{ "channel-name-of-32", CHANNEL("channel " S32 " 1 grid\n"), NULL, "header line 5 is malformed" },
	{ "channel-name-slash", CHANNEL("channel a/b 1 grid\n"), NULL,
	    "the name of channel 1 is not 1 to 31 letters, digits or ._+-" },
	{ "channel-name-control", CHANNEL("channel \x1b[2J 1 grid\n"), NULL,
	    "the name of channel 1 is not 1 to 31 letters, digits or ._+-" },
	{ "channel-unit-comma", CHANNEL("channel x a,b grid\n"), NULL,
	    "the unit of channel x is not 1 to 31 letters, digits or ._+-/^*" },
	{ "channel-unknown-support", CHANNEL("channel x 1 cell\n"), NULL, "header line 5 is malformed" },
	{ "channel-border-0", CHANNEL("channel x 1 border 0\n"), NULL,
	    "the support of channel x does not suit a grid of 5 x 4 nodes" },
	{ "channel-border-5-of-5", CHANNEL("channel x 1 border 5\n"), NULL,
	    "the support of channel x does not suit a grid of 5 x 4 nodes" },
	{ "channel-border-1-plus-2-to-32", CHANNEL("channel x 1 border 4294967297\n"), NULL,
	    "the support of channel x does not suit a grid of 5 x 4 nodes" },
	{ "channel-lattice-negative", CHANNEL("channel x 1 lattice -1\n"), NULL,
		"header line 5 is malformed" },
	{ "meta-twice", MORE("meta a b\nmeta a c\n"), NULL, "meta key a is there twice" },
	{ "meta-without-value", MORE("meta a\n"), NULL, "meta line 1 is not a key and a value" },
	{ "meta-key-slash", MORE("meta a/b c\n"), NULL, "meta line 1 is not a key and a value" },
	{ "meta-key-of-64", MORE("meta " S32 S32 " b\n"), NULL, "meta line 1 is not a key and a value" },
	{ "meta-value-ends-in-space", MORE("meta a b \n"), NULL, "meta line 1 is not text, or too long" },
	{ "meta-value-control", MORE("meta a \x1b[2J\n"), NULL, "meta line 1 is not text, or too long" },
	{ "meta-value-c1-control", MORE("meta a \xc2\x9b""2J\n"), NULL,
		"meta line 1 is not text, or too long" },
	{ "meta-value-not-utf8", MORE("meta a \xff\n"), NULL, "meta line 1 is not text, or too long" },
	{ "meta-value-utf8-overlong", MORE("meta a \xc0\xaf\n"), NULL,
		"meta line 1 is not text, or too long" },
	{ "meta-value-surrogate", MORE("meta a \xed\xa0\x80\n"), NULL,
		"meta line 1 is not text, or too long" },
	{ "history-empty", MORE("history \n"), NULL, "history line 1 is not text, or too long" },
	{ "history-tab", MORE("history x\ty\n"), NULL, "history line 1 is not text, or too long" },
	{ "history-line-of-4001", NULL, longline, "history line 1 is not text, or too long" },
	{ "order-height-before-size", "lhg 1\nheight 1\nsize 5 4\nframe 1 1 00000000\nchannel x 1 grid\n",
		NULL,
	    "header line 2 is out of place or not in its only spelling" },
	{ "order-history-before-meta", MORE("history x\nmeta a b\n"), NULL,
	    "header line 6 is out of place or not in its only spelling" },
	{ "order-meta-before-channel", CHANNEL("meta a b\nchannel x 1 grid\n"), NULL,
	    "header line 5 is out of place or not in its only spelling" },
	{ "line-size-twice", "lhg 1\nsize 5 4\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n",
		NULL,
	    "header line 3 is out of place or not in its only spelling" },
	{ "line-height-missing", "lhg 1\nsize 5 4\nframe 1 1 00000000\nchannel x 1 grid\n", NULL,
	    "height is not a positive number" },
	{ "line-unknown", MORE("comment x\n"), NULL, "header line 6 is malformed" },
	{ "line-empty", MORE("\n"), NULL, "header line 6 is malformed" }
};
enum { BAD = sizeof bad/sizeof *bad };

static Bytes
badbytes(const struct Bad *what)
{
	static const double zero[20];
	const struct Good three = { "three", 3, sets };
	Bytes b;

	if (what->lines)
		return gridof(headof(what->lines, strlen(what->lines), 0), zero, 20);
	b = goodbytes(&three);
	what->damage(&b);
	return b;
}

/* ---- files ----------------------------------------------------------- */

static const char *
goodname(int i, char *path, const char *dir)
{
	snprintf(path, FILELEN, "%s/good/%s.lhg", dir, good[i].name);
	return path;
}

static const char *
badname(int i, char *path, const char *dir)
{
	snprintf(path, FILELEN, "%s/bad/%s.lhg", dir, bad[i].name);
	return path;
}

/* Reads a file of less than 8 KiB. */
static Bytes
slurp(const char *path)
{
	Bytes b = { malloc(8192), 0 };
	FILE *f = fopen(path, "rb");

	if (!f)
		fail_msg("%s is missing", path);
	b.n = fread(b.p, 1, 8192, f);
	fclose(f);
	assert_true(b.n < 8192);
	return b;
}

static int
spill(const char *path, Bytes b)
{
	FILE *f = fopen(path, "wb");

	if (!f || fwrite(b.p, 1, b.n, f) != b.n || fclose(f)) {
		perror(path);
		return 1;
	}
	free(b.p);
	return 0;
}

static int
writeall(const char *dir)
{
	char path[FILELEN];
	int i, e = 0;

	for (i = 0; i < GOOD; i++)
		e |= spill(goodname(i, path, dir), goodbytes(&good[i]));
	for (i = 0; i < BAD; i++)
		e |= spill(badname(i, path, dir), badbytes(&bad[i]));
	return e;
}

/* ---- tests ----------------------------------------------------------- */

/* Reads the first n bytes of b.  Returns the last code of lhg_read; err gets the message. */
static int
drain(Bytes b, size_t n, char err[256])
{
	FILE *f = n ? fmemopen(b.p, n, "rb") : fopen("/dev/null", "rb");
	LhgStream s;
	Lhg g;
	int e;

	assert_non_null(f);
	lhg_open(&s, f);
	while ((e = lhg_read(&s, &g)) == 1)
		lhg_free(&g);
	strcpy(err, s.err);
	fclose(f);
	return e;
}

static void
same(const Lhg *a, const Lhg *b)
{
	int c;

	assert_int_equal(a->chart, b->chart);
	assert_true(a->nu == b->nu && a->nv == b->nv && a->frame == b->frame && a->frames == b->frames);
	assert_memory_equal(&a->T, &b->T, sizeof a->T);
	assert_true(!a->meta == !b->meta && (!a->meta || strcmp(a->meta, b->meta) == 0));
	assert_true(!a->hist == !b->hist && (!a->hist || strcmp(a->hist, b->hist) == 0));
	assert_int_equal(a->nchan, b->nchan);
	for (c = 0; c < a->nchan; c++) {
		assert_string_equal(a->chan[c].name, b->chan[c].name);
		assert_string_equal(a->chan[c].unit, b->chan[c].unit);
		assert_true(a->chan[c].support == b->chan[c].support && a->chan[c].step == b->chan[c].step);
		assert_true(a->chan[c].n == b->chan[c].n);
		assert_memory_equal(a->chan[c].f, b->chan[c].f, a->chan[c].n*sizeof(double));
	}
}

/* The reader returns for each good sample the grids from which it was made, and the writer still
 * writes the same bytes. */
static void
good_samples(void **state)
{
	char path[FILELEN];
	Bytes b, again;
	LhgStream s;
	Lhg is, was;
	FILE *f;
	int i, m;

	(void)state;
	for (i = 0; i < GOOD; i++) {
		b = slurp(goodname(i, path, "tests/lhg"));
		f = fmemopen(b.p, b.n, "rb");
		lhg_open(&s, f);
		for (m = 0; m < good[i].grids; m++) {
			if (lhg_read(&s, &is) != 1)
				fail_msg("%s: %s", path, s.err);
			good[i].make(&was, m);
			same(&is, &was);
			lhg_free(&is);
			lhg_free(&was);
		}
		assert_int_equal(lhg_read(&s, &is), 0);
		fclose(f);
		again = goodbytes(&good[i]);
		assert_int_equal(again.n, b.n);
		assert_memory_equal(again.p, b.p, b.n);
		free(again.p);
		free(b.p);
	}
}

static void
bad_samples(void **state)
{
	char path[FILELEN], err[256];
	Bytes b, again;
	int i;

	(void)state;
	for (i = 0; i < BAD; i++) {
		b = slurp(badname(i, path, "tests/lhg"));
		if (drain(b, b.n, err) >= 0 || strcmp(err, bad[i].message) != 0)
			fail_msg("%s: '%s', not '%s'", path, err, bad[i].message);
		again = badbytes(&bad[i]);
		assert_int_equal(again.n, b.n);
		assert_memory_equal(again.p, b.p, b.n);
		free(again.p);
		free(b.p);
	}
}

/* Calls `each` for every file of tests/lhg/good, those of the commands included.  Returns the
 * number of files. */
static int
everygood(void (*each)(const char *path, Bytes b))
{
	DIR *d = opendir("tests/lhg/good");
	struct dirent *e;
	char path[FILELEN];
	Bytes b;
	int n = 0;

	assert_non_null(d);
	while ((e = readdir(d)))
		if (strstr(e->d_name, ".lhg")) {
			snprintf(path, sizeof path, "tests/lhg/good/%.200s", e->d_name);
			b = slurp(path);
			each(path, b);
			free(b.p);
			n++;
		}
	closedir(d);
	return n;
}

static void
copied(const char *path, Bytes b)
{
	FILE *in = fmemopen(b.p, b.n, "rb"), *out;
	Bytes again = NONE;
	LhgStream r, w;
	Lhg g;
	int e;

	out = open_memstream(&again.p, &again.n);
	lhg_open(&r, in);
	lhg_open(&w, out);
	while ((e = lhg_read(&r, &g)) == 1) {
		assert_int_equal(lhg_write(&w, &g), 0);
		lhg_free(&g);
	}
	fclose(in);
	fclose(out);
	if (e || again.n != b.n || memcmp(again.p, b.p, b.n) != 0)
		fail_msg("%s: %s", path, e ? r.err : "not copied byte for byte");
	free(again.p);
}

/* A sample that is cut is refused, unless the cut is after a complete set. */
static void
cut(const char *path, Bytes b)
{
	char err[256];
	size_t n, sets = 0;

	for (n = 0; n < b.n; n++)
		if (drain(b, n, err) >= 0) {
			sets++;
			if (n % 64 || !lhg_magic(b.p + n))
				fail_msg("%s passes, cut to %zu bytes", path, n);
		}
	assert_true(sets < sizeof height/sizeof *height);
}

/* A sample with one bit of one byte flipped is refused. */
static void
turned(const char *path, Bytes b)
{
	char err[256];
	size_t n;

	for (n = 0; n < b.n; n++) {
		b.p[n] ^= (char)(1 << n % 8);
		if (drain(b, b.n, err) >= 0)
			fail_msg("%s passes with byte %zu changed", path, n);
		b.p[n] ^= (char)(1 << n % 8);
	}
}

static void allcopied(void **state) { (void)state; assert_true(everygood(copied) >= GOOD + 5); }
static void allcut(void **state) { (void)state; assert_true(everygood(cut) >= GOOD + 5); }
static void allturned(void **state) { (void)state; assert_true(everygood(turned) >= GOOD + 5); }

int
main(int argc, char *argv[])
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(good_samples), cmocka_unit_test(bad_samples), cmocka_unit_test(allcopied),
		cmocka_unit_test(allcut), cmocka_unit_test(allturned)
	};
	int i;

	if (argc == 3 && strcmp(argv[1], "write") == 0)
		return writeall(argv[2]);
	for (i = 0; argc == 2 && strcmp(argv[1], "list") == 0 && i < BAD; i++)
		printf("%s\t%s\n", bad[i].name, bad[i].message);
	return argc > 1 ? argc > 2 : cmocka_run_group_tests(tests, NULL, NULL);
}
