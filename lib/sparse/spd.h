/* spd.h - sparse symmetric positive definite systems, solved by CHOLMOD. */
#ifndef SPD_H
#define SPD_H

#include <stddef.h>

enum {
	SPD_ENOMEM = -1,        /* report.bytes is the size of the factor */
	SPD_EINDEFINITE = -2,   /* not positive definite; report.column is the first bad pivot */
	SPD_ELARGE = -3         /* more entries than CHOLMOD's int can count */
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

/* a(i,j) += x; at most `room` times. */
static inline void
spd_add(Spd *a, int i, int j, double x)
{
	a->row[a->count] = i > j ? i : j;
	a->col[a->count] = i > j ? j : i;
	a->value[a->count++] = x;
}

/* Solves a X = B for nrhs right-hand sides; X replaces B, stored [nrhs][n].  order is a
 * fill-reducing order (order[0] eliminated first), or NULL for AMD's.  a is freed as early as
 * possible, also on failure.  Equal input gives equal bits: the BLAS runs on one thread.  report
 * may be NULL.  A solution that is not finite counts as SPD_EINDEFINITE. */
int spd_solve(Spd *a, const int *order, int nrhs, double *B, SpdReport *report);

#endif
