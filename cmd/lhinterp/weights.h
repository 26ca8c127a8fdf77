/* weights.h - lists of numbers, and the weights of frames. */
#ifndef CMD_WEIGHTS_H
#define CMD_WEIGHTS_H

/* The numbers in [lo,hi] of a list, separated by commas, to be freed; *n is their count. */
double *opt_numbers(const char *list, double lo, double hi, const char *option, int *n);

/* Replaces the list of -w by a weight for each of `grids` grids, with sum 1; a single weight is for all.
 * Exit 2 if their number is another, or if their sum is not positive.  Frees w. */
double *weights_of(double *w, int n, int grids);

#endif
