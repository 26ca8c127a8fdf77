/* spd.h - sparse symmetric positive definite systems, solved by CHOLMOD. */
#ifndef SPD_H
#define SPD_H

#include <stddef.h>

enum {
	SPD_ENOMEM = -1,        /* report.bytes is the size of the factor */
	SPD_EINDEFINITE = -2,   /* not positive definite; report.column has the first bad pivot */
	SPD_ELARGE = -3         /* more entries than an int, as CHOLMOD uses it, can count */
};

/* A matrix under construction: entries in any order, from the lower or the upper triangle, each
 * off-diagonal pair given once.  Entries at the same place are summed. */
typedef struct Spd {
	int     n;
	size_t  count, room;
	int    *row, *col;
	double *value;
} Spd;

typedef struct SpdReport {
	int    column;
	double bytes;           /* of the factor, 0 if not known */
} SpdReport;

/* An n x n matrix of zeros, with room for `room` entries.  Returns 0, SPD_ENOMEM or SPD_ELARGE. */
int  spd_init(Spd *a, int n, size_t room);
void spd_free(Spd *a);

/* a(i,j) += x.  May be called at most `room` times. */
static inline void
spd_add(Spd *a, int i, int j, double x)
{
	a->row[a->count] = i > j ? i : j;
	a->col[a->count] = i > j ? j : i;
	a->value[a->count++] = x;
}

/* Solves a X = B for nrhs right-hand sides; X replaces B, stored [nrhs][n].  order is a
 * fill-reducing order (order[0] eliminated first), or NULL for the order that AMD finds.  a is freed
 * as early as possible, also on failure.  Equal input gives equal bits: the BLAS runs on one thread.
 * report may be NULL.  Returns 0, SPD_ENOMEM, SPD_ELARGE or SPD_EINDEFINITE, the last also for a
 * solution that is not finite. */
int spd_solve(Spd *a, const int *order, int nrhs, double *B, SpdReport *report);

/* A factor that is kept: the pattern of the matrix is fixed, its numbers change, and each matrix is
 * solved with many right-hand sides. */
typedef struct SpdFactor SpdFactor;

/* n, column and row describe the lower triangle in compressed columns: the rows of column j are
 * row[column[j]] .. row[column[j+1]-1], in ascending order, the diagonal first.  The arrays must
 * live as long as the factor.  Returns NULL if memory runs out or the factor is too large. */
SpdFactor *spd_factor_new(int n, int *column, int *row);
void       spd_factor_free(SpdFactor *f);

/* Factors the matrix whose entry in row row[k] is value[k].  Returns 0, SPD_ENOMEM, SPD_ELARGE or
 * SPD_EINDEFINITE.  After a failure spd_factor_set may be called again, spd_factor_solve may not. */
int spd_factor_set(SpdFactor *f, double *value);

/* b = A^-1 b.  Returns 0 or SPD_ENOMEM.  Equal bits for equal input, as above. */
int spd_factor_solve(SpdFactor *f, double *b);

#endif
