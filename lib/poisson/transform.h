/* transform.h - sine and cosine transforms of a row or column of a grid of N steps.
 *
 *   sine    F_k = sum over 0 < j < N of f_j sin(pi j k/N),     0 < k < N
 *   cosine  F_k = sum over 0 <= j <= N of f_j cos(pi j k/N),   0 <= k <= N,
 *           the first and the last term halved
 *
 * Either transform applied twice gives N/2 times f.  Both are computed by a real Fourier transform
 * of length N and a running sum (W. H. Press et al., Numerical Recipes, 12.4.1 and 12.4.2).
 * FFTW's RODFT00 is some digits more accurate for large N but takes three times as long; a
 * preconditioner needs few digits.
 */
#ifndef TRANSFORM_H
#define TRANSFORM_H

#include <stddef.h>

#include <fftw3.h>

enum { TRANSFORM_ENOMEM = -1 };

typedef struct Transform {
	int        N;           /* steps, >= 1 */
	double    *sines;       /* [N] sin(pi j/N) */
	double    *cosines;     /* [N] cos(pi j/N) */
	fftw_plan  plan;
	fftw_plan  pair;        /* NULL unless transform_init_pair was called */
} Transform;

/* Returns 0, or TRANSFORM_ENOMEM with nothing in t to free. */
int  transform_init(Transform *t, int N);
void transform_free(Transform *t);

/* The size in doubles of the workspace of a transform.  Every thread needs its own workspace,
 * allocated by fftw_alloc_real. */
size_t transform_room(const Transform *t);

/* The number nearest to n >= 1 (of two, the larger), among those that leave the same remainder divided by
 * `step` as n, of which a real Fourier transform is fast: its prime factors are at most 7, but
 * for one 11 or 13 (FFTW manual, 4.3.1). */
int transform_fast_size(int n, int step);

/* Transforms f in place: the N - 1 numbers f_1 .. f_{N-1}, with f_1 at f[0].  N >= 2. */
void transform_sine(const Transform *t, double *f, double *work);

/* Transforms f in place: the N + 1 numbers f_0 .. f_N. */
void transform_cosine(const Transform *t, double *f, double *work);

/* The same transforms of two lines f and g, by one complex Fourier transform (transformpair.c).  For odd N
 * that takes little more than a third of the time, because FFTW has vector instructions for complex
 * transforms of any length, and for real ones of even length.  First call transform_init_pair, which
 * returns 0 or TRANSFORM_ENOMEM. */
int    transform_init_pair(Transform *t);
size_t transform_pair_room(const Transform *t);
void   transform_sine_pair(const Transform *t, double *f, double *g, double *work);
void   transform_cosine_pair(const Transform *t, double *f, double *g, double *work);

#endif
