/* spectrum.h - a grid field as a sum of waves.
 *
 *   dct  C_mn = c_m c_n sum f_ij cos(pi m (2i+1)/(2 nu)) cos(pi n (2j+1)/(2 nv)),
 *        c_0 = 1, other c = sqrt 2, 0 <= m < nu, 0 <= n < nv: f is extended evenly across
 *        the border of the rectangle, without a jump
 *   dft  C_mn = sum f_ij exp(-2 pi i (m i/nu + n j/nv)): f is extended
 *        periodically; it is real, so the columns 0 <= m <= nu/2 suffice    (16)-(19)
 *
 * Both are computed by FFTW.  In both, C_00 = sum f, and the sum of |C|^2 over all nu nv
 * coefficients is nu nv sum f^2.  So a bound on |C| has the same meaning in both
 * (doc/mathematics.md 5.1).  C is stored as [nv][columns]; in the dct its imaginary parts are 0.
 */
#ifndef SPECTRUM_H
#define SPECTRUM_H

#include <complex.h>
#include <stddef.h>

#include "../base/chart.h"

enum { SPECTRUM_ENOMEM = -1 };

typedef enum SpectrumBasis { SPECTRUM_DCT, SPECTRUM_DFT } SpectrumBasis;

/* The basis and the chart of the transforms of fields f[nv][nu]. */
typedef struct Spectrum {
	SpectrumBasis basis;
	Chart         g;
} Spectrum;

/* Number of columns of C: nu, or nu/2 + 1. */
int spectrum_columns(Spectrum s);

/* Number of coefficients in C: columns times nv. */
size_t spectrum_size(Spectrum s);

/* How many of the nu nv coefficients an entry in column m of C represents: 2 where C holds only one
 * coefficient of a conjugate pair of the dft, else 1. */
int spectrum_weight(Spectrum s, int m);

/* The wave number of coefficient q of C, in cycles per unit of u along the direction of the wave:
 *
 *   dct  |( m/(2 nu h), n/(2 nv k) )|
 *   dft  |( m/(nu h), n/(nv k) )|, with n - nv in place of n where that is nearer to 0 */
double spectrum_wave(Spectrum s, size_t q);

/* The transform of f[nv][nu] and its inverse.  Both return 0 or SPECTRUM_ENOMEM. */
int spectrum_forward(Spectrum s, const double *f, double complex *C);
int spectrum_inverse(Spectrum s, const double complex *C, double *f);

/* Sets modulus = |C|.  In the columns 0 and nu/2 of the dft C holds both coefficients of a
 * conjugate pair.  Both get exactly the same modulus, so that a bound keeps or drops both. */
void spectrum_moduli(Spectrum s, const double complex *C, double *modulus);

#endif
