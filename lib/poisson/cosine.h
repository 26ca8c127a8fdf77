/* cosine.h - the cosine transform of a row or column of a grid, its ends included.
 *
 *   F_k = sum over 0 <= j <= N of f_j cos(pi j k/N), the first and the last term halved,
 *
 * for 0 <= k <= N, twice: N/2 times f.  As the sine transform of sine.h, by a real Fourier
 * transform of length N and a running sum (Numerical Recipes, 12.4.2).
 */
#ifndef COSINE_H
#define COSINE_H

#include <stddef.h>

#include <fftw3.h>

typedef struct Cosine {
	int        n;           /* N + 1 >= 2, numbers in a transform */
	double    *sines;       /* [N] sin(pi j/N) */
	double    *cosines;     /* [N] cos(pi j/N) */
	fftw_plan  plan;
} Cosine;

/* Returns 0 or -1 without memory; c then holds nothing to free. */
int  cosine_init(Cosine *c, int n);
void cosine_free(Cosine *c);

/* Room that cosine_transform needs: fftw_alloc_real(cosine_room(c)), one for each thread. */
size_t cosine_room(const Cosine *c);

/* f[0 .. n-1] in place. */
void cosine_transform(const Cosine *c, double *f, double *work);

#endif
