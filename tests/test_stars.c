/* test_stars.c - which triangles of a hub are chosen. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/sample/stars.h"

enum { N = 100 };       /* triangles of the hub, a regular polygon in the middle of the chart */
static const double T = 0.8, PI = 3.14159265358979323846;

/* Ways to write the same hub. */
enum { PLAIN, RENUMBERED, REFLECTED, TURNED, WAYS };

/* Sets chosen[t] to 1 if triangle t of the hub is chosen, else to 0.  Returns the number chosen. */
static int
chosen_triangles(int way, unsigned char chosen[N])
{
	double u[N + 1] = { 0.5 }, v[N + 1] = { T/2 }, old;
	int tri[3*N], i, n;
	Mesh m = { N + 1, N, NULL, tri };
	Stars s;

	for (i = 0; i < N; i++) {
		u[i+1] = 0.5 + T/2*cos(2*PI*i/N);
		v[i+1] = T/2 + T/2*sin(2*PI*i/N);
		memcpy(&tri[3*(way == RENUMBERED ? N - 1 - i : i)], (int[]){ 0, i + 1, 1 + (i + 1)%N },
		    3*sizeof *tri);
	}
	for (i = 0; i <= N; i++) {
		old = u[i];
		u[i] = way == REFLECTED ? 1 - u[i] : way == TURNED ? v[i]/T : u[i];
		v[i] = way == TURNED ? (1 - old)/T : v[i];
	}
	assert_int_equal(stars_init(&s, &m, u, v), 0);
	n = s.few[0];
	memset(chosen, 0, N);
	for (i = 0; i < n; i++)
		chosen[way == RENUMBERED ? N - 1 - s.side[s.first[0] + i]/3 : s.side[s.first[0] + i]/3] = 1;
	assert_int_equal(s.few[1], 2);
	stars_free(&s);
	return n;
}

/* The choice belongs to the hub, however it is numbered and whichever of the corners is (0,0); it
 * has the symmetry of the hub, and leaves no gap of more than a sixth of a half turn. */
static void
choice_belongs_to_the_hub(void **state)
{
	unsigned char plain[N], other[N];
	int way, t, gap = 0;

	(void)state;
	assert_int_equal(chosen_triangles(PLAIN, plain), STARS_FEW);
	for (way = RENUMBERED; way < WAYS; way++) {
		assert_int_equal(chosen_triangles(way, other), STARS_FEW);
		assert_memory_equal(plain, other, N);
	}
	for (t = 0; t < N; t++) {
		assert_int_equal(plain[t], plain[N - 1 - t]);
		assert_int_equal(plain[t], plain[(t + N/4)%N]);
		gap = plain[t] ? 0 : gap + 1;
		assert_true(gap <= N/12);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(choice_belongs_to_the_hub),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
