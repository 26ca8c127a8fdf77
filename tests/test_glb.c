/* test_glb.c - the writer of glTF 2, read back by the reader; what it refuses; base64 as pages hold it. */
#include "cmock.h"

#include <math.h>
#include <stdio.h>

#include "../lib/base/base64.h"
#include "../lib/meshfile/glb.h"
#include "../lib/meshfile/meshfile.h"
#include "meshreads.h"

static float SQUARE[12] = { 0, 0, .5f, 2, 0, .5f, 2, 1, .5f, 0, 1, .5f };
static float ROOF[12] = { 0, 0, .5f, 2, 0, 1.5f, 2, 1, .5f, 0, 1, 1.5f };
static const int TRI[6] = { 0, 1, 2, 0, 2, 3 };

static void
square_and_roof(void **state)
{
	static const unsigned short red[16] = { 65535, 0, 0, 65535, 65535, 0, 0, 65535, 65535, 0, 0, 65535, 65535, 0, 0, 65535 };
	float *const xyz[2] = { SQUARE, ROOF };
	Glb g = { 4, 2, TRI, 1, xyz, NULL, 2 };
	char *bytes, *again;
	size_t n, m;
	int frames, i;
	Soup s;

	(void)state;
	for (frames = 1; frames <= 2; frames++)
		for (g.frames = frames, i = 0; i < 2; i++) {
			g.colour = i ? red : NULL;
			assert_int_equal(glb_write(&g, &bytes, &n), 0);
			assert_int_equal(n % 4, 0);
			reads_bytes(bytes, n, 4, "0 1 2/0 2 3");
			assert_int_equal(parse(&s, bytes, n), 0);
			for (int k = 0; k < 12; k++)            /* the first frame, whatever follows */
				assert_true(s.xyz[k] == (double)SQUARE[k]);
			soup_free(&s);
			assert_int_equal(glb_write(&g, &again, &m), 0);
			assert_true(m == n && memcmp(again, bytes, n) == 0);
			free(bytes);
			free(again);
		}
}

static void
refused(void **state)
{
	float bad[12], *const xyz[2] = { SQUARE, bad };
	const Glb g = { 4, 2, TRI, 2, xyz, NULL, 1 }, large = { 4, 400*1000*1000, TRI, 1, xyz, NULL, 1 };
	char *bytes;
	size_t n;
	int k;

	(void)state;
	for (k = 0; k < 12; k++) {
		memcpy(bad, ROOF, sizeof bad);
		bad[k] = k % 2 ? NAN : INFINITY;
		assert_int_equal(glb_write(&g, &bytes, &n), GLB_EVALUE);
	}
	assert_int_equal(glb_write(&large, &bytes, &n), GLB_ELARGE);    /* 12 bytes for a triangle: 4.8e9 */
}

/* The examples of RFC 4648, section 10; and all 64 digits. */
static void
base64(void **state)
{
	static const char *const word[] = { "", "f", "fo", "foo", "foob", "fooba", "foobar" };
	static const char *const code[] = { "", "Zg==", "Zm8=", "Zm9v", "Zm9vYg==", "Zm9vYmE=", "Zm9vYmFy" };
	static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
	unsigned char b[48];
	char out[65];
	int i;

	(void)state;
	for (i = 0; i < 7; i++) {
		assert_int_equal(base64_length(strlen(word[i])), strlen(code[i]));
		memset(out, 0, sizeof out);
		base64_encode(word[i], strlen(word[i]), out);
		assert_string_equal(out, code[i]);
	}
	for (i = 0; i < 64; i += 4) {
		b[i/4*3] = (unsigned char)(i << 2 | (i+1) >> 4);
		b[i/4*3+1] = (unsigned char)((i+1) << 4 | (i+2) >> 2);
		b[i/4*3+2] = (unsigned char)((i+2) << 6 | (i+3));
	}
	out[64] = '\0';
	base64_encode(b, 48, out);
	assert_string_equal(out, digits);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(square_and_roof), cmocka_unit_test(refused), cmocka_unit_test(base64)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
