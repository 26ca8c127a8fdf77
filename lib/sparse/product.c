/* product.c - two inner loops, in blocks that fit the registers.
 *
 * They are written in C with the compiler's vector types and use no BLAS, for three reasons.  Most
 * products in a sparse factor have so few columns that the call would take longer than the product.
 * OpenBLAS 0.3.21 treats processors newer than itself as those of 2004.  Its threads wait by
 * spinning.
 */
#include "../base/cpu.h"
#include "product.h"

#define VECTOR_OF(lanes) __attribute__((vector_size(8*(lanes)), aligned(8), may_alias))

typedef double Two VECTOR_OF(2);
typedef double Four VECTOR_OF(4);
typedef double Eight VECTOR_OF(8);

#define VECTOR Two
#define TILE   tile_128
#include "tile.h"

#define VECTOR Four
#define TILE   tile_256
#include "tile.h"

#define VECTOR Eight
#define TILE   tile_512
#include "tile.h"

INLINE void
quotient(int columns, const double *L, double *x)
{
	Eight *column = (Eight *)x;
	int j, k;

	for (k = 0; k < columns; k++, L += PRODUCT_ROWS) {
		column[k] *= 1/L[k];
		for (j = k + 1; j < columns; j++)
			column[j] -= L[j]*column[k];
	}
}

/* For sixteen registers, as in most processors: eight sums at a time. */
static void
product_128(int columns, int n, const double *a, const double *b, double *c)
{
	const double *const rows[4] = { a, a + 2, a + 4, a + 6 };
	double *const to[4] = { c, c + 2, c + 4, c + 6 };

	tile_128(4, 2, columns, n, rows, b, to);
}

TARGET("avx2,fma") static void
product_256(int columns, int n, const double *a, const double *b, double *c)
{
	const double *const rows[2] = { a, a + 4 };
	double *const to[2] = { c, c + 4 };

	tile_256(2, 4, columns, n, rows, b, to);
}

/* For thirty-two registers: eight or sixteen sums at a time. */
TARGET("avx512f") static void
product_512(int blocks, int columns, int n, const double *const a[], const double *b,
	double *const c[])
{
	if (blocks == 2)
		tile_512(2, PRODUCT_ROWS, columns, n, a, b, c);
	else
		tile_512(1, PRODUCT_ROWS, columns, n, a, b, c);
}

TARGET("avx2,fma") static void
quotient_256(int columns, const double *L, double *x)
{
	quotient(columns, L, x);
}

TARGET("avx512f") static void
quotient_512(int columns, const double *L, double *x)
{
	quotient(columns, L, x);
}

void
product_subtract(int blocks, int columns, int n, const double *const a[], const double *b,
	double *const c[])
{
	int i, j, wide = HAS("avx2") && HAS("fma"), width = wide ? 4 : 2;

	if (HAS("avx512f")) {
		product_512(blocks, columns, n, a, b, c);
		return;
	}
	for (i = 0; i < blocks; i++)
		for (j = 0; j < columns; j += width)
			(wide ? product_256 : product_128)(columns - j, n, a[i], b + j,
			    c[i] + PRODUCT_ROWS*j);
}

void
product_divide(int columns, const double *L, double *x)
{
	if (HAS("avx512f"))
		quotient_512(columns, L, x);
	else if (HAS("avx2") && HAS("fma"))
		quotient_256(columns, L, x);
	else
		quotient(columns, L, x);
}
