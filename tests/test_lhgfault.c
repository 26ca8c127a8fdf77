/* test_lhgfault.c - format/lhg.h under system failures: each allocation, read and write fails in
 * turn, signals interrupt reading, and transfers are as short as one byte. */
#define _GNU_SOURCE             /* for fopencookie */
#include <errno.h>

#include "../format/lhg.h"
#include "lhgbytes.h"

/* ---- memory ---------------------------------------------------------- */

/* The linker option --wrap redirects the calls of the library to these functions.  left counts down
 * to the call that fails; if it is 0, none fails.  held is the number of blocks not yet freed. */
static long left, held;

void *__real_malloc(size_t n);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t n);
void __real_free(void *p);
void *__wrap_malloc(size_t n);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t n);
void __wrap_free(void *p);

static int
fails(void)
{
	return left > 0 && --left == 0;
}

static void *
took(void *p)
{
	held += p != NULL;
	return p;
}

void *
__wrap_malloc(size_t n)
{
	return fails() ? NULL : took(__real_malloc(n));
}

void *
__wrap_calloc(size_t n, size_t size)
{
	return fails() ? NULL : took(__real_calloc(n, size));
}

void *
__wrap_realloc(void *p, size_t n)
{
	if (fails())
		return NULL;
	held -= p != NULL;
	return took(__real_realloc(p, n));
}

void
__wrap_free(void *p)
{
	held -= p != NULL;
	__real_free(p);
}

/* ---- streams --------------------------------------------------------- */

/* A file that fails at call number `turn` with errno = code; a read returns at most `most`
 * bytes. */
typedef struct Device {
	Bytes  b;               /* reading: the file; writing: the bytes written so far */
	size_t at, most;
	long   turn;
	int    code;
} Device;

static ssize_t
give(void *cookie, char *to, size_t n)
{
	Device *d = cookie;

	if (d->turn > 0 && --d->turn == 0) {
		errno = d->code;
		return -1;
	}
	n = n < d->most ? n : d->most;
	n = n < d->b.n - d->at ? n : d->b.n - d->at;
	memcpy(to, d->b.p + d->at, n);
	d->at += n;
	return (ssize_t)n;
}

/* The write function of fopencookie must return 0, not -1, for an error. */
static ssize_t
take(void *cookie, const char *from, size_t n)
{
	Device *d = cookie;

	if (d->turn > 0 && --d->turn == 0) {
		errno = d->code;
		return 0;
	}
	assert_true(d->at + n <= d->b.n);
	memcpy(d->b.p + d->at, from, n);
	d->at += n;
	return (ssize_t)n;
}

static FILE *
device(Device *d, const char *mode, int buffered)
{
	const cookie_io_functions_t io = { .read = give, .write = take };
	FILE *f = fopencookie(d, mode, io);

	assert_non_null(f);
	if (!buffered)
		setvbuf(f, NULL, _IONBF, 0);
	return f;
}

/* Frame m of a set of two, with n x n nodes. */
static void
frame(Lhg *g, int n, int m)
{
	lhg_init(g, n, n, 0.7);
	g->frame = m;
	g->frames = 2;
	assert_non_null(lhg_add(g, "x", "1", LHG_GRID, 0));
	assert_non_null(lhg_add(g, "b", "1", LHG_BORDER, 1));
	assert_int_equal(lhg_setmeta(g, "unit", "mm"), 0);
	assert_int_equal(lhg_note(g, "mkmesh"), 0);
	assert_int_equal(lhg_note(g, "grid2lh"), 0);
}

static int
writeset(FILE *f, int n, char err[256])
{
	LhgStream s;
	Lhg g;
	int m, e = 0;

	lhg_open(&s, f);
	for (m = 1; !e && m <= 2; m++) {
		frame(&g, n, m);
		e = lhg_write(&s, &g);
		lhg_free(&g);
	}
	strcpy(err, s.err);
	return e;
}

static Bytes
set(int n)
{
	Bytes b = NONE;
	FILE *f = open_memstream(&b.p, &b.n);
	char err[256];

	assert_int_equal(writeset(f, n, err), 0);
	fclose(f);
	return b;
}

/* Reads f to its end and returns the last code of lhg_read.  Checks that the grid is empty after a
 * failure. */
static int
readset(FILE *f, char err[256])
{
	LhgStream s;
	Lhg g;
	int e;

	lhg_open(&s, f);
	while ((e = lhg_read(&s, &g)) == 1)
		lhg_free(&g);
	if (e < 0)
		assert_true(g.nchan == 0 && !g.meta && !g.hist);
	strcpy(err, s.err);
	return e;
}

/* ---- tests ----------------------------------------------------------- */

/* Each allocation of the reader fails in turn: the reader reports the failure and frees everything.
 * With 400 x 400 nodes the buffer of the samples has to grow. */
static void
readnomemory(void **state)
{
	Bytes b = set(400);
	FILE *f = fmemopen(b.p, b.n, "rb");
	char err[256];
	long k, before = held;
	int e;

	(void)state;
	for (k = 1;; k++) {
		rewind(f);
		left = k;
		e = readset(f, err);
		assert_int_equal(held, before);
		if (left > 0)
			break;
		assert_int_equal(e, LHG_ENOMEM);
		assert_non_null(strstr(err, "no memory for the "));
	}
	left = 0;
	assert_int_equal(e, 0);
	assert_true(k > 12);            /* six or more in each frame */
	fclose(f);
	free(b.p);
}

/* If an allocation fails in a function that changes a grid, the grid is unchanged. */
static void
changenomemory(void **state)
{
	const long before = held;
	Lhg g;

	(void)state;
	frame(&g, 3, 1);
	left = 1;
	assert_null(lhg_add(&g, "y", "1", LHG_GRID, 0));
	assert_int_equal(g.nchan, 2);
	left = 1;
	assert_int_equal(lhg_setmeta(&g, "unit", "inch"), LHG_ENOMEM);
	left = 1;
	assert_int_equal(lhg_setmeta(&g, "more", "1"), LHG_ENOMEM);
	assert_string_equal(g.meta, "unit mm\n");
	left = 1;
	assert_int_equal(lhg_note(&g, "lhfft"), LHG_ENOMEM);
	assert_string_equal(g.hist, "mkmesh\ngrid2lh\n");
	assert_int_equal(left, 0);
	lhg_free(&g);
	assert_int_equal(held, before);
}

/* Reads b repeatedly, with call k failing for k = 1, 2, .., and checks the code and the message.
 * Returns the first k for which no call failed. */
static long
readwith(Bytes b, size_t most, int code, int want, const char *message, int buffered)
{
	Device d = { .b = b, .most = most, .code = code };
	char err[256];
	long k;
	FILE *f;
	int e;

	for (k = 1;; k++) {
		d.at = 0;
		d.turn = k;
		f = device(&d, "rb", buffered);
		e = readset(f, err);
		fclose(f);
		if (d.turn > 0)
			break;
		assert_int_equal(e, want);
		if (want && !strstr(err, message))
			fail_msg("call %ld: %s", k, err);
	}
	assert_int_equal(e, 0);
	return k;
}

static void
readfails(void **state)
{
	Bytes b = set(5);

	(void)state;
	assert_true(readwith(b, b.n, EIO, LHG_EIO, "read: Input/output error", 0) > 12);
	assert_true(readwith(b, 1, EIO, LHG_EIO, "read: Input/output error", 0) > (long)b.n);
	assert_true(readwith(b, 100, EISDIR, LHG_EIO, "read: Is a directory", 1) > 3);
	assert_true(readwith(b, 7, EINTR, 0, "", 0) > 12);
	free(b.p);
}

/* Does the same for writing.  After a failed call the output must be shorter than the stream, so that
 * its end mark is missing.  If no call fails, it must be the complete stream. */
static long
writewith(Bytes good, int code, const char *message, int buffered)
{
	Device d = { .b = { calloc(good.n, 1), good.n }, .code = code };
	char err[256];
	long k;
	FILE *f;
	int e;

	for (k = 1;; k++) {
		d.at = 0;
		d.turn = k;
		f = device(&d, "wb", buffered);
		e = writeset(f, 5, err);
		if (d.turn > 0)
			break;
		fclose(f);
		assert_int_equal(e, LHG_EIO);
		if (!strstr(err, message))
			fail_msg("call %ld: %s", k, err);
		assert_true(d.at < good.n);
	}
	fclose(f);
	assert_int_equal(e, 0);
	assert_int_equal(d.at, good.n);
	assert_memory_equal(d.b.p, good.p, good.n);
	free(d.b.p);
	return k;
}

static void
writefails(void **state)
{
	Bytes b = set(5);

	(void)state;
	assert_true(writewith(b, ENOSPC, "write: No space left on device", 0) > 8);
	assert_true(writewith(b, EIO, "write: Input/output error", 1) > 2);
	free(b.p);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(readnomemory), cmocka_unit_test(changenomemory), cmocka_unit_test(readfails),
		cmocka_unit_test(writefails)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
