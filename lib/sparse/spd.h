/* spd.h - sparse symmetric positive definite systems, solved by CHOLMOD. */
#ifndef SPD_H
#define SPD_H

#include <stddef.h>

enum {
	SPD_ENOMEM = -1,        /* report.bytes says how much the factor wanted */
	SPD_EINDEFINITE = -2,   /* not positive definite; report.column is the first to show it */
	SPD_ELARGE = -3         /* more entries than CHOLMOD's int can count */
};

/* A matrix in the making: entries of its lower or upper triangle in any order, each
 * off-diagonal pair given once; entries of equal place are summed. */
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

/* Room for `room` entries, of which none is there yet.  Returns 0, SPD_ENOMEM or
 * SPD_ELARGE. */
int  spd_init(Spd *a, int n, size_t room);
void spd_free(Spd *a);

/* a(i,j) += x; the room given to spd_init must not run out. */
static inline void
spd_add(Spd *a, int i, int j, double x)
{
	a->row[a->count] = i > j ? i : j;
	a->col[a->count] = i > j ? j : i;
	a->value[a->count++] = x;
}

/* Solve a X = B for nrhs right-hand sides; X replaces B, stored [nrhs][n].  order is
 * a fill-reducing order (order[0] eliminated first) or NULL for AMD's.  a is used up:
 * its memory is released as early as may be, also on failure.  Equal input gives equal
 * bits: the BLAS is held to one thread.  report may be NULL.  A solution that is not
 * finite counts as SPD_EINDEFINITE. */
int spd_solve(Spd *a, const int *order, int nrhs, double *B, SpdReport *report);

#endif
