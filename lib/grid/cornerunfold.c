/* cornerunfold.c - turns folded cells near a corner of a grid back. */
#include <math.h>
#include <stddef.h>

#include "../base/vec3.h"
#include "cornerfold.h"
#include "cornerunfold.h"

static const double WANTED = 0.1;       /* cosine between the normals of two cells side by side */
static const double SHARE[] = { -0.5, -0.25, -0.125, 0.125, 0.25, 0.5 };
enum { SHARES = sizeof SHARE/sizeof *SHARE, MOVES = 40 };

typedef struct Block {
	Chart g;
	int   k, radius;
	double *const *phi;
} Block;

/* A node and where it goes; gain is what the sum falls by, length that of the way, squared. */
typedef struct Move {
	int    a, b;
	double to[3], gain, length;
} Move;

static double *
at(const Block *w, int c, int a, int b)
{
	return &w->phi[c][corner_node(w->g, w->k, a, b)];
}

/* The term of cell (a,b) and the cell (da,db) farther. */
static double
term(const Block *w, int a, int b, int da, int db)
{
	const double *const phi[3] = { w->phi[0], w->phi[1], w->phi[2] };
	double n[3], m[3], turn;

	corner_cell_normal(w->g, w->k, phi, a, b, n);
	corner_cell_normal(w->g, w->k, phi, a + da, b + db, m);
	turn = dot3(n, m)/sqrt(dot3(n, n)*dot3(m, m));
	if (!(turn >= -1))
		turn = -1;
	return turn < WANTED ? (WANTED - turn)*(WANTED - turn) : 0;
}

/* The sum over the cells whose terms node (a,b) changes. */
static double
sum_near(const Block *w, int a, int b)
{
	int a0 = a < 2 ? 0 : a - 2, a1 = a + 1, b0 = b < 2 ? 0 : b - 2, b1 = b + 1, i, j;
	double sum = 0;

	for (j = b0; j <= b1; j++)
		for (i = a0; i <= a1; i++) {
			if (i < a1)
				sum += term(w, i, j, 1, 0);
			if (j < b1)
				sum += term(w, i, j, 0, 1);
		}
	return sum;
}

/* Many moves lower the sum to 0: the shortest is best.  So the order of trying does not count. */
static int
is_better(double gain, double length, const Move *than)
{
	double rounding = 1e-9*fabs(gain);

	if (fabs(gain - than->gain) > rounding || gain <= 0)
		return gain > than->gain;
	return length < than->length;
}

static void
try_line(const Block *w, int a, int b, const double d[3], double sum, Move *best)
{
	double was[3], gain, length;
	int c, s;

	for (c = 0; c < 3; c++)
		was[c] = *at(w, c, a, b);
	for (s = 0; s < SHARES; s++) {
		for (c = 0; c < 3; c++)
			*at(w, c, a, b) = was[c] + SHARE[s]*d[c];
		gain = sum - sum_near(w, a, b);
		length = SHARE[s]*SHARE[s]*dot3(d, d);
		if (is_better(gain, length, best)) {
			*best = (Move){ a, b, { 0 }, gain, length };
			for (c = 0; c < 3; c++)
				best->to[c] = *at(w, c, a, b);
		}
	}
	for (c = 0; c < 3; c++)
		*at(w, c, a, b) = was[c];
}

static void
try_node(const Block *w, int a, int b, Move *best)
{
	double sum = sum_near(w, a, b), d[3];
	int i, c;

	for (i = 0; i < 9 && sum > 0; i++) {
		if (i == 4)
			continue;
		for (c = 0; c < 3; c++)
			d[c] = *at(w, c, a - 1 + i%3, b - 1 + i/3) - *at(w, c, a, b);
		try_line(w, a, b, d, sum, best);
	}
}

static int
folds(const Block *w)
{
	const double *const phi[3] = { w->phi[0], w->phi[1], w->phi[2] };

	return corner_folds(w->g, w->k, phi, w->radius);
}

/* The nodes of the block from `from` to `to`: one of them is the block itself, NULL. */
static void
copy(const Block *w, const double *from, double *to)
{
	int a, b, c, q = 0;

	for (c = 0; c < 3; c++)
		for (b = 1; b < w->radius; b++)
			for (a = 1; a < w->radius; a++, q++)
				if (to)
					to[q] = *at(w, c, a, b);
				else
					*at(w, c, a, b) = from[q];
}

void
corner_unfold(Chart g, int k, double *const phi[3], int radius)
{
	Block w = { g, k, radius, phi };
	double before[3*radius*radius];
	int a, b, c, moves;

	copy(&w, NULL, before);
	for (moves = 0; moves < MOVES && folds(&w); moves++) {
		Move best = { .gain = 0 };

		for (b = 1; b < radius; b++)
			for (a = 1; a < radius; a++)
				try_node(&w, a, b, &best);
		if (best.gain <= 0)
			break;
		for (c = 0; c < 3; c++)
			*at(&w, c, best.a, best.b) = best.to[c];
	}
	if (folds(&w))
		copy(&w, before, NULL);
}
