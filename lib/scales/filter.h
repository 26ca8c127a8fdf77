/* filter.h - Algorithm 1: thresholds on the coefficients of a grid field, by (32) and variants. */
#ifndef FILTER_H
#define FILTER_H

#include "spectrum.h"

enum { FILTER_ENOMEM = -1 };

/* Which coefficients are kept.  C_00, the mean, is always kept. */
typedef enum FilterRule {
	FILTER_PERCENT,         /* |C|/(nu nv rms) x 100 > bound, rms the root mean square of f;
	                         * if log, of log f less its border part and then less its mean.
	                         * Such a bound has the same meaning for lambda and H, for every
	                         * unit of length and every grid size (doc/mathematics.md 5.2) */
	FILTER_RAW,             /* |C| > bound, exactly as in (32) */
	FILTER_KEEP,            /* the `bound` largest in modulus of all nu nv, and any others
	                         * equal to the smallest of these; a conjugate pair counts as
	                         * two coefficients, both kept or both dropped */
	FILTER_ENERGY,          /* the fewest, largest first, whose sum of |C|^2 is at least
	                         * `bound` (0..1) times that of all, the mean not counted */
	FILTER_LOWPASS          /* wave number <= bound, in cycles per unit of u */
} FilterRule;

typedef struct Filter {
	FilterRule rule;
	double     bound;       /* >= 0 */
	int        log;         /* filter log f less its border part (borderpart.h) instead, f > 0; the
	                         * result is > 0 too, and f on the border is kept */
} Filter;

/* Drops coefficients of f by the rule, in place.  If only zero coefficients are dropped,
 * f is left untouched, bit for bit.  *kept is the number of coefficients kept, of nu nv.
 * Returns 1 if f has changed, 0 if not, or FILTER_ENOMEM. */
int filter_field(Spectrum s, const Filter *by, double *f, size_t *kept);

/* Sets out[spectrum_size(s)] to |C| in percent, as in FILTER_PERCENT, or to 0 if the rms is 0.
 * Returns 0 or FILTER_ENOMEM. */
int filter_percent(Spectrum s, int logarithm, const double *f, double *out);

#endif
