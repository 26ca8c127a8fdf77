/* tile.h - the inner loop of product.c for one vector length; product.c includes it once for each.
 * VECTOR is the type, TILE the name of the function.
 *
 * c(i,j) -= sum over k < n of a(i,k) b(j,k) for `count` vectors of rows i, each with its own a and
 * c, and `width` columns j, of which only the first `columns` are stored.  Every call gives
 * constants for count and width, so that the sums stay in registers. */
INLINE void
TILE(int count, int width, int columns, int n, const double *const a[], const double *b,
	double *const c[])
{
	VECTOR sum[4][8];
	int i, j, k;

#pragma GCC unroll 8
	for (j = 0; j < width; j++)
#pragma GCC unroll 4
		for (i = 0; i < count; i++)
			sum[i][j] = (VECTOR){ 0 };
	for (k = 0; k < n; k++, b += PRODUCT_ROWS)
#pragma GCC unroll 4
		for (i = 0; i < count; i++) {
			VECTOR x = *(const VECTOR *)(a[i] + PRODUCT_ROWS*k);

#pragma GCC unroll 8
			for (j = 0; j < width; j++)
				sum[i][j] += x*b[j];
		}
#pragma GCC unroll 8
	for (j = 0; j < width; j++)
#pragma GCC unroll 4
		for (i = 0; i < count; i++)
			if (j < columns)
				*(VECTOR *)(c[i] + PRODUCT_ROWS*j) -= sum[i][j];
}

#undef VECTOR
#undef TILE
