/* spectrum.h - a grid field as a sum of waves.
 *
 * On the rectangle:
 *
 *   dct  C_mn = c_m c_n sum f_ij cos(pi m (2i+1)/(2 nu)) cos(pi n (2j+1)/(2 nv)),
 *        c_0 = 1, other c = sqrt 2, 0 <= m < nu, 0 <= n < nv: f is extended evenly across
 *        the border of the rectangle, without a jump
 *   dft  C_mn = sum f_ij exp(-2 pi i (m i/nu + n j/nv)): f is extended
 *        periodically; it is real, so the columns 0 <= m <= nu/2 suffice    (16)-(19)
 *
 * On the sock, whose nodes v >= 0 and their images v < 0 are 2 nv rows, with x = 2 pi u and y the
 * distance from the row v = -T in rows, plus 1/2:
 *
 *   dct  C_mn = c_mn sum f_ij cos(m x) cos(pi n y/(2 nv)), n even, 0 <= m < nu/2
 *        C_mn = c_mn sum f_ij sin(m x) cos(pi n y/(2 nv)), n odd,  0 < m <= nu/2
 *
 *        with 0 <= n < 2 nv; c_mn is 1 for m = n = 0, 2 for 0 < m < nu/2 and n > 0, else sqrt 2.
 *        f is extended evenly across the boundary.  These are all waves with f(-u,-v) = f(u,v)
 *
 * On the pillow, with x = 2 pi u and y = pi v/T, the Fourier series of the fields with f(-u,-v) = f(u,v):
 *
 *   dct  C_mn = c_mn sum f_ij cos(m x) cos(n y), 0 <= m < nu/2, 0 <= n < nv, in row 2n, column m of C
 *        C_mn = c_mn sum f_ij sin(m x) sin(n y), 0 < m <= nu/2, 0 < n <= nv, in row 2n-1, column m-1
 *
 *        with c_mn = 1 times sqrt 2 for 0 < m < nu/2, times sqrt 2 for 0 < n < nv
 *
 * All are computed by FFTW.  In each, C_00 = sum f, and the sum of |C|^2 over all nu nv
 * coefficients is nu nv sum f^2.  So a bound on |C| has the same meaning in both
 * (doc/mathematics.md 5.1).  C is stored as [rows][columns], with rows = nv, on the sock and the pillow 2 nv; in the
 * dct its imaginary parts are 0.
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

/* Whether the chart has this basis: the sock and the pillow have no dft. */
int spectrum_exists(Spectrum s);

/* Number of columns of C: nu, or nu/2 + 1; on the sock and the pillow nu/2. */
int spectrum_columns(Spectrum s);

/* Number of coefficients in C: rows times columns. */
size_t spectrum_size(Spectrum s);

/* The numbers m and n of coefficient q of C; in the dft n - nv in place of n where that is nearer to 0. */
void spectrum_numbers(Spectrum s, size_t q, int *m, int *n);

/* How many of the nu nv coefficients an entry in column m of C represents: 2 where C holds only one
 * coefficient of a conjugate pair of the dft, else 1. */
int spectrum_weight(Spectrum s, int m);

/* The wave number of coefficient q of C, in cycles per unit of u along the direction of the wave:
 *
 *   dct  |( m/(2 nu h), n/(2 nv k) )|
 *   dft  |( m/(nu h), n/(nv k) )|
 *   sock |( m, n/(4 nv k) )|
 *   pillow |( m, n/(2 T) )| */
double spectrum_wave(Spectrum s, size_t q);

/* The transform of f[nv][nu] and its inverse.  Both return 0 or SPECTRUM_ENOMEM. */
int spectrum_forward(Spectrum s, const double *f, double complex *C);
int spectrum_inverse(Spectrum s, const double complex *C, double *f);

/* Sets modulus = |C|.  In the columns 0 and nu/2 of the dft C holds both coefficients of a
 * conjugate pair.  Both get exactly the same modulus, so that a bound keeps or drops both. */
void spectrum_moduli(Spectrum s, const double complex *C, double *modulus);

#endif
