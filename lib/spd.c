/* spd.c - CHOLMOD behind spd.h. */
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include <cblas.h>
#include <suitesparse/cholmod.h>

#include "spd.h"

int
spd_init(Spd *a, int n, size_t room)
{
	memset(a, 0, sizeof *a);
	if (room > INT_MAX)
		return SPD_ELARGE;
	a->n = n;
	a->room = room;
	a->row = malloc(room*sizeof *a->row + 1);
	a->col = malloc(room*sizeof *a->col + 1);
	a->value = malloc(room*sizeof *a->value + 1);
	if (a->row && a->col && a->value)
		return 0;
	spd_free(a);
	return SPD_ENOMEM;
}

void
spd_free(Spd *a)
{
	free(a->row);
	free(a->col);
	free(a->value);
	memset(a, 0, sizeof *a);
}

/* The matrix in CHOLMOD's own form; a is released. */
static cholmod_sparse *
compress(Spd *a, cholmod_common *c)
{
	cholmod_triplet t = { .nrow = a->n, .ncol = a->n, .nzmax = a->room, .nnz = a->count,
	    .i = a->row, .j = a->col, .x = a->value, .stype = -1,
	    .itype = CHOLMOD_INT, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE };
	cholmod_sparse *A = cholmod_triplet_to_sparse(&t, 0, c);

	spd_free(a);
	return A;
}

/* CHOLMOD reports by Common->status, never by its return values alone. */
static int
status(const cholmod_common *c, const cholmod_factor *L, SpdReport *r)
{
	r->bytes = c->lnz*sizeof(double);
	if (c->status == CHOLMOD_NOT_POSDEF) {
		r->column = L ? (int)L->minor : 0;
		return SPD_EINDEFINITE;
	}
	if (c->status == CHOLMOD_TOO_LARGE)
		return SPD_ELARGE;
	return c->status < 0 ? SPD_ENOMEM : 0;
}

static int
factor_solve(cholmod_sparse *A, const int *order, int nrhs, double *B, SpdReport *r, cholmod_common *c)
{
	cholmod_dense b = { .nrow = A->nrow, .ncol = nrhs, .nzmax = A->nrow*nrhs, .d = A->nrow,
	    .x = B, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE }, *x = NULL;
	cholmod_factor *L;
	int e;

	c->nmethods = 1;
	c->method[0].ordering = order ? CHOLMOD_GIVEN : CHOLMOD_AMD;
	L = cholmod_analyze_p(A, (int *)order, NULL, 0, c);
	if (L)
		cholmod_factorize(A, L, c);
	e = status(c, L, r);
	if (!e) {
		x = cholmod_solve(CHOLMOD_A, L, &b, c);
		e = status(c, L, r);
	}
	if (!e)
		memcpy(B, x->x, A->nrow*nrhs*sizeof *B);
	cholmod_free_dense(&x, c);
	cholmod_free_factor(&L, c);
	return e;
}

int
spd_solve(Spd *a, const int *order, int nrhs, double *B, SpdReport *report)
{
	int threads = openblas_get_num_threads(), e;
	SpdReport none, *r = report ? report : &none;
	cholmod_common c;
	cholmod_sparse *A;

	memset(r, 0, sizeof *r);
	cholmod_start(&c);
	c.print = 0;
	A = compress(a, &c);
	openblas_set_num_threads(1);
	e = A ? factor_solve(A, order, nrhs, B, r, &c) : SPD_ENOMEM;
	openblas_set_num_threads(threads);
	cholmod_free_sparse(&A, &c);
	cholmod_finish(&c);
	return e;
}
