/* worst.h - which triangles to split. */
#ifndef WORST_H
#define WORST_H

/* The term of a triangle in the sum for T*certificate (adapt.h).  With a, b its sides from corner 0 to
 * 1 and to 2, g_aa, g_ab, g_bb their inner products, u_a, u_b the differences of u along them, and A
 * the area, grad u . grad u = (u_b^2 g_aa - 2 u_a u_b g_ab + u_a^2 g_bb)/(4 A^2).  c: its corners. */
double worst_term(const int c[3], const double *u, const double *v, double gaa, double gab, double gbb,
	double area);

/* The bound from which on triangles are to be split: their terms are the fewest that sum to 0.7 of all
 * terms, but at most about `most`.  The bound is a little below the smallest of these, so that terms
 * that are equal up to rounding are on the same side of it, whatever the numbering.
 *
 * term    in  [nf] terms of the certificate (adapt.h)
 * sorted      [nf] workspace
 *
 * Returns HUGE_VAL if none is to be split. */
double worst_terms(const double *term, int nf, int most, double *sorted);

#endif
