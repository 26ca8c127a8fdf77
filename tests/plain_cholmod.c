/* plain_cholmod.c - a program to compare the speed of mesh2rect with.  It solves the two cotangent
 * systems of a mesh file by CHOLMOD with its defaults (the AMD ordering, METIS if AMD's ordering is
 * bad, and the default number of BLAS threads).
 *
 * usage: plain_cholmod MESH
 * prints the number of vertices, the seconds of reading, the seconds of the two solves with their
 * assembly, T, and the peak memory of the whole process.  The program only measures; it tests
 * nothing. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <time.h>

#include <suitesparse/cholmod.h>

#include "../lib/map/corners.h"
#include "../lib/map/rectmap.h"
#include "../lib/base/vec3.h"
#include "cotapply.h"
#include "diskfile.h"

static double
now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_MONOTONIC, &t);
	return t.tv_sec + 1e-9*t.tv_nsec;
}

static void
entry(cholmod_triplet *t, int i, int j, double x)
{
	((int *)t->i)[t->nnz] = i > j ? i : j;
	((int *)t->j)[t->nnz] = i > j ? j : i;
	((double *)t->x)[t->nnz++] = x;
}

/* Half the cotangent of the angle of triangle t at its corner k. */
static double
half_cotangent(const Mesh *m, int t, int k)
{
	const int *c = &m->tri[3*(size_t)t];
	const double *x = &m->xyz[3*(size_t)c[k]];
	double a[3], b[3], n[3];

	sub3(&m->xyz[3*(size_t)c[(k+1)%3]], x, a);
	sub3(&m->xyz[3*(size_t)c[(k+2)%3]], x, b);
	cross3(a, b, n);
	return dot3(a, b)/(2*norm3(n));
}

static cholmod_sparse *
assemble(const Mesh *m, const int *number, int n, cholmod_common *c)
{
	cholmod_triplet *t = cholmod_allocate_triplet(n, n, 9*(size_t)m->nf, -1, CHOLMOD_REAL, c);
	cholmod_sparse *A;
	int f, k;

	if (!t)
		quit("no memory");
	for (f = 0; f < m->nf; f++)
		for (k = 0; k < 3; k++) {
			int i = number[m->tri[3*(size_t)f + (k+1)%3]], j = number[m->tri[3*(size_t)f + (k+2)%3]];
			double w = half_cotangent(m, f, k);

			if (i >= 0)
				entry(t, i, i, w);
			if (j >= 0)
				entry(t, j, j, w);
			if (i >= 0 && j >= 0)
				entry(t, i, j, -w);
		}
	A = cholmod_triplet_to_sparse(t, 0, c);
	cholmod_free_triplet(&t, c);
	return A;
}

static cholmod_dense *
solve(cholmod_sparse *A, cholmod_dense *b, cholmod_common *c)
{
	cholmod_factor *L = cholmod_analyze(A, c);
	cholmod_dense *x;

	if (!L || !cholmod_factorize(A, L, c) || c->status != CHOLMOD_OK)
		quit("the factorisation failed");
	if (!(x = cholmod_solve(CHOLMOD_A, L, b, c)))
		quit("no memory");
	cholmod_free_factor(&L, c);
	return x;
}

static void
hold(const Disk *d, int a, int b, double value, double *x, int *number)
{
	int i;

	for (i = a; ; i = (i + 1)%d->nb) {
		x[d->loop[i]] = value;
		number[d->loop[i]] = -1;
		if (i == b)
			break;
	}
}

/* The Dirichlet energy of the harmonic function that is 0 on the side that begins at corner k and
 * 1 on the opposite side. */
static double
harmonic(const Disk *d, const int corner[4], int k)
{
	int nv = d->m.nv, n = 0, i, *number = calloc(nv, sizeof *number);
	double *x = calloc(nv, sizeof *x), *y = malloc(nv*sizeof *y), e = 0;
	cholmod_common c;
	cholmod_sparse *A;
	cholmod_dense *b, *s;

	if (!number || !x || !y)
		quit("no memory");
	cholmod_start(&c);
	hold(d, corner[k], corner[(k+1)%4], 0, x, number);
	hold(d, corner[(k+2)%4], corner[(k+3)%4], 1, x, number);
	cotangent_apply(&d->m, x, y);
	for (i = 0; i < nv; i++)
		if (number[i] >= 0) {
			y[n] = -y[i];
			number[i] = n++;
		}
	A = assemble(&d->m, number, n, &c);
	b = cholmod_allocate_dense(n, 1, n, CHOLMOD_REAL, &c);
	if (!A || !b)
		quit("no memory");
	memcpy(b->x, y, n*sizeof *y);
	s = solve(A, b, &c);
	for (i = 0; i < nv; i++)
		if (number[i] >= 0)
			x[i] = ((double *)s->x)[number[i]];
	cotangent_apply(&d->m, x, y);
	for (i = 0; i < nv; i++)
		e += x[i]*y[i];
	cholmod_free_sparse(&A, &c);
	cholmod_free_dense(&b, &c);
	cholmod_free_dense(&s, &c);
	cholmod_finish(&c);
	free(number);
	free(x);
	free(y);
	return e;
}

int
main(int argc, char *argv[])
{
	double start = now(), read, Eu, Ev;
	struct rusage use;
	int corner[4];
	Disk d;

	if (argc != 2)
		quit("one mesh file is wanted");
	load(argv[1], &d);
	if (corners_auto(&d, corner) < 0)
		quit("no memory");
	read = now();
	Eu = harmonic(&d, corner, 3);
	Ev = harmonic(&d, corner, 0);
	getrusage(RUSAGE_SELF, &use);
	printf("vertices %d read %.3f s solves %.3f s T %.6f peak %.0f MB\n", d.m.nv, read - start,
	    now() - read, sqrt(Eu/Ev), use.ru_maxrss/1024.0);
	disk_free(&d);
	return 0;
}
