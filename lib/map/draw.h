/* draw.h - a fixed sequence of numbers, for the starts of a search. */
#ifndef DRAW_H
#define DRAW_H

/* The next number, in (0,1). */
static inline double
draw(unsigned long long *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return ((double)(*state >> 11) + 0.5)/(1ull << 53);
}

#endif
