/* test_stars.c - which neighbours of a hub are chosen. */
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

/* Sets chosen[i] to 1 if spoke i of the hub is chosen, else to 0. */
static void
chosen_spokes(int way, unsigned char chosen[N])
{
	double u[N + 1] = { 0.5 }, v[N + 1] = { T/2 }, old;
	int tri[3*N], i;
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
	memset(chosen, 0, N);
	assert_int_equal(s.hub[0], 0);
	for (i = 0; i < STARS_FEW; i++) {
		assert_true(s.near[i] > 0);
		chosen[s.near[i] - 1] = 1;
	}
	for (i = 1; i <= N; i++)
		assert_int_equal(s.hub[i], -1);
	stars_free(&s);
}

/* The choice belongs to the hub, however it is numbered and whichever of the corners is (0,0); it
 * has the symmetry of the hub, and leaves no gap of more than a sixth of a half turn. */
static void
choice_belongs_to_the_hub(void **state)
{
	unsigned char plain[N], other[N];
	int way, t, gap = 0;

	(void)state;
	chosen_spokes(PLAIN, plain);
	for (way = RENUMBERED; way < WAYS; way++) {
		chosen_spokes(way, other);
		assert_memory_equal(plain, other, N);
	}
	for (t = 0; t < N; t++) {
		assert_int_equal(plain[t], plain[(N - t)%N]);
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
