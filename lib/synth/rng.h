/* rng.h - random numbers from a seed (splitmix64, Steele, Lea and Flood 2014).  Unlike those of
 * rand(), they are the same on every machine. */
#ifndef RNG_H
#define RNG_H

#include <stdint.h>

/* The next 64 bits of the sequence whose state is *s; a seed is its first state. */
static inline uint64_t
rng_next(uint64_t *s)
{
	uint64_t z = *s += 0x9e3779b97f4a7c15u;

	z = (z ^ z >> 30)*0xbf58476d1ce4e5b9u;
	z = (z ^ z >> 27)*0x94d049bb133111ebu;
	return z ^ z >> 31;
}

/* Uniform in [0,1). */
static inline double
rng_unit(uint64_t *s)
{
	return (double)(rng_next(s) >> 11)*0x1p-53;
}

#endif
