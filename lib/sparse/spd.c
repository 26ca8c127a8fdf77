/* spd.c - CHOLMOD behind spd.h. */
#include <dlfcn.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <omp.h>
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

/* Converts a to a CHOLMOD matrix and frees it. */
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

/* The error code of the last call of CHOLMOD.  It is taken from Common->status, since CHOLMOD's
 * return values do not report all failures. */
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

/* A solution that is not finite is reported as a pivot that is not positive. */
static int
check_finite(const double *x, size_t n, size_t nrow, SpdReport *r)
{
	size_t i;

	for (i = 0; i < n; i++)
		if (!isfinite(x[i])) {
			r->column = (int)(i%nrow);
			return SPD_EINDEFINITE;
		}
	return 0;
}

/* CHOLMOD's state for one matrix. */
typedef struct Work {
	cholmod_common  c;
	cholmod_factor *L;
	int             e;
	SpdReport       r;
} Work;

static void
start(Work *w)
{
	memset(w, 0, sizeof *w);
	cholmod_start(&w->c);
	w->c.print = 0;
	w->c.nmethods = 1;
	w->c.final_ll = 1;              /* factor into L L': L D L' would accept a negative pivot */
}

/* ordering is one of CHOLMOD's methods; order is used with CHOLMOD_GIVEN only. */
static void
analyze(Work *w, cholmod_sparse *A, int ordering, const int *order)
{
	w->c.method[0].ordering = ordering;
	w->L = cholmod_analyze_p(A, (int *)order, NULL, 0, &w->c);
	w->e = status(&w->c, w->L, &w->r);
}

static void
solve(Work *w, cholmod_sparse *A, int nrhs, double *B)
{
	cholmod_dense b = { .nrow = A->nrow, .ncol = nrhs, .nzmax = A->nrow*nrhs, .d = A->nrow,
	    .x = B, .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE }, *x = NULL;

	if (!w->e) {
		cholmod_factorize(A, w->L, &w->c);
		w->e = status(&w->c, w->L, &w->r);
	}
	if (!w->e) {
		x = cholmod_solve(CHOLMOD_A, w->L, &b, &w->c);
		w->e = status(&w->c, w->L, &w->r);
	}
	if (!w->e)
		w->e = check_finite(x->x, A->nrow*nrhs, A->nrow, &w->r);
	if (!w->e)
		memcpy(B, x->x, A->nrow*nrhs*sizeof *B);
	cholmod_free_dense(&x, &w->c);
	cholmod_free_factor(&w->L, &w->c);
}

/* OpenBLAS's functions that set and get its number of threads; NULL if the BLAS is another one. */
typedef struct Blas {
	void (*set)(int);
	int  (*get)(void);
} Blas;

static Blas
openblas(void)
{
	void *process = dlopen(NULL, RTLD_LAZY);
	Blas b = { NULL, NULL };

	if (!process)
		return b;
	*(void **)&b.set = dlsym(process, "openblas_set_num_threads");
	*(void **)&b.get = dlsym(process, "openblas_get_num_threads");
	dlclose(process);
	return b;
}

/* The settings that are restored after CHOLMOD has run on one thread.  With more threads, the BLAS
 * would not give equal bits, and CHOLMOD's own loops over blocks would be slower, as their four
 * threads mostly wait (factor of 1 M vertices, METIS order, 2 cores: 5.3 s with four threads, 2.6 s
 * with one). */
typedef struct Threads {
	Blas openblas;
	int  blas, levels;
} Threads;

static Threads
one_thread(void)
{
	Threads t = { openblas(), 1, omp_get_max_active_levels() };

	if (t.openblas.set && t.openblas.get) {
		t.blas = t.openblas.get();
		t.openblas.set(1);
	}
	omp_set_max_active_levels(omp_get_active_level());
	return t;
}

static void
restore_threads(Threads t)
{
	if (t.openblas.set && t.openblas.get)
		t.openblas.set(t.blas);
	omp_set_max_active_levels(t.levels);
}

int
spd_solve(Spd *a, const int *order, int nrhs, double *B, SpdReport *report)
{
	Threads threads = one_thread();
	cholmod_sparse *A;
	Work w;

	start(&w);
	A = compress(a, &w.c);
	if (A) {
		analyze(&w, A, order ? CHOLMOD_GIVEN : CHOLMOD_AMD, order);
		solve(&w, A, nrhs, B);
	} else
		w.e = SPD_ENOMEM;
	cholmod_free_sparse(&A, &w.c);
	cholmod_finish(&w.c);
	restore_threads(threads);
	if (report)
		*report = w.r;
	return w.e;
}

struct SpdFactor {
	Work w;
	cholmod_sparse A;
	cholmod_dense *x, *y, *e;       /* solution and workspace, kept by CHOLMOD from solve to solve */
};

SpdFactor *
spd_factor_new(int n, int *column, int *row)
{
	SpdFactor *f = calloc(1, sizeof *f);
	Threads threads = one_thread();

	if (f) {
		start(&f->w);
		f->A = (cholmod_sparse){ .nrow = n, .ncol = n, .nzmax = column[n], .p = column, .i = row,
		    .stype = -1, .itype = CHOLMOD_INT, .xtype = CHOLMOD_PATTERN, .dtype = CHOLMOD_DOUBLE,
		    .sorted = 1, .packed = 1 };
		analyze(&f->w, &f->A, CHOLMOD_AMD, NULL);
	}
	restore_threads(threads);
	if (f && f->w.e) {
		spd_factor_free(f);
		f = NULL;
	}
	return f;
}

void
spd_factor_free(SpdFactor *f)
{
	if (!f)
		return;
	cholmod_free_dense(&f->x, &f->w.c);
	cholmod_free_dense(&f->y, &f->w.c);
	cholmod_free_dense(&f->e, &f->w.c);
	cholmod_free_factor(&f->w.L, &f->w.c);
	cholmod_finish(&f->w.c);
	free(f);
}

int
spd_factor_set(SpdFactor *f, double *value)
{
	Threads threads = one_thread();

	f->A.x = value;
	f->A.xtype = CHOLMOD_REAL;
	cholmod_factorize(&f->A, f->w.L, &f->w.c);
	restore_threads(threads);
	return f->w.e = status(&f->w.c, f->w.L, &f->w.r);
}

int
spd_factor_solve(SpdFactor *f, double *b)
{
	size_t n = f->A.nrow;
	cholmod_dense B = { .nrow = n, .ncol = 1, .nzmax = n, .d = n, .x = b,
	    .xtype = CHOLMOD_REAL, .dtype = CHOLMOD_DOUBLE };
	Threads threads = one_thread();
	int ok = cholmod_solve2(CHOLMOD_A, f->w.L, &B, NULL, &f->x, NULL, &f->y, &f->e, &f->w.c);

	restore_threads(threads);
	if (!ok)
		return SPD_ENOMEM;
	memcpy(b, f->x->x, n*sizeof *b);
	return 0;
}
