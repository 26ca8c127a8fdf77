/* weights.c - lists of numbers, and the weights of grids. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "weights.h"

static const double SMALL = 1e-6;       /* sums of weights below this times their size count as 0 */

double *
opt_numbers(const char *list, double lo, double hi, const char *option, int *n)
{
	char *copy = cmd_alloc(strlen(list) + 1, 1), *word = copy, *comma;
	double *x = cmd_alloc(strlen(list) + 1, sizeof *x);

	strcpy(copy, list);
	for (*n = 0; word; word = comma) {
		if ((comma = strchr(word, ',')))
			*comma++ = '\0';
		x[(*n)++] = opt_double(word, lo, hi, option);
	}
	free(copy);
	return x;
}

double *
weights_of(double *w, int n, int grids)
{
	double *all = cmd_alloc(grids, sizeof *all), sum = 0, size = 0;
	int k;

	if (n != 1 && n != grids)
		misuse("%d weights for %d grids", n, grids);
	for (k = 0; k < grids; k++) {
		all[k] = w[n == 1 ? 0 : k];
		sum += all[k];
		size += fabs(all[k]);
	}
	if (!(sum > SMALL*size))
		misuse("the sum of the weights is %g, must be positive, above %g of the sum of their absolute values", sum, SMALL);
	for (k = 0; k < grids; k++)
		all[k] /= sum;
	free(w);
	return all;
}
