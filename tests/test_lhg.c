/* test_lhg.c - format/lhg.h: a grid is read back bit for bit; other input is refused. */
#include <locale.h>
#include <math.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../format/lhg.h"
#include "lhgbytes.h"

#if defined(__has_feature)
#if __has_feature(address_sanitizer)
#define SANITIZED 1
#endif
#elif defined(__SANITIZE_ADDRESS__)
#define SANITIZED 1
#endif

/* ---- tools ----------------------------------------------------------- */

static unsigned long long seed = 1;

static unsigned
rnd(void)
{
	seed = seed*6364136223846793005ull + 1442695040888963407ull;
	return (unsigned)(seed >> 33);
}

/* A random finite number of any magnitude; also zeros and subnormal numbers. */
static double
anynumber(void)
{
	uint64_t w;
	double x;

	do {
		w = (uint64_t)rnd() << 40 ^ (uint64_t)rnd() << 20 ^ rnd();
		if (rnd() % 16 == 0)
			w &= 0x8000000000000fffull;
		memcpy(&x, &w, sizeof x);
	} while (!isfinite(x));
	return x;
}

/* A grid with channels of every support, random samples, metadata and history. */
static void
sample(Lhg *g, int nu, int nv, int frame, int frames)
{
	size_t k;
	int c;

	lhg_init(g, nu, nv, 0.7);
	g->frame = frame;
	g->frames = frames;
	assert_non_null(lhg_add(g, "x", "length", LHG_GRID, 0));
	assert_non_null(lhg_add(g, "band.x", "length", LHG_BORDER, 1));
	assert_non_null(lhg_add(g, "H", "1/length", LHG_GRID, 0));
	assert_non_null(lhg_add(g, "start.x", "mm^2*kg", LHG_LATTICE, 2));
	for (c = 0; c < g->nchan; c++)
		for (k = 0; k < g->chan[c].n; k++)
			g->chan[c].f[k] = anynumber();
	assert_int_equal(lhg_setmeta(g, "unit", "mm"), 0);
	assert_int_equal(lhg_setmeta(g, "name", "Gr\xc3\xb6\xc3\x9f""e  2"), 0);
	assert_int_equal(lhg_note(g, "mesh2rect face.off"), 0);
	assert_int_equal(lhg_note(g, "grid2lh"), 0);
}

static void
same(const Lhg *a, const Lhg *b)
{
	int c;

	assert_int_equal(a->chart, b->chart);
	assert_int_equal(a->nu, b->nu);
	assert_int_equal(a->nv, b->nv);
	assert_memory_equal(&a->T, &b->T, sizeof a->T);
	assert_int_equal(a->frame, b->frame);
	assert_int_equal(a->frames, b->frames);
	assert_int_equal(a->nchan, b->nchan);
	assert_string_equal(a->meta, b->meta);
	assert_string_equal(a->hist, b->hist);
	for (c = 0; c < a->nchan; c++) {
		assert_string_equal(a->chan[c].name, b->chan[c].name);
		assert_string_equal(a->chan[c].unit, b->chan[c].unit);
		assert_int_equal(a->chan[c].support, b->chan[c].support);
		assert_int_equal(a->chan[c].step, b->chan[c].step);
		assert_int_equal(a->chan[c].n, b->chan[c].n);
		assert_memory_equal(a->chan[c].f, b->chan[c].f, a->chan[c].n*sizeof(double));
	}
}

/* The bytes of a set of n frames with random samples. */
static Bytes
set(int nu, int nv, int n)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;
	Lhg g;
	int k;

	assert_non_null(f);
	lhg_open(&s, f);
	for (k = 1; k <= n; k++) {
		sample(&g, nu, nv, k, n);
		assert_int_equal(lhg_write(&s, &g), 0);
		lhg_free(&g);
	}
	assert_int_equal(fclose(f), 0);
	return b;
}

typedef struct Result {
	int  code;              /* 0: a complete stream */
	long grids;             /* grids returned before the failure */
	char err[256];
} Result;

/* Reads f to its end.  Checks that after a failure the grid is empty and the message is one line of
 * printable ASCII. */
static Result
drain(FILE *f)
{
	Result r = { 0, 0, "" };
	LhgStream s;
	Lhg g;
	const char *p;

	lhg_open(&s, f);
	while ((r.code = lhg_read(&s, &g)) == 1) {
		r.grids++;
		lhg_free(&g);
	}
	if (r.code) {
		assert_int_equal(g.nchan, 0);
		assert_null(g.meta);
		assert_null(g.hist);
		strcpy(r.err, s.err);
		assert_true(r.err[0]);
		for (p = r.err; *p; p++)
			assert_true(*p >= 0x20 && *p < 0x7f);
	}
	return r;
}

/* Does the same for the bytes b, and frees them. */
static Result
scan(Bytes b)
{
	FILE *f = fmemopen(b.p, b.n, "rb");
	Result r;

	assert_non_null(f);
	r = drain(f);
	fclose(f);
	free(b.p);
	return r;
}

static void
fails(Bytes b, int code, const char *message)
{
	Result r = scan(b);

	assert_string_equal(r.err, message);
	assert_int_equal(r.code, code);
}

/* ---- reading back what was written ----------------------------------- */

static void
roundtrip(void **state)
{
	int nu, nv, k, n;
	Bytes b = NONE;
	Lhg out[3], in;
	LhgStream s;
	FILE *f;

	(void)state;
	for (nu = 2; nu <= 17; nu += 3)
		for (nv = 3; nv <= 8; nv++) {
			n = 1 + (nu + nv) % 3;
			f = open_memstream(&b.p, &b.n);
			lhg_open(&s, f);
			for (k = 0; k < n; k++) {
				sample(&out[k], nu, nv, k + 1, n);
				out[k].T = fabs(anynumber());
				assert_int_equal(lhg_write(&s, &out[k]), 0);
			}
			fclose(f);
			assert_int_equal(b.n % 64, 0);

			f = fmemopen(b.p, b.n, "rb");
			lhg_open(&s, f);
			for (k = 0; k < n; k++) {
				assert_int_equal(lhg_read(&s, &in), 1);
				same(&out[k], &in);
				lhg_free(&in);
				lhg_free(&out[k]);
			}
			assert_int_equal(lhg_read(&s, &in), 0);
			assert_int_equal(lhg_read(&s, &in), 0);
			fclose(f);
			free(b.p);
		}
}

/* The reader reads the samples in blocks, and enlarges its memory from block to block.  A grid of
 * several blocks is accepted if it is intact and refused if it is damaged. */
static void
large(void **state)
{
	Bytes b = set(701, 397, 2);

	(void)state;
	assert_int_equal(scan(part(b, 0, b.n)).code, 0);
	b.p[b.n/4] ^= 1;
	assert_int_equal(scan(b).code, LHG_EDATA);
}

static void
canonical(void **state)
{
	Bytes a = set(5, 4, 3), b = NONE, more = set(4, 6, 1);
	FILE *in, *out = open_memstream(&b.p, &b.n);
	LhgStream r, w;
	Lhg g;

	(void)state;
	a = glue(a, more);
	in = fmemopen(a.p, a.n, "rb");
	lhg_open(&r, in);
	lhg_open(&w, out);
	while (lhg_read(&r, &g) == 1) {
		assert_int_equal(lhg_write(&w, &g), 0);
		lhg_free(&g);
	}
	assert_int_equal(w.grids, 4);
	fclose(in);
	fclose(out);
	assert_int_equal(a.n, b.n);
	assert_memory_equal(a.p, b.p, a.n);
	free(a.p);
	free(b.p);
}

/* The reader accepts a grid whose bytes were made by the rules of LHG.md, without the writer. */
static void
assembled_by_hand(void **state)
{
	static const double f[6] = { 1, -0.0, 0.1, 1e308, 5e-324, -3 };
	const char *lines = "lhg 1\nsize 3 2\nheight 0.30000000000000004\nframe 1 1 00000000\nchannel x 1 grid\n";
	Bytes b = gridof(headof(lines, strlen(lines), 0), f, 6);
	FILE *in = fmemopen(b.p, b.n, "rb");
	LhgStream s;
	Lhg g;

	(void)state;
	lhg_open(&s, in);
	assert_int_equal(lhg_read(&s, &g), 1);
	assert_true(g.nu == 3 && g.nv == 2 && g.T == 0.1 + 0.2 && !g.meta && !g.hist);
	assert_memory_equal(lhg_find(&g, "x")->f, f, sizeof f);
	lhg_free(&g);
	assert_int_equal(lhg_read(&s, &g), 0);
	fclose(in);
	free(b.p);
}

/* In a locale whose decimal point is a comma or has several bytes, the writer writes the same bytes
 * and the reader reads them. */
static void
locales(void **state)
{
	static const char *const name[] = { "de_DE.UTF-8", "ps_AF.UTF-8" };
	unsigned long long start = seed;
	Bytes a = set(3, 3, 1), b;
	int k, tried = 0;

	(void)state;
	for (k = 0; k < 2; k++) {
		if (!setlocale(LC_ALL, name[k]))
			continue;
		tried++;
		seed = start;
		b = set(3, 3, 1);
		assert_int_equal(a.n, b.n);
		assert_memory_equal(a.p, b.p, a.n);
		assert_int_equal(scan(b).code, 0);
	}
	setlocale(LC_ALL, "C");
	free(a.p);
	if (!tried) {
		print_message("no locale with another decimal point here\n");
		skip();
	}
}

/* ---- other input is refused ------------------------------------------ */

static void
truncated(void **state)
{
	Bytes a = set(5, 4, 2), b = set(4, 4, 1), all = join(a, b);
	size_t n, frame = 64;
	Result r;

	(void)state;
	while (memcmp(a.p + frame, "lhg 1\n", 6) != 0)
		frame += 64;
	for (n = 0; n < all.n; n++) {
		r = scan(part(all, 0, n));
		assert_int_equal(r.code, n == 0 ? LHG_EMAGIC : n == a.n ? 0 : LHG_ESHORT);
		/* The reader returns frame 1 before it has seen frame 2.  It returns frame 2 only if
		 * the end or a complete first line follows. */
		assert_int_equal(r.grids, n < frame ? 0 : n != a.n && n < a.n + 6 ? 1 : 2);
	}
	assert_int_equal(scan(all).grids, 3);
	free(a.p);
	free(b.p);
}

static void
changed(void **state)
{
	Bytes b = set(5, 4, 2);
	FILE *f = fmemopen(b.p, b.n, "rb");
	size_t n;
	int x;

	(void)state;
	assert_true(b.n <= 4096);
	for (n = 0; n < b.n; n++)
		for (x = 1; x < 256; x++) {
			b.p[n] ^= (char)x;
			rewind(f);
			assert_true(drain(f).code < 0);
			b.p[n] ^= (char)x;
		}
	rewind(f);
	assert_int_equal(drain(f).code, 0);
	fclose(f);
	free(b.p);
}

static void
insertedordropped(void **state)
{
	Bytes b = set(5, 4, 1);
	size_t n;

	(void)state;
	for (n = 0; n <= b.n; n++)
		assert_true(scan(glue(glue(part(b, 0, n), text(n % 2 ? "\n" : "x")), part(b, n, b.n))).code < 0);
	for (n = 0; n < b.n; n++)
		assert_true(scan(glue(part(b, 0, n), part(b, n + 1, b.n))).code < 0);
	free(b.p);
}

static void
frames(void **state)
{
	Bytes a = set(5, 4, 3), other = set(5, 4, 3), f1, f2, f3, o2;
	size_t n = a.n/3;

	(void)state;
	f1 = part(a, 0, n), f2 = part(a, n, 2*n), f3 = part(a, 2*n, 3*n);
	o2 = part(other, n, 2*n);
	fails(join(f2, f3), LHG_EORDER, "frame 2 of 3: the frames before it are missing");
	fails(glue(join(f1, f3), NONE), LHG_EORDER, "frame 2 of 3: frame 3 of 3 comes in its place");
	fails(glue(join(f1, f1), join(f2, f3)), LHG_EORDER, "frame 2 of 3: frame 1 of 3 comes in its place");
	fails(glue(join(f1, f2), join(f2, f3)), LHG_EORDER, "frame 3 of 3: frame 2 of 3 comes in its place");
	fails(glue(join(f1, f3), part(f2, 0, n)), LHG_EORDER, "frame 2 of 3: frame 3 of 3 comes in its place");
	fails(glue(join(f1, f2), part(f1, 0, n)), LHG_EORDER, "frame 3 of 3: frame 1 of 3 comes in its place");
	fails(join(f1, f2), LHG_ESHORT, "frame 3 of 3: input ends before it");
	fails(glue(join(f1, o2), part(f3, 0, n)), LHG_EORDER,
		"frame 2 of 3: it does not belong to the frame before it");
	fails(glue(part(a, 0, a.n), part(f3, 0, n)), LHG_EORDER,
		"frame 3 of 3: the frames before it are missing");
	fails(glue(part(f1, 0, n), text("frame")), LHG_EDATA,
		"frame 2 of 3: bytes follow the end mark before it");
	assert_int_equal(scan(join(a, other)).grids, 6);
	assert_int_equal(scan(join(a, a)).grids, 6);
	free(a.p), free(other.p), free(f1.p), free(f2.p), free(f3.p), free(o2.p);
}

/* Streams whose blocks are in another order, missing, doubled or of another grid are refused. */
static void
parts(void **state)
{
	Bytes a, b = set(4, 4, 1), c;           /* blocks of 192, 128, 192, 64 bytes */
	size_t h = headlen(b), at = h + 192 + 128;

	(void)state;
	assert_int_equal(b.n, at + 192 + 64 + 64);
	c = glue(part(b, 0, h), part(b, at, at + 192));
	c = glue(c, glue(part(b, h + 192, at), part(b, h, h + 192)));
	fails(glue(c, part(b, at + 192, b.n)), LHG_EDATA, "channel x: CRC is wrong");
	fails(glue(part(b, 0, h), part(b, h + 192, b.n)), LHG_EDATA, "channel x: CRC is wrong");
	fails(glue(part(b, 0, at), part(b, at + 192, b.n)), LHG_ESHORT, "channel H ends after its samples");
	fails(glue(part(b, 0, at), part(b, h, b.n)), LHG_EDATA, "channel H: CRC is wrong");
	fails(glue(part(b, 0, b.n - 128), part(b, b.n - 64, b.n)), LHG_EDATA, "channel start.x: CRC is wrong");
	a = set(4, 4, 1);                       /* same header, different samples */
	assert_memory_equal(a.p, b.p, h);
	fails(glue(part(b, 0, at), part(a, at, a.n)), LHG_EDATA, "channel H: CRC is wrong");
	free(a.p);
	free(b.p);
}

static void
messages(void **state)
{
	Bytes b = set(5, 4, 1), c;
	size_t h = headlen(b);

	(void)state;
	fails(text(""), LHG_EMAGIC, "empty input");
	fails(text("solid ascii"), LHG_EFOREIGN, "input is not an lhg stream");
	fails(text("\x1b[2J"), LHG_EFOREIGN, "input is not an lhg stream");
	fails(text("lhg 3\n"), LHG_EMAGIC, "input is not version 1 or 2 of lhg");
	fails(text("lhg 1\r\n"), LHG_EMAGIC, "input is an lhg stream whose line ends were changed");
	fails(text("lhg 1"), LHG_ESHORT, "input ends in line 1 of a header");
	fails(text("lhg 1\nsize 5 4\nhei"), LHG_ESHORT, "input ends in header line 3");
	fails(part(b, 0, h + 8*3 + 7), LHG_ESHORT, "channel x ends at sample 3 of 20");
	fails(part(b, 0, h), LHG_ESHORT, "channel x ends at sample 0 of 20");
	fails(part(b, 0, h + 160), LHG_ESHORT, "channel x ends after its samples");
	fails(part(b, 0, b.n - 1), LHG_ESHORT, "end mark is missing");
	fails(glue(part(b, 0, b.n), text("\n")), LHG_EDATA, "bytes follow the end mark");
	fails(glue(part(b, 0, b.n), text("lhg 3\n")), LHG_EDATA, "bytes follow the end mark");
	fails(glue(part(b, 0, b.n), text("lhg 1\n")), LHG_ESHORT, "grid 2: input ends in header line 2");
	c = part(b, 0, b.n), c.p[b.n - 20] = 1;
	fails(c, LHG_EDATA, "end mark is wrong");
	c = part(b, 0, b.n), c.p[h + 160 + 4] = 1;
	fails(c, LHG_EDATA, "channel x: padding is not zero");
	c = part(b, 0, b.n), c.p[8] = 'e';
	fails(c, LHG_EHEAD, "header CRC is wrong");
	c = set(5, 4, 2);
	fails(part(c, 0, c.n - 70), LHG_ESHORT, "frame 2 of 2: channel start.x ends after its samples");
	free(c.p);
	free(b.p);
}

#define A    "lhg 1\nsize 5 4\nheight 1\nframe 1 1 00000000\n"
#define B    A "channel x 1 grid\n"
#define SIZE(s)    "lhg 1\nsize " s "\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n"
#define HEIGHT(s)  "lhg 1\nsize 5 4\nheight " s "\nframe 1 1 00000000\nchannel x 1 grid\n"
#define FRAME(s)   "lhg 1\nsize 5 4\nheight 1\nframe " s "\nchannel x 1 grid\n"
#define S32  "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaaaa"
#define C4   "channel a 1 grid\nchannel b 1 grid\nchannel c 1 grid\nchannel d 1 grid\n"

static const char *const malformed[] = {
	SIZE("-1 4"), SIZE("+5 4"), SIZE("05 4"), SIZE("5  4"), SIZE(" 5 4"), SIZE("5 4 "), SIZE("5"),
	SIZE("5 4 3"),
	SIZE("0x5 4"), SIZE("5.0 4"), SIZE(""), SIZE("5,4"), SIZE("5 4\r"),
	HEIGHT("0"), HEIGHT("-1"), HEIGHT("nan"), HEIGHT("inf"), HEIGHT("INFINITY"), HEIGHT("0x1p0"),
	HEIGHT("1.0"),
	HEIGHT("01"), HEIGHT("+1"), HEIGHT("1e0"), HEIGHT("1e+00"), HEIGHT("1."), HEIGHT(".5"), HEIGHT("0.10"),
	HEIGHT("1e-999"), HEIGHT("1 "), HEIGHT("0,5"), HEIGHT("0.1e1"), HEIGHT("1e"), HEIGHT("1e5"),
	HEIGHT("1E+20"),
	HEIGHT("9.999999999999999e+22"), HEIGHT("0.5.5"), HEIGHT("0.69999999999999996"),
	HEIGHT("0.70000000000000001"), HEIGHT(""), HEIGHT("1 1"),
	HEIGHT("1000000000000000000000000000000000000000000000000000000000000000000000000000000"),
	FRAME("1 1 0000000"), FRAME("1 1 000000000"), FRAME("1 1"), FRAME("1 1  00000000"),
	FRAME("01 1 00000000"),
	FRAME("1 1 0000000G"), FRAME("1 1 0x000000"), FRAME("1 1 -0000000"), FRAME("1 1 00000000 "),
	A "channel\n", A "channel x\n", A "channel x 1\n", A "channel x 1 cell\n", A "channel x 1 grid 0\n",
	A "channel x 1 grid 1\n", A "channel x 1 border\n", A "channel x 1 border -1\n",
	A "channel x 1 border 01\n",
	A "channel x 1 border 1 1\n", A "channel x  1 grid\n", A "channel  1 grid\n", A "channel x 1 grid \n",
	A "channel x 1 Grid\n", A "channel " S32 " 1 grid\n", A "channel x " S32 " grid\n",
	A "channels 1000000000\n",
	B "comment x\n", B "\n", B "lhg 1\n", B "size 5 4\n", B "height 1\n", B "frame 1 1 00000000\n",
	B "meta\n", B "history\n",
	B "history x\nmeta a b\n", B "meta a b\nchannel y 1 grid\n", B "meta a b\nhistory x\nmeta c d\n",
	B "Meta a b\n",
	"lhg 1\nheight 1\nsize 5 4\nframe 1 1 00000000\nchannel x 1 grid\n",
	"lhg 1\nsize 5 4\nheight 1\nchannel x 1 grid\nframe 1 1 00000000\n",
	"lhg 1\nsize 5 4\nsize 5 4\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n"
};

static const char *const beyond[] = {
	SIZE("0 4"), SIZE("1 4"), SIZE("5 1"), SIZE("5 0"), SIZE("32769 4"), SIZE("5 32769"),
	SIZE("2147483648 4"),
	SIZE("4294967301 4"), SIZE("18446744073709551621 4"), SIZE("65541 4"),
	SIZE("99999999999999999999999999 4"),
	HEIGHT("1e999"),
	FRAME("0 1 00000000"), FRAME("2 1 00000000"), FRAME("1 0 00000000"), FRAME("1 1000001 00000000"),
	FRAME("4294967297 1 00000000"),
	A, A "meta a b\n",
	A "channel x 1 border 0\n", A "channel x 1 border 5\n", A "channel x 1 border 2147483648\n",
	A "channel x 1 border 4294967297\n", A "channel x 1 lattice 0\n", A "channel x 1 lattice 5\n",
	A "channel x 1 lattice 18446744073709551617\n",
	A "channel a/b 1 grid\n", A "channel x\t 1 grid\n", A "channel x\xc3\xa4 1 grid\n",
	A "channel x a,b grid\n",
	B "channel x 1 grid\n", B "channel y 1 grid\nchannel x 1 border 1\n",
	A C4 "channel a 1 grid\n",
	B "meta a\n", B "meta a \n", B "meta  b\n", B "meta a  b\n", B "meta a b \n", B "meta a\tb c\n",
	B "meta a/b c\n",
	B "meta a b\nmeta a c\n", B "meta a b\nmeta ab c\nmeta a b\n", B "meta " S32 S32 " b\n",
	B "meta a \x01\n", B "meta a b\x7f\n", B "meta a \xff\n", B "meta a \x1b[2J\n", B "meta a b\r\n",
	B "meta a \xc2\x85\n", B "meta a \xc0\xaf\n", B "meta a \xed\xa0\x80\n", B "meta a \xf4\x90\x80\x80\n",
	B "meta a \xe2\x82\n", B "meta a \xe2\x82(\n", B "meta a \x80\n", B "meta a \xf0\x80\x80\x80\n",
	B "history \n", B "history  x\n", B "history x \n", B "history x\ty\n", B "history \xc3\n"
};

static void
badheaders(void **state)
{
	static const double zero[20];
	size_t i;

	(void)state;
	assert_int_equal(scan(gridof(headof(B, strlen(B), 0), zero, 20)).code, 0);
	assert_int_equal(scan(gridof(headof(HEIGHT("0.7"), strlen(HEIGHT("0.7")), 0), zero, 20)).code, 0);
	assert_int_equal(scan(gridof(headof(HEIGHT("1e+23"), strlen(HEIGHT("1e+23")), 0), zero, 20)).code, 0);
	for (i = 0; i < sizeof malformed/sizeof *malformed; i++)
		if (scan(gridof(headof(malformed[i], strlen(malformed[i]), 0), zero, 20)).code != LHG_EHEAD)
			fail_msg("not malformed: %s", malformed[i]);
	for (i = 0; i < sizeof beyond/sizeof *beyond; i++)
		if (scan(gridof(headof(beyond[i], strlen(beyond[i]), 0), zero, 20)).code != LHG_ELIMIT)
			fail_msg("not beyond the limits: %s", beyond[i]);
	fails(gridof(headof(FRAME("1 1 00000001"), strlen(FRAME("1 1 00000001")), 0), zero, 20), LHG_EORDER,
	    "frame 1 does not begin with CRC 0");
}

static void
badends(void **state)
{
	static const double zero[20];
	char h[80];
	Bytes b;
	size_t n;

	(void)state;
	for (n = 1; n <= 130; n++)
		assert_int_equal(scan(gridof(headof(B, strlen(B), n), zero, 20)).code, LHG_EHEAD);
	for (n = 0; n < sizeof B - 1; n++) {    /* a NUL in place of any byte of the lines */
		b = headof(B, strlen(B), 0);
		b.p[n] = '\0';
		sprintf(b.p + b.n - 9, "%08lx", crc32(0, (Bytef *)b.p, (uInt)(b.n - 9)));
		b.p[b.n - 1] = '\n';
		assert_true(scan(gridof(b, zero, 20)).code < 0);
	}
	fails(glue(text("lhg 1\nend\n"), set(3, 3, 1)), LHG_EHEAD,
		"header does not end at a multiple of 64 bytes");
	memset(h, ' ', 64);
	memcpy(h, "lhg 1\nend", 9);
	strcpy(h + 63, "\n");
	fails(text(h), LHG_EHEAD, "header CRC is wrong");
	strcpy(h + 52, "\nendaaaaaaa\n");
	fails(text(h), LHG_EHEAD, "header does not end at a multiple of 64 bytes");
	memcpy(h + 6, "abc", 3);
	h[63] = '\n';
	fails(text(h), LHG_EHEAD, "header CRC is wrong");
	b.p = malloc(70000), b.n = 70000;
	memset(b.p, 'x', b.n);
	memcpy(b.p, "lhg 1\n", 6);
	fails(b, LHG_EHEAD, "header has no end in its first 65536 bytes");
}

/* A line or a header of the greatest length is accepted; with one byte more it is refused. */
static void
longheaders(void **state)
{
	static const double zero[20];
	static char h[80000];
	size_t n, line, k;

	(void)state;
	for (line = 4000; line <= 4001; line++) {
		n = (size_t)sprintf(h, "%shistory ", B);
		memset(h + n, 'x', line - 8);
		strcpy(h + n + line - 8, "\n");
		assert_int_equal(scan(gridof(headof(h, strlen(h), 0), zero, 20)).code, line > 4000 ? LHG_ELIMIT : 0);
	}
	for (line = 65536 - 13; line <= 65536 - 12; line++) {
		n = (size_t)sprintf(h, "%s", B);
		for (k = 0; n < line; k++)
			n += (size_t)sprintf(h + n, "meta %05zu x\n", k);
		n -= n - line < 13 ? 26 : 13;   /* room for the last line */
		n += (size_t)sprintf(h + n, "meta z ");
		memset(h + n, 'x', line - n - 1);
		h[line - 1] = '\n';
		assert_int_equal(scan(gridof(headof(h, line, 0), zero, 20)).code, line > 65536 - 13 ? LHG_EHEAD : 0);
	}
}

static void
manychannels(void **state)
{
	static char h[8000];
	int n, k;

	(void)state;
	n = sprintf(h, "%s", A);
	for (k = 0; k < 65; k++)
		n += sprintf(h + n, "channel c%d 1 grid\n", k);
	fails(headof(h, (size_t)n, 0), LHG_ELIMIT, "header line 69: more than 64 channels");
}

static void
badsamples(void **state)
{
	static const uint64_t bits[] = { 0x7ff8000000000000, 0xfff8000000000001, 0x7ff0000000000000,
	    0xfff0000000000000, 0x7ff0000000000001 };
	static double many[150*100];
	const char *lines = "lhg 1\nsize 150 100\nheight 1\nframe 1 1 00000000\nchannel x 1 grid\n";
	double f[20] = { 0 };
	size_t i;

	(void)state;
	many[9000] = NAN;
	fails(gridof(headof(lines, strlen(lines), 0), many, 15000), LHG_EVALUE,
		"channel x is not finite at sample 9000 of 15000");
	many[5000] = NAN;
	fails(gridof(headof(lines, strlen(lines), 0), many, 15000), LHG_EVALUE,
		"channel x is not finite at sample 5000 of 15000");
	for (i = 0; i < 5; i++) {
		memcpy(&f[7], &bits[i], 8);
		fails(gridof(headof(B, strlen(B), 0), f, 20), LHG_EVALUE,
			"channel x is not finite at sample 7 of 20");
	}
}

/* A short stream whose header claims 64 channels of 8 GiB each is refused without allocating
 * them. */
static void
promises(void **state)
{
	static char h[8000];
	struct rlimit limit = { 1 << 28, 1 << 28 };
	int n, k, status;
	pid_t child;

	(void)state;
	n = sprintf(h, "%s", "lhg 1\nsize 32768 32768\nheight 1\nframe 1 1000000 00000000\n");
	for (k = 0; k < 64; k++)
		n += sprintf(h + n, "channel c%d 1 grid\n", k);
	fails(headof(h, (size_t)n, 0), LHG_ESHORT,
		"frame 1 of 1000000: channel c0 ends at sample 0 of 1073741824");
#ifndef SANITIZED
	if ((child = fork()) == 0) {
		setrlimit(RLIMIT_AS, &limit);
		_exit(scan(headof(h, (size_t)n, 0)).code == LHG_ESHORT ? 0 : 1);
	}
	assert_true(child > 0 && waitpid(child, &status, 0) == child && status == 0);
#else
	(void)limit, (void)status, (void)child;
#endif
}

/* ---- what the writer refuses ----------------------------------------- */

/* Checks that lhg_write(g) returns code and writes no byte; frees g. */
static void
unwritten(Lhg *g, int code)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;

	lhg_open(&s, f);
	assert_int_equal(lhg_write(&s, g), code);
	assert_true(s.err[0]);
	assert_int_equal(s.grids, 0);
	fclose(f);
	assert_int_equal(b.n, 0);
	free(b.p);
	g->chan[0].n = 20;
	lhg_free(g);
}

static void
badgrids(void **state)
{
	Lhg g;
	char line[3000];
	int k;

	(void)state;
	sample(&g, 5, 4, 1, 1), g.nu = 1, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.nv = 32769, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.T = 0, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.chart = LHG_PILLOW + 1, unwritten(&g, LHG_ELIMIT);
	sample(&g, 4, 4, 1, 1), g.chart = LHG_SOCK, unwritten(&g, LHG_ELIMIT);      /* start.x is a lattice */
	sample(&g, 5, 4, 1, 1), g.T = NAN, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.T = INFINITY, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 2, 3), unwritten(&g, LHG_EORDER);
	sample(&g, 5, 4, 2, 1), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1000001), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.chan[0].f[19] = NAN, unwritten(&g, LHG_EVALUE);
	sample(&g, 5, 4, 1, 1), g.chan[3].f[0] = -INFINITY, unwritten(&g, LHG_EVALUE);
	sample(&g, 5, 4, 1, 1), g.chan[0].n = 19, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.chan[1].step = 2, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.chan[1].support = 3, unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), strcpy(g.chan[2].name, "x"), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), strcpy(g.chan[2].name, "x\ny"), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), memset(g.chan[2].unit, 'x', LHG_NAMELEN), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.meta[0] = '\n', unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1), g.hist[strlen(g.hist) - 1] = 'x', unwritten(&g, LHG_ELIMIT);
	lhg_init(&g, 5, 4, 1), unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1);
	memset(line, 'x', sizeof line - 1);
	line[sizeof line - 1] = '\0';
	for (k = 0; k < 22; k++)
		assert_int_equal(lhg_note(&g, line), 0);
	unwritten(&g, LHG_ELIMIT);
	sample(&g, 5, 4, 1, 1);
	for (k = 0; k < 40; k++)
		assert_int_equal(lhg_note(&g, line), 0);
	unwritten(&g, LHG_ELIMIT);
}

/* Line 1 that is written early must be that of the grid that follows. */
static void
begunversion(void **state)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;
	Lhg g;

	(void)state;
	lhg_open(&s, f);
	sample(&g, 4, 3, 1, 1);
	assert_int_equal(lhg_write(&s, &g), 0);
	assert_int_equal(lhg_begin_next(&s, 2), 0);
	assert_int_equal(lhg_write(&s, &g), LHG_EORDER);
	lhg_drop(&g, "start.x");
	lhg_drop(&g, "band.x");
	g.chart = LHG_SOCK;
	assert_int_equal(lhg_write(&s, &g), 0);
	lhg_free(&g);
	fclose(f);
	assert_int_equal(scan(b).grids, 2);
}

static void
writeorder(void **state)
{
	static const int frame[][2] = { { 1, 2 }, { 3, 2 }, { 1, 2 }, { 2, 3 }, { 2, 2 }, { 2, 2 }, { 1, 1 } };
	static const int code[] = { 0, LHG_ELIMIT, LHG_EORDER, LHG_EORDER, 0, LHG_EORDER, 0 };
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;
	Lhg g;
	size_t k;

	(void)state;
	lhg_open(&s, f);
	for (k = 0; k < sizeof code/sizeof *code; k++) {
		sample(&g, 3, 3, frame[k][0], frame[k][1]);
		assert_int_equal(lhg_write(&s, &g), code[k]);
		lhg_free(&g);
	}
	fclose(f);
	assert_int_equal(scan(b).grids, 3);
}

static void
brokenfiles(void **state)
{
	char small[100];
	FILE *f;
	LhgStream s;
	Lhg g;

	(void)state;
	sample(&g, 65, 65, 1, 1);
	f = fmemopen(small, sizeof small, "wb");
	lhg_open(&s, f);
	assert_int_equal(lhg_write(&s, &g), LHG_EIO);
	assert_memory_equal(s.err, "write: ", 7);       /* the system gives no reason in this case */
	fclose(f);
	lhg_free(&g);
	sample(&g, 3, 3, 1, 1);                 /* fits the buffer, so only flushing fails */
	if ((f = fopen("/dev/full", "wb"))) {
		lhg_open(&s, f);
		assert_int_equal(lhg_write(&s, &g), LHG_EIO);
		assert_string_equal(s.err, "write: No space left on device");
		fclose(f);
	}
	lhg_free(&g);
	f = fopen(".", "rb");
	assert_non_null(f);
	lhg_open(&s, f);
	assert_int_equal(lhg_read(&s, &g), LHG_EIO);
	assert_string_equal(s.err, "read: Is a directory");
	fclose(f);
}

/* ---- grids in memory ------------------------------------------------- */

static int
covers(const Lhg *g, int support, int step, int i, int j)
{
	if (support == LHG_BORDER && g->chart == LHG_SOCK)
		return j >= g->nv - step;
	if (support == LHG_BORDER)
		return i < step || j < step || i >= g->nu - step || j >= g->nv - step;
	if (support == LHG_LATTICE)
		return i % step == 0 && j % step == 0;
	return 1;
}

/* Compares lhg_gather and lhg_scatter with the definition of the support: the nodes it covers, in
 * row order. */
static void
checksupport(int chart, int nu, int nv, int support, int step)
{
	double f[100], back[100], *c;
	size_t n = 0;
	int p;
	Lhg g;

	lhg_init(&g, nu, nv, 1);
	g.chart = chart;
	c = lhg_add(&g, "c", "1", support, step);
	assert_non_null(c);
	for (p = 0; p < nu*nv; p++)
		f[p] = p, back[p] = -1;
	lhg_gather(&g, &g.chan[0], f);
	lhg_scatter(&g, &g.chan[0], back);
	for (p = 0; p < nu*nv; p++)
		if (covers(&g, support, step, p % nu, p / nu)) {
			assert_true(n < g.chan[0].n && c[n++] == p);
			assert_true(back[p] == p);
		} else
			assert_true(back[p] == -1);
	assert_int_equal(n, g.chan[0].n);
	assert_int_equal(n, lhg_count(&g, support, step));
	lhg_free(&g);
}

static size_t
count(int chart, int nu, int nv, int support, int step)
{
	Lhg g = { .nu = nu, .nv = nv, .chart = chart };

	return lhg_count(&g, support, step);
}

static void
supports(void **state)
{
	int nu, nv, step;

	(void)state;
	for (nu = 2; nu <= 10; nu++)
		for (nv = 2; nv <= 10; nv++) {
			checksupport(LHG_RECTANGLE, nu, nv, LHG_GRID, 0);
			checksupport(LHG_SOCK, nu, nv, LHG_GRID, 0);
			checksupport(LHG_PILLOW, nu, nv, LHG_GRID, 0);
			assert_int_equal(count(LHG_RECTANGLE, nu, nv, LHG_GRID, 1), 0);
			for (step = 1; step < (nu > nv ? nu : nv); step++) {
				checksupport(LHG_RECTANGLE, nu, nv, LHG_BORDER, step);
				checksupport(LHG_SOCK, nu, nv, LHG_BORDER, step);
				checksupport(LHG_RECTANGLE, nu, nv, LHG_LATTICE, step);
				assert_int_equal(count(LHG_PILLOW, nu, nv, LHG_LATTICE, step), 0);
				assert_int_equal(count(LHG_SOCK, nu, nv, LHG_LATTICE, step), 0);
				assert_int_equal(count(LHG_PILLOW, nu, nv, LHG_BORDER, step), 0);
			}
			for (step = -1; step <= 0; step++) {
				assert_int_equal(count(LHG_RECTANGLE, nu, nv, LHG_BORDER, step), 0);
				assert_int_equal(count(LHG_RECTANGLE, nu, nv, LHG_LATTICE, step), 0);
			}
			assert_int_equal(count(LHG_RECTANGLE, nu, nv, LHG_BORDER, nu > nv ? nu : nv), 0);
			assert_int_equal(count(LHG_RECTANGLE, nu, nv, LHG_LATTICE, nu > nv ? nu : nv), 0);
		}
	assert_int_equal(count(LHG_RECTANGLE, 32768, 32768, LHG_GRID, 0), (size_t)1 << 30);
	assert_int_equal(count(LHG_RECTANGLE, 32768, 32768, LHG_BORDER, 32767), (size_t)1 << 30);
	assert_int_equal(count(LHG_RECTANGLE, 32768, 32768, LHG_LATTICE, 32767), 4);
	assert_int_equal(count(LHG_RECTANGLE, 32769, 4, LHG_GRID, 0) + count(LHG_RECTANGLE, 4, 1, LHG_GRID, 0), 0);
}

static void
channels(void **state)
{
	char name[16];
	Lhg g;
	int k;

	(void)state;
	lhg_init(&g, 3, 3, 1);
	assert_null(lhg_add(&g, "", "1", LHG_GRID, 0));
	assert_null(lhg_add(&g, "a b", "1", LHG_GRID, 0));
	assert_null(lhg_add(&g, "a/b", "1", LHG_GRID, 0));
	assert_null(lhg_add(&g, S32, "1", LHG_GRID, 0));
	assert_null(lhg_add(&g, "a", "", LHG_GRID, 0));
	assert_null(lhg_add(&g, "a", "1", LHG_BORDER, 3));
	assert_non_null(lhg_add(&g, &S32[1], "kg*m^2/s", LHG_GRID, 0));
	for (k = 1; k < LHG_MAXCHAN; k++) {
		sprintf(name, "c%d", k);
		assert_non_null(lhg_add(&g, name, "1", LHG_LATTICE, 1));
		assert_null(lhg_add(&g, name, "1", LHG_LATTICE, 1));
	}
	assert_null(lhg_add(&g, "more", "1", LHG_GRID, 0));
	lhg_find(&g, "c63")->f[8] = 3;
	lhg_drop(&g, "c1");
	lhg_drop(&g, "c1");
	lhg_drop(&g, "c62");
	assert_int_equal(g.nchan, LHG_MAXCHAN - 2);
	assert_null(lhg_find(&g, "c1"));
	assert_true(lhg_find(&g, "c63")->f[8] == 3);
	lhg_free(&g);
	lhg_free(&g);
	assert_null(lhg_find(&g, "c2"));
}

static void
metadata(void **state)
{
	static char big[LHG_MAXLINE];
	char v[8];
	Lhg g;

	(void)state;
	lhg_init(&g, 3, 3, 1);
	assert_null(lhg_getmeta(&g, "a", v, sizeof v));
	assert_int_equal(lhg_setmeta(&g, "a", NULL), 0);
	assert_int_equal(lhg_setmeta(&g, "a", "1"), 0);
	assert_int_equal(lhg_setmeta(&g, "ab", "2  3"), 0);
	assert_int_equal(lhg_setmeta(&g, "b", "4"), 0);
	assert_int_equal(lhg_setmeta(&g, "ab", "long value"), 0);
	assert_string_equal(g.meta, "a 1\nab long value\nb 4\n");
	assert_string_equal(lhg_getmeta(&g, "ab", v, sizeof v), "long va");
	assert_string_equal(lhg_getmeta(&g, "b", v, sizeof v), "4");
	assert_null(lhg_getmeta(&g, "long", v, sizeof v));
	assert_null(lhg_getmeta(&g, "b", v, 0));
	assert_int_equal(lhg_setmeta(&g, "", "x"), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, "a b", "x"), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, S32 S32, "x"), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, "a", ""), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, "a", " x"), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, "a", "x\ny"), LHG_ELIMIT);
	assert_int_equal(lhg_setmeta(&g, "a", "\xff"), LHG_ELIMIT);
	memset(big, 'x', sizeof big - 1);
	assert_int_equal(lhg_setmeta(&g, "a", big), LHG_ELIMIT);
	assert_string_equal(g.meta, "a 1\nab long value\nb 4\n");
	assert_int_equal(lhg_setmeta(&g, "ab", NULL), 0);
	assert_int_equal(lhg_setmeta(&g, "b", NULL), 0);
	assert_string_equal(g.meta, "a 1\n");
	assert_int_equal(lhg_setmeta(&g, "abc", "2"), 0);
	assert_null(lhg_getmeta(&g, "ab", v, sizeof v));
	assert_int_equal(lhg_setmeta(&g, "abc", NULL), 0);
	big[LHG_MAXLINE - 7] = '\0';
	assert_int_equal(lhg_setmeta(&g, "a", big), 0);
	assert_int_equal(lhg_setmeta(&g, "a", NULL), 0);
	assert_null(g.meta);
	lhg_free(&g);
}

/* lhg_note makes every text valid, so that it can be written and read. */
static void
history(void **state)
{
	static char big[2*LHG_MAXLINE];
	size_t n, k;
	Lhg g;

	(void)state;
	sample(&g, 3, 3, 1, 1);
	free(g.hist), g.hist = NULL;
	assert_int_equal(lhg_note(&g, "  a\tb\n\x1b[2J \xff\xc2\x85 "), 0);
	assert_int_equal(lhg_note(&g, ""), 0);
	assert_int_equal(lhg_note(&g, "caf\xc3\xa9"), 0);
	assert_string_equal(g.hist, "a?b??[2J ???\n?\ncaf\xc3\xa9\n");
	for (n = 3980; n < 4005; n++) {
		Bytes b = NONE;
		FILE *f = open_memstream(&b.p, &b.n);
		LhgStream s;

		strcpy(big, &"xx"[2 - n % 3]);
		for (k = n % 3; k < n; k += 3)
			strcpy(big + k, "\xe2\x82\xac");
		assert_int_equal(strlen(big), n);
		free(g.hist), g.hist = NULL;
		assert_int_equal(lhg_note(&g, big), 0);
		assert_true((strcmp(g.hist + strlen(g.hist) - 4, "...\n") == 0) == (n > 3992));
		assert_true(strlen(g.hist) > (n > 3992 ? 3992 - 3 : n));
		lhg_open(&s, f);
		assert_int_equal(lhg_write(&s, &g), 0);
		fclose(f);
		assert_int_equal(scan(b).code, 0);
	}
	lhg_free(&g);
}

/* Random bytes of a larger stream are changed.  The reader must not crash, and must refuse the stream
 * if a single byte was changed. */
static void
noise(void **state)
{
	Bytes b = set(33, 17, 3);
	FILE *f = fmemopen(b.p, b.n, "rb");
	char old[8];
	size_t at[8], k, n;
	int round;

	(void)state;
	for (round = 0; round < 20000; round++) {
		n = 1 + rnd() % 8;
		for (k = 0; k < n; k++) {
			at[k] = rnd() % b.n;
			old[k] = b.p[at[k]];
			b.p[at[k]] = (char)(rnd() % 255 + 1 + (unsigned char)old[k]);
		}
		rewind(f);
		if (n == 1)
			assert_true(drain(f).code < 0);
		else
			drain(f);
		while (k-- > 0)
			b.p[at[k]] = old[k];
	}
	fclose(f);
	assert_int_equal(scan(b).grids, 3);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(roundtrip), cmocka_unit_test(large), cmocka_unit_test(canonical),
		cmocka_unit_test(assembled_by_hand), cmocka_unit_test(locales), cmocka_unit_test(begunversion), cmocka_unit_test(truncated),
		cmocka_unit_test(changed), cmocka_unit_test(insertedordropped), cmocka_unit_test(frames),
		cmocka_unit_test(parts), cmocka_unit_test(messages), cmocka_unit_test(badheaders),
		cmocka_unit_test(badends), cmocka_unit_test(longheaders), cmocka_unit_test(manychannels),
		cmocka_unit_test(badsamples), cmocka_unit_test(promises), cmocka_unit_test(badgrids),
		cmocka_unit_test(writeorder), cmocka_unit_test(brokenfiles), cmocka_unit_test(supports),
		cmocka_unit_test(channels), cmocka_unit_test(metadata), cmocka_unit_test(history),
		cmocka_unit_test(noise)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
