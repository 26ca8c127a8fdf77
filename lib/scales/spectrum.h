/* spectrum.h - a grid field as a sum of waves.
 *
 *   dct  C_mn = c_m c_n sum f_ij cos(pi m (2i+1)/(2 nu)) cos(pi n (2j+1)/(2 nv)),
 *        c_0 = 1, other c = sqrt 2, 0 <= m < nu, 0 <= n < nv: f is extended evenly across
 *        the border of the rectangle, without a jump
 *   dft  C_mn = sum f_ij exp(-2 pi i (m i/nu + n j/nv)): f is extended
 *        periodically; it is real, so the columns 0 <= m <= nu/2 suffice    (16)-(19)
 *
 * by FFTW.  In both C_00 = sum f, and sum |C|^2 = nu nv sum f^2 over all nu nv coefficients, so
 * a bound on |C| has the same meaning in both (doc/mathematics.md 5.1).  C is [nv][columns]; the
 * imaginary parts of the dct are 0.
 */
#ifndef SPECTRUM_H
#define SPECTRUM_H

#include <complex.h>
#include <stddef.h>

#include "../base/chart.h"

enum { SPECTRUM_ENOMEM = -1 };

typedef enum SpectrumBasis { SPECTRUM_DCT, SPECTRUM_DFT } SpectrumBasis;

/* The space of coefficients of fields f[nv][nu] on a chart. */
typedef struct Spectrum {
	SpectrumBasis basis;
	Chart         g;
} Spectrum;

/* Number of columns of C: nu, or nu/2 + 1. */
int spectrum_columns(Spectrum s);

/* Number of coefficients in C: columns times nv. */
size_t spectrum_size(Spectrum s);

/* How many of the nu nv coefficients an entry of column m of C stands for: 2 for a conjugate pair of
 * the dft of which C holds only one, 1 for all others. */
int spectrum_weight(Spectrum s, int m);

/* The wave number of coefficient q of C: cycles per unit of u, in any direction of (u,v),
 *
 *   dct  |( m/(2 nu h), n/(2 nv k) )|
 *   dft  |( m/(nu h), n/(nv k) )|, with n - nv in place of n where that is nearer to 0 */
double spectrum_wave(Spectrum s, size_t q);

/* Return 0 or SPECTRUM_ENOMEM. */
int spectrum_forward(Spectrum s, const double *f, double complex *C);
int spectrum_inverse(Spectrum s, const double complex *C, double *f);

/* modulus = |C|.  In the columns 0 and nu/2 of the dft both coefficients of a conjugate pair are in C.
 * They get the same modulus, without rounding differences, so that a bound keeps or drops both. */
void spectrum_moduli(Spectrum s, const double complex *C, double *modulus);

#endif
