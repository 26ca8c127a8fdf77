/* test_lhgdamage.c - random changes of a stream of 1 MiB: the first grid that was changed is
 * refused, so no damaged number is accepted in it or in a later grid.
 *
 * The environment variable LHG_CHANGES is the number of trials: 20000 by default, a million in make
 * soak. */
#include <math.h>

#include "../format/lhg.h"
#include "lhgbytes.h"

enum { NU = 33, NV = 31, FRAMES = 64, MOST = 16 };

static uint64_t seed = 1;

static uint32_t
rnd(void)
{
	seed = seed*6364136223846793005u + 1442695040888963407u;
	return (uint32_t)(seed >> 33);
}

/* Adds a smooth channel.  Real channels are smooth too: the bits of neighbouring samples are
 * similar. */
static void
field(Lhg *g, const char *name, int support, int step)
{
	double *f = lhg_add(g, name, "length", support, step);
	size_t k;

	assert_non_null(f);
	for (k = 0; k < g->chan[g->nchan-1].n; k++)
		f[k] = sin(0.01*(double)k + g->frame + g->nchan);
}

static Bytes
stream(int nu, int nv, int frames)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	LhgStream s;
	Lhg g;
	int m;

	lhg_open(&s, f);
	for (m = 1; m <= frames; m++) {
		lhg_init(&g, nu, nv, 0.7);
		g.frame = m;
		g.frames = frames;
		field(&g, "x", LHG_GRID, 0);
		field(&g, "band.x", LHG_BORDER, 3);
		field(&g, "H", LHG_GRID, 0);
		field(&g, "start.x", LHG_LATTICE, 8);
		assert_int_equal(lhg_setmeta(&g, "unit", "mm"), 0);
		assert_int_equal(lhg_note(&g, "mesh2rect face.off"), 0);
		assert_int_equal(lhg_write(&s, &g), 0);
		lhg_free(&g);
	}
	fclose(f);
	return b;
}

/* Records the state of the reader and the position in the file before each frame. */
static void
visit(FILE *f, LhgStream before[], long at[])
{
	LhgStream s;
	Lhg g;
	int m;

	lhg_open(&s, f);
	for (m = 0; m < FRAMES; m++) {
		at[m] = ftell(f);
		before[m] = s;
		assert_int_equal(lhg_read(&s, &g), 1);
		lhg_free(&g);
	}
	at[FRAMES] = ftell(f);
	assert_int_equal(lhg_read(&s, &g), 0);
}

typedef struct Change {
	size_t at;
	char was;
} Change;

/* Changes up to MOST bytes: random bytes, adjacent bytes, or one bit in each of several adjacent
 * bytes.  Returns the number of changes. */
static int
change(Bytes b, Change c[MOST])
{
	const unsigned how = rnd() % 3;
	const int n = 1 + (int)(rnd() % MOST);
	const size_t from = rnd() % b.n;
	int k;

	for (k = 0; k < n; k++) {
		c[k].at = how == 0 ? rnd() % b.n : (from + (size_t)k) % b.n;
		c[k].was = b.p[c[k].at];
		b.p[c[k].at] = (char)(how == 2 ? c[k].was ^ 1 << rnd() % 8 : (int)rnd());
	}
	return n;
}

/* The lowest byte of b that differs from good, or b.n if there is none: a random byte may be equal to
 * the one that it replaces. */
static size_t
first(Bytes b, Bytes good, const Change *c, int n)
{
	size_t low = b.n;
	int k;

	for (k = 0; k < n; k++)
		if (c[k].at < low && b.p[c[k].at] != good.p[c[k].at])
			low = c[k].at;
	return low;
}

static long
changes(void)
{
	const char *n = getenv("LHG_CHANGES");

	return n ? strtol(n, NULL, 10) : 20000;
}

static void
manyframes(void **state)
{
	Bytes b = stream(NU, NV, FRAMES), good = part(b, 0, b.n);
	LhgStream before[FRAMES], s;
	long at[FRAMES + 1], round, damaged = 0;
	FILE *f = fmemopen(b.p, b.n, "rb");
	Change c[MOST];
	size_t low;
	Lhg g;
	int n, m;

	(void)state;
	assert_true(b.n >= 1 << 20);
	visit(f, before, at);
	for (round = 0; round < changes(); round++) {
		n = change(b, c);
		if ((low = first(b, good, c, n)) < b.n) {
			for (m = 0; at[m+1] <= (long)low; m++)
				continue;
			s = before[m];
			assert_int_equal(fseek(f, at[m], SEEK_SET), 0);
			if (lhg_read(&s, &g) >= 0)
				fail_msg("change %ld: frame %d passes with byte %zu changed", round, m + 1, low);
			damaged++;
		}
		while (n-- > 0)
			b.p[c[n].at] = c[n].was;
	}
	print_message("%ld damaged streams of %zu bytes\n", damaged, b.n);
	assert_memory_equal(b.p, good.p, b.n);
	assert_true(damaged > round/2);
	fclose(f);
	free(b.p);
	free(good.p);
}

/* The same with a single grid of 1 MiB and a thousandth of the number of changes. */
static void
onegrid(void **state)
{
	Bytes b = stream(260, 250, 1), good = part(b, 0, b.n);
	FILE *f = fmemopen(b.p, b.n, "rb");
	LhgStream s;
	Change c[MOST];
	long round;
	Lhg g;
	int n;

	(void)state;
	assert_true(b.n >= 1 << 20);
	for (round = 0; round < changes()/1000; round++) {
		n = change(b, c);
		rewind(f);
		lhg_open(&s, f);
		if (first(b, good, c, n) < b.n)
			assert_true(lhg_read(&s, &g) < 0);
		while (n-- > 0)
			b.p[c[n].at] = c[n].was;
	}
	fclose(f);
	free(b.p);
	free(good.p);
}

/* LHG.md, section 8: a change within 32 adjacent bits is always detected.  A small stream is
 * changed at every bit; in make check at every third. */
static void
bursts(void **state)
{
	Bytes b = stream(9, 8, 2);
	FILE *f = fmemopen(b.p, b.n, "rb");
	uint64_t turn;
	size_t bit, k;
	LhgStream s;
	Lhg g;
	int round, e;

	(void)state;
	for (bit = 0; bit + 40 < 8*b.n; bit += changes() < 1000000 ? 3 : 1)
		for (round = 0; round < 4; round++) {
			turn = (uint64_t)(rnd() << 1 | 1) << bit % 8;
			for (k = 0; k < 5; k++)
				b.p[bit/8 + k] ^= (char)(turn >> 8*k);
			rewind(f);
			lhg_open(&s, f);
			while ((e = lhg_read(&s, &g)) == 1)
				lhg_free(&g);
			if (e == 0)
				fail_msg("%llx at bit %zu passes", (unsigned long long)turn, bit);
			for (k = 0; k < 5; k++)
				b.p[bit/8 + k] ^= (char)(turn >> 8*k);
		}
	fclose(f);
	free(b.p);
}

/* A stream cut after any byte is refused; make check tries every 61st byte.  test_lhgcorpus cuts
 * small streams. */
static void
cut(void **state)
{
	Bytes b = stream(64, 48, 1);
	size_t n, step = changes() < 1000000 ? 61 : 1;
	LhgStream s;
	FILE *f;
	Lhg g;

	(void)state;
	for (n = 1; n < b.n; n += step) {
		f = fmemopen(b.p, n, "rb");
		lhg_open(&s, f);
		assert_int_equal(lhg_read(&s, &g), LHG_ESHORT);
		fclose(f);
	}
	free(b.p);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(manyframes), cmocka_unit_test(onegrid), cmocka_unit_test(bursts),
		cmocka_unit_test(cut)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
