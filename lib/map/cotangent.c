/* cotangent.c - cotangent weights, the matrix and its energy.  The order of summation does
 * not depend on the number of threads. */
#include <stdlib.h>
#include <string.h>

#include "cotangent.h"
#include "../base/vec3.h"

enum { BLOCK = 8192 };  /* triangles in one partial sum */

/* Half the cotangent of each angle of triangle t; w[k] is the weight of the edge opposite to
 * corner k. */
static void
half_cotangents(const Mesh *m, int t, double w[3])
{
	const int *c = &m->tri[3*(size_t)t];
	double a[3], b[3], n[3];
	int k;

	for (k = 0; k < 3; k++) {
		const double *x = &m->xyz[3*(size_t)c[k]];

		sub3(&m->xyz[3*(size_t)c[(k+1)%3]], x, a);
		sub3(&m->xyz[3*(size_t)c[(k+2)%3]], x, b);
		cross3(a, b, n);
		w[k] = dot3(a, b)/(2*norm3(n));         /* of the metric (3) */
	}
}

static void
block_energy(const Mesh *m, int block, const double *u, const double *v, double e[2])
{
	int t, k, end = m->nf - BLOCK*block < BLOCK ? m->nf : BLOCK*(block + 1);
	double w[3];

	e[0] = e[1] = 0;
	for (t = BLOCK*block; t < end; t++) {
		half_cotangents(m, t, w);
		for (k = 0; k < 3; k++) {
			int i = m->tri[3*(size_t)t + (k+1)%3], j = m->tri[3*(size_t)t + (k+2)%3];

			e[0] += w[k]*(u[i] - u[j])*(u[i] - u[j]);
			e[1] += w[k]*(v[i] - v[j])*(v[i] - v[j]);
		}
	}
}

int
cotangent_energy(const Mesh *m, const double *u, const double *v, double *Eu, double *Ev)
{
	int i, blocks = m->nf/BLOCK + 1;
	double (*e)[2] = malloc(blocks*sizeof *e);

	if (!e)
		return COTANGENT_ENOMEM;
#pragma omp parallel for
	for (i = 0; i < blocks; i++)
		block_energy(m, i, u, v, e[i]);
	for (*Eu = *Ev = 0, i = 0; i < blocks; i++) {
		*Eu += e[i][0];
		*Ev += e[i][1];
	}
	free(e);
	return 0;
}

/* Row i has one entry for every side of a face that starts at i, and one for the boundary
 * edge that ends at i.  place[3*t + k] is the entry of the side opposite to corner k of face
 * t; next is workspace, [nv]. */
static void
find_places(Cotangent *C, const Disk *d, int *next)
{
	int *first = C->g.first, i;
	size_t s, nf = d->m.nf;

	memset(first, 0, (d->m.nv + 1)*sizeof *first);
	for (s = 0; s < 3*nf; s++)
		first[d->m.tri[s]+1]++;
	for (i = 0; i < d->nb; i++)
		first[d->loop[i]+1]++;
	for (i = 0; i < d->m.nv; i++)
		first[i+1] += first[i];
	memcpy(next, first, d->m.nv*sizeof *next);
	for (s = 0; s < 3*nf; s++) {
		const int *t = &d->m.tri[s - s%3];
		int from = t[(s+1)%3], to = t[(s+2)%3];

		C->place[s] = next[from]++;
		C->g.adj[C->place[s]] = to;
	}
	for (i = 0; i < d->nb; i++)
		C->g.adj[next[d->loop[(i+1)%d->nb]]++] = d->loop[i];
}

/* For each edge of vertex i to a vertex of higher number: sets its two entries, C_ij and C_ji, to
 * their sum. */
static void
add_transpose(Cotangent *C, int i)
{
	int k, l;
	double sum;

	for (k = C->g.first[i]; k < C->g.first[i+1]; k++)
		if (i < C->g.adj[k]) {
			for (l = C->g.first[C->g.adj[k]]; C->g.adj[l] != i; l++)
				;
			sum = C->c[k] + C->c[l];
			C->c[k] = C->c[l] = sum;
		}
}

/* Writes the weights of triangle t to the entries of its sides. */
static void
enter_weights(Cotangent *C, const Mesh *m, int t)
{
	double w[3];
	int k;

	half_cotangents(m, t, w);
	for (k = 0; k < 3; k++)
		C->c[C->place[3*(size_t)t + k]] = -w[k];
}

int
cotangent_graph(Cotangent *C, const Disk *d)
{
	size_t sides = 3*(size_t)d->m.nf;
	int *next = malloc(d->m.nv*sizeof *next);

	C->g.n = d->m.nv;
	C->g.first = malloc((d->m.nv + (size_t)1)*sizeof *C->g.first);
	C->g.adj = malloc((sides + d->nb)*sizeof *C->g.adj);
	C->c = calloc(sides + d->nb, sizeof *C->c);
	C->place = malloc(sides*sizeof *C->place);
	if (!next || !C->g.first || !C->g.adj || !C->c || !C->place) {
		free(next);
		cotangent_free(C);
		return COTANGENT_ENOMEM;
	}
	find_places(C, d, next);
	free(next);
	return 0;
}

void
cotangent_values(Cotangent *C, const Disk *d)
{
	int i;

#pragma omp parallel for
	for (i = 0; i < d->m.nf; i++)
		enter_weights(C, &d->m, i);
#pragma omp parallel for schedule(static)
	for (i = 0; i < d->m.nv; i++)
		add_transpose(C, i);
	free(C->place);
	C->place = NULL;
}

int
cotangent_init(Cotangent *C, const Disk *d)
{
	int e = cotangent_graph(C, d);

	if (!e)
		cotangent_values(C, d);
	return e;
}

/* Appends row i of C, times a factor, to another matrix from entry k on.  Returns the index after
 * the last entry. */
static int
append_row(Cotangent *to, int k, const Cotangent *C, int i, double factor)
{
	int l;

	for (l = C->g.first[i]; l < C->g.first[i+1]; l++, k++) {
		to->g.adj[k] = C->g.adj[l];
		to->c[k] = factor*C->c[l];
	}
	return k;
}

int
cotangent_quadratic(Cotangent *fine, const Cotangent *coarse)
{
	size_t n = fine->g.n, places = fine->g.first[n] + (size_t)coarse->g.first[coarse->g.n];
	Cotangent C = { .g = { .n = n } };
	int i, k = 0;

	C.g.first = malloc((n + 1)*sizeof *C.g.first);
	C.g.adj = malloc(places*sizeof *C.g.adj);
	C.c = malloc(places*sizeof *C.c);
	if (!C.g.first || !C.g.adj || !C.c) {
		cotangent_free(&C);
		return COTANGENT_ENOMEM;
	}
	for (i = 0; i < fine->g.n; i++) {
		C.g.first[i] = k;
		k = append_row(&C, k, fine, i, 4.0/3);
		if (i < coarse->g.n)
			k = append_row(&C, k, coarse, i, -1.0/3);
	}
	C.g.first[n] = k;
	cotangent_free(fine);
	*fine = C;
	return 0;
}

void
cotangent_free(Cotangent *C)
{
	free(C->g.first);
	free(C->g.adj);
	free(C->c);
	free(C->place);
	memset(C, 0, sizeof *C);
}
