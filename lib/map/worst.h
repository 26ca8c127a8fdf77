/* worst.h - which triangles to split. */
#ifndef WORST_H
#define WORST_H

/* A bound: triangles whose terms reach it are to be split.  They are the fewest whose terms sum to
 * 0.7 of all terms, but at most about `most`.  The bound is a little below the smallest of their
 * terms, so that terms that are equal up to rounding are all above it or all below, whatever the
 * numbering.
 *
 * term    in  [nf] terms of the certificate (adapt.h)
 * sorted      [nf] workspace
 *
 * Returns HUGE_VAL if none is to be split. */
double worst_terms(const double *term, int nf, int most, double *sorted);

#endif
