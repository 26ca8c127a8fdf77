/* cmplx.h - <complex.h> with CMPLX for every compiler. */
#ifndef CMPLX_H
#define CMPLX_H

#include <complex.h>

#ifndef CMPLX           /* of C11; glibc has it for gcc only, clang has the builtin */
#define CMPLX(x, y) __builtin_complex((double)(x), (double)(y))
#endif

#endif
