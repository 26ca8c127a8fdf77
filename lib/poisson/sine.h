/* sine.h - the sine transform of a row or column of a grid.
 *
 *   F_k = sum over 0 < j < N of f_j sin(pi j k/N),    0 < k < N,    twice: N/2 times f
 *
 * by a real Fourier transform of length N and a running sum (W. H. Press et al.,
 * Numerical Recipes, 12.4.1).  FFTW's RODFT00 keeps some digits more where N is large and
 * takes three times as long: this is for a preconditioner, which needs few.
 */
#ifndef SINE_H
#define SINE_H

#include <fftw3.h>

typedef struct Sine {
	int        n;           /* N - 1, numbers in a transform */
	double    *sines;       /* [N] sin(pi j/N) */
	fftw_plan  plan;
} Sine;

/* Returns 0 or -1 without memory; s then holds nothing to free. */
int  sine_init(Sine *s, int n);
void sine_free(Sine *s);

/* Room that sine_transform needs: fftw_alloc_real(sine_room(s)), one for each thread. */
size_t sine_room(const Sine *s);

/* f[0 .. n-1] in place. */
void sine_transform(const Sine *s, double *f, double *work);

#endif
