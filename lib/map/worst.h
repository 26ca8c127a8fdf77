/* worst.h - which triangles to split. */
#ifndef WORST_H
#define WORST_H

/* The term above which triangles are split: the fewest that hold .7 of the certificate, and about
 * `most` at most.  It is a little below the last of them, so that terms that are equal up to
 * rounding are on the same side of it: which of them comes first depends on numbering.
 *
 * term    in  [nf] shares of the certificate (adapt.h)
 * sorted      [nf] workspace
 *
 * Returns HUGE_VAL if none is to be split. */
double worst_terms(const double *term, int nf, int most, double *sorted);

#endif
