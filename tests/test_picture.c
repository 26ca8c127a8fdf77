/* test_picture.c - colour scales and the numbers of colour bars (lib/picture). */
#include "cmock.h"

#include <math.h>
#include <stdlib.h>

#include "../lib/picture/ticks.h"
#include "../lib/synth/rng.h"

enum { ROUNDS = 2000 };
static const double LENGTH = 256, GAP = 20;

static double
between(uint64_t *seed, double low, double high)
{
	return low + (high - low)*rng_unit(seed);
}

/* A range of any size and place: linear ones of both signs, logarithmic ones of up to 40 decades. */
static ColourScale
random_scale(uint64_t *seed, int log)
{
	const double low = pow(10, between(seed, -20, 20)), width = pow(10, between(seed, -4, 4));
	ColourScale s = { COLOURMAP_VIRIDIS, log, low, log ? low*pow(10, between(seed, 0.01, 40)) : 0 };

	if (!log) {
		s.low = (rng_unit(seed) < 0.5 ? -1 : 1)*low;
		s.high = s.low + low*width;
	}
	return s;
}

static void
check_ticks(const ColourScale *s)
{
	Ticks t;
	int i, k;

	ticks_set(&t, s, LENGTH, GAP);
	assert_true(t.n >= 2 && t.n <= LENGTH/GAP + 1);
	assert_true(t.value[0] == s->low && t.value[1] == s->high);
	for (i = 0; i < t.n; i++) {
		assert_true(t.value[i] >= s->low && t.value[i] <= s->high);
		if (!s->log)
			assert_true(fabs(strtod(t.label[i], NULL) - t.value[i]) <= (s->high - s->low)/1000*1.0000001);
		for (k = 2; k < i; k++)
			assert_true(fabs(colourscale_place(s, t.value[i]) - colourscale_place(s, t.value[k]))
			    >= GAP/LENGTH*(1 - 1e-9));
	}
}

static void
ticks_lie_apart_and_labels_are_near(void **state)
{
	uint64_t seed = 1;
	ColourScale s;
	int k;

	(void)state;
	for (k = 0; k < ROUNDS; k++) {
		s = random_scale(&seed, k & 1);
		check_ticks(&s);
	}
}

static int
has_tick(const Ticks *t, double x)
{
	int i;

	for (i = 0; i < t->n; i++)
		if (fabs(t->value[i] - x) <= 1e-12*fabs(x))
			return 1;
	return 0;
}

static void
ticks_are_round_numbers(void **state)
{
	const ColourScale log = { COLOURMAP_VIRIDIS, 1, 0.2, 5e3 }, both = { COLOURMAP_DIVERGING, 0, -0.37, 0.37 };
	Ticks t;

	(void)state;
	ticks_set(&t, &log, LENGTH, GAP);
	assert_true(has_tick(&t, 1) && has_tick(&t, 10) && has_tick(&t, 100) && has_tick(&t, 1000));
	ticks_set(&t, &both, LENGTH, GAP);
	assert_true(has_tick(&t, 0) && has_tick(&t, 0.2) && has_tick(&t, -0.2));
}

static void
a_fit_takes_quantiles_and_centres_signed_values(void **state)
{
	ColourScale s = { .map = COLOURMAP_VIRIDIS };
	double x[101];
	int k;

	(void)state;
	for (k = 0; k <= 100; k++)
		x[k] = (k*37)%101 - 30;         /* -30 .. 70 in another order */
	colourscale_fit(&s, 101, x, (ColourEnd){ 10, 1 }, (ColourEnd){ 90, 1 });
	assert_true(s.low == -20 && s.high == 60);
	s.map = COLOURMAP_DIVERGING;
	colourscale_fit(&s, 101, x, (ColourEnd){ 10, 1 }, (ColourEnd){ 90, 1 });
	assert_true(s.low == -60 && s.high == 60 && colourscale_place(&s, 0) == 0.5);
	for (k = 0; k < 100; k++)
		x[k] = 4;
	x[100] = 9;
	s.map = COLOURMAP_VIRIDIS;
	colourscale_fit(&s, 101, x, (ColourEnd){ 1, 1 }, (ColourEnd){ 99, 1 });
	assert_true(s.low == 4 && s.high == 9);
	for (k = 0; k <= 100; k++)
		x[k] = 0;
	s.map = COLOURMAP_DIVERGING;
	colourscale_fit(&s, 101, x, (ColourEnd){ 1, 1 }, (ColourEnd){ 99, 1 });
	assert_true(s.low == 0 && !signbit(s.low) && s.high == 0);
}

static void
places_grow_from_0_to_1(void **state)
{
	uint64_t seed = 2;
	ColourScale s;
	double t, was;
	int k, i;

	(void)state;
	for (k = 0; k < ROUNDS; k++) {
		s = random_scale(&seed, k & 1);
		assert_true(colourscale_place(&s, s.low) == 0 && colourscale_place(&s, s.high) == 1);
		assert_true(colourscale_place(&s, -INFINITY) == 0 && colourscale_place(&s, INFINITY) == 1);
		for (i = 1, was = 0; i < 10; i++, was = t) {
			t = colourscale_place(&s, s.low + (s.high - s.low)*i/10);
			assert_true(t >= was && t <= 1);
			if (!s.log)
				assert_true(fabs(t - i/10.0) < 1e-9);
		}
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(ticks_lie_apart_and_labels_are_near),
		cmocka_unit_test(ticks_are_round_numbers),
		cmocka_unit_test(a_fit_takes_quantiles_and_centres_signed_values),
		cmocka_unit_test(places_grow_from_0_to_1)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
