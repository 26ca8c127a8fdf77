/* intrinsicmatrix.c - matrices and energies of an intrinsic triangulation. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "intrinsicmatrix.h"

static const double LEAST = 1e-10;      /* replaces smaller weights, which come from rounding or
                                         * from obtuse angles left at the boundary */

void
intrinsic_matrix_free(IntrinsicMatrix *a)
{
	free(a->g.first);
	free(a->g.adj);
	free(a->off);
}

/* In each row, replaces the entries of the same column by their sum.  seen: workspace, [n], -1 on
 * entry. */
static void
join_entries(IntrinsicMatrix *a, int *seen)
{
	int i, k, n = 0, begin = 0;

	for (i = 0; i < a->g.n; i++) {
		int end = a->g.first[i+1], start = n;

		for (k = begin; k < end; k++) {
			int j = a->g.adj[k];

			if (seen[j] >= start) {
				a->off[seen[j]] += a->off[k];
				continue;
			}
			seen[j] = n;
			a->g.adj[n] = j;
			a->off[n++] = a->off[k];
		}
		begin = end;
		a->g.first[i+1] = n;
	}
}

static double
weight(const Intrinsic *t, int e)
{
	int h = t->side[e], g = t->twin[h];

	return (intrinsic_cotangent(t, h) + (g >= 0 ? intrinsic_cotangent(t, g) : 0))/2;
}

/* The off-diagonal entries (i,j) and (j,i) of a symmetric matrix. */
typedef struct Entry {
	int    i, j;
	double x;
} Entry;

/* The matrix of n unknowns with the given entries; several entries of the same place are added. */
static int
matrix_init(IntrinsicMatrix *a, int n, size_t entries, const Entry *entry)
{
	int *next = malloc(n*sizeof *next), *first, i;
	size_t k;

	*a = (IntrinsicMatrix){ { n, calloc(n + (size_t)1, sizeof(int)), malloc(2*entries*sizeof(int)) },
		malloc(2*entries*sizeof(double)) };
	if (!next || !a->g.first || !a->g.adj || !a->off) {
		free(next);
		intrinsic_matrix_free(a);
		return INTRINSIC_ENOMEM;
	}
	first = a->g.first;
	for (k = 0; k < entries; k++) {
		first[entry[k].i + 1]++;
		first[entry[k].j + 1]++;
	}
	for (i = 0; i < n; i++)
		first[i+1] += first[i];
	memcpy(next, first, n*sizeof *next);
	for (k = 0; k < entries; k++) {
		int at = next[entry[k].i]++, to = next[entry[k].j]++;

		a->g.adj[at] = entry[k].j;
		a->g.adj[to] = entry[k].i;
		a->off[at] = a->off[to] = entry[k].x;
	}
	memset(next, -1, n*sizeof *next);
	join_entries(a, next);
	free(next);
	return 0;
}

int
intrinsic_linear(const Intrinsic *t, IntrinsicMatrix *a)
{
	Entry *entry = malloc(t->ne*sizeof *entry);
	int e, n = 0, error = INTRINSIC_ENOMEM, end[2];

	if (entry) {
		for (e = 0; e < t->ne; e++) {
			intrinsic_ends(t, e, end);
			if (end[0] != end[1])
				entry[n++] = (Entry){ end[0], end[1], -fmax(weight(t, e), LEAST) };
		}
		error = matrix_init(a, t->nv, n, entry);
	}
	free(entry);
	return error;
}

void
intrinsic_middles(const Intrinsic *t, const unsigned char *straight, Middles *m)
{
	int e;

	m->n = t->nv;
	for (e = 0; e < t->ne; e++)
		m->unknown[e] = straight[e] ? -1 : m->n++;
}

typedef struct Entries {
	const Intrinsic *t;
	const Middles   *m;
	Entry           *entry;         /* NULL: entries are only counted */
	size_t           n;
} Entries;

/* Adds w (x_p - x_q)^2 to the energy.  p and q are vertices, or nv + e for the middle of edge e.
 * At the middle of a straight edge ij there is no unknown, so the identity is used: with x_p = (x_i
 * + x_j)/2, (x_p - x_q)^2 = (x_i - x_q)^2/2 + (x_j - x_q)^2/2 - (x_i - x_j)^2/4. */
static void
add_difference(Entries *a, int p, int q, double w)
{
	int nv = a->t->nv, end[2], swap;

	if (p == q)
		return;
	if (q >= nv && a->m->unknown[q-nv] < 0)
		swap = p, p = q, q = swap;
	if (p >= nv && a->m->unknown[p-nv] < 0) {
		intrinsic_ends(a->t, p - nv, end);
		add_difference(a, end[0], q, w/2);
		add_difference(a, end[1], q, w/2);
		add_difference(a, end[0], end[1], -w/4);
		return;
	}
	p = p < nv ? p : a->m->unknown[p-nv];
	q = q < nv ? q : a->m->unknown[q-nv];
	if (a->entry)
		a->entry[a->n] = (Entry){ p, q, -w };
	a->n++;
}

static void
add_elements(Entries *a)
{
	const Intrinsic *t = a->t;
	int e, h, end[2];

	for (e = 0; e < t->ne; e++) {
		double w = weight(t, e);

		intrinsic_ends(t, e, end);
		add_difference(a, end[0], t->nv + e, 4*w/3);
		add_difference(a, end[1], t->nv + e, 4*w/3);
		add_difference(a, end[0], end[1], -w/3);
	}
	for (h = 0; h < 3*t->nf; h++)
		add_difference(a, t->nv + t->edge[intrinsic_next(h)], t->nv + t->edge[intrinsic_last(h)],
		    4*intrinsic_cotangent(t, h)/3);
}

int
intrinsic_quadratic(const Intrinsic *t, const Middles *m, IntrinsicMatrix *a)
{
	Entries all = { t, m, NULL, 0 };
	int error = INTRINSIC_ENOMEM;

	add_elements(&all);
	all.entry = malloc(all.n*sizeof *all.entry);
	all.n = 0;
	if (all.entry) {
		add_elements(&all);
		error = matrix_init(a, m->n, all.n, all.entry);
	}
	free(all.entry);
	return error;
}

void
intrinsic_middle_sides(const Intrinsic *t, const Middles *m, unsigned char *side)
{
	int e, end[2];

	for (e = 0; e < t->ne; e++) {
		intrinsic_ends(t, e, end);
		if (m->unknown[e] >= 0)
			side[m->unknown[e]] = t->twin[t->side[e]] < 0 ? side[end[0]] & side[end[1]] : 0;
	}
}

void
intrinsic_middle_values(const Intrinsic *t, const Middles *m, double *x)
{
	int e, end[2];

	for (e = t->ne - 1; e >= 0; e--)
		if (m->unknown[e] >= 0)
			x[t->nv + e] = x[m->unknown[e]];
	for (e = 0; e < t->ne; e++)
		if (m->unknown[e] < 0) {
			intrinsic_ends(t, e, end);
			x[t->nv + e] = (x[end[0]] + x[end[1]])/2;
		}
}

double
intrinsic_energy(const Intrinsic *t, const double *x)
{
	double sum = 0;
	int e, end[2];

	for (e = 0; e < t->ne; e++) {
		intrinsic_ends(t, e, end);
		sum += weight(t, e)*(x[end[0]] - x[end[1]])*(x[end[0]] - x[end[1]]);
	}
	return sum;
}

double
intrinsic_quadratic_energy(const Intrinsic *t, const double *x)
{
	const double *middle = x + t->nv;
	double fine = 0;
	int e, h, end[2];

	for (e = 0; e < t->ne; e++) {
		double a, b;

		intrinsic_ends(t, e, end);
		a = x[end[0]] - middle[e], b = x[end[1]] - middle[e];
		fine += weight(t, e)*(a*a + b*b);
	}
	for (h = 0; h < 3*t->nf; h++) {
		double d = middle[t->edge[intrinsic_next(h)]] - middle[t->edge[intrinsic_last(h)]];

		fine += intrinsic_cotangent(t, h)*d*d;
	}
	return (4*fine - intrinsic_energy(t, x))/3;
}
