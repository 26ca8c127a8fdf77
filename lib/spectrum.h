/* spectrum.h - two-dimensional Fourier coefficients of a grid field, and which to keep.
 *
 *   C_mn = sum over nodes f_ij exp(-2 pi i (m i/nu + n j/nv)),    unnormalised
 *
 * by FFTW; f is real, so the columns 0 <= m <= nu/2 hold all: C is [nv][nu/2+1].
 */
#ifndef SPECTRUM_H
#define SPECTRUM_H

#include <complex.h>
#include <stddef.h>

enum { SPECTRUM_ENOMEM = -1 };

/* Which coefficients stay; C_00, the mean, always does. */
typedef enum SpectrumRule {
	SPECTRUM_PERCENT,       /* |C|/(nu nv rms f) x 100 > bound, rms the root mean square of
	                         * f: a K that means the same for lambda and H, for any unit
	                         * of length and any size of grid (DESIGN section 5) */
	SPECTRUM_RAW,           /* |C| > bound, as (32) is written */
	SPECTRUM_KEEP           /* the `bound` largest in modulus, of nu nv; a conjugate pair
	                         * counts two and is kept or dropped as one */
} SpectrumRule;

/* Coefficients, number of columns nu/2 + 1. */
int spectrum_forward(int nu, int nv, const double *f, double complex *C);
int spectrum_inverse(int nu, int nv, const double complex *C, double *f);

/* Drop coefficients of f by the rule, in place.  A field of which nothing is dropped is
 * left as it is, to the last bit.  *kept: how many of nu nv stay; bound >= 0.
 * Returns 0 or SPECTRUM_ENOMEM. */
int spectrum_filter(int nu, int nv, double *f, SpectrumRule rule, double bound, size_t *kept);

#endif
