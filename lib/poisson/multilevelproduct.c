/* multilevelproduct.c - the operator of one grid of multigrid, and the smoothing. */
#include "../base/cpu.h"
#include "multilevel.h"

/* The factors of the second differences along u and v in t K: t k/h and t h/k. */
typedef struct Edges {
	double u, v;
} Edges;

static Edges
edges(const Multilevel *l, double t)
{
	double ratio = chart_k(l->g)/chart_h(l->g);

	return (Edges){ t*ratio, t/ratio };
}

void
multilevel_diagonal(Multilevel *l, double t)
{
	Edges e = edges(l, t);
	int i, j;

	for (j = 0; j < l->n[1]; j++)
		for (i = 0; i < l->n[0]; i++) {
			size_t p = multilevel_place(l, i, j);

			l->inverse[p] = 1/(2*(e.u + e.v)*l->width[0][i]*l->width[1][j] + l->mass[p]);
		}
}

typedef enum Product { APPLY, RESIDUAL, RELAX } Product;

/* Row j of one of
 *
 *   APPLY     t K x + w M x
 *   RESIDUAL  b - A x
 *   RELAX     x + w D^-1 (b - A x) = (1 - w) x + w D^-1 (b + (D - A) x) */
INLINE void
fill_row(const Multilevel *l, Product what, Edges e, double w, int j, const double *x, double *out)
{
	size_t p = multilevel_place(l, 0, j), row = multilevel_row(l);
	const double *f = x + p, *s = f - row, *n = f + row, *m = l->mass + p, *b = l->b + p, *d = l->inverse + p;
	double u = e.u*l->width[1][j], v = e.v*l->width[1][j], both = 2*(u + v), sum;
	int i;

	out += p;
	for (i = 0; i < l->n[0]; i++) {
		sum = u*(f[i-1] + f[i+1]) + v*(s[i] + n[i]);
		if (what == APPLY)
			out[i] = l->width[0][i]*(both*f[i] - sum) + w*m[i]*f[i];
		else if (what == RESIDUAL)
			out[i] = b[i] - l->width[0][i]*(both*f[i] - sum) - m[i]*f[i];
		else
			out[i] = (1 - w)*f[i] + w*d[i]*(b[i] + l->width[0][i]*sum);
	}
}

TARGET("avx2") static void
fill_row_256(const Multilevel *l, Product what, Edges e, double w, int j, const double *x, double *out)
{
	switch (what) {
	case APPLY:    fill_row(l, APPLY, e, w, j, x, out); break;
	case RESIDUAL: fill_row(l, RESIDUAL, e, w, j, x, out); break;
	case RELAX:    fill_row(l, RELAX, e, w, j, x, out); break;
	}
}

static void
product(const Multilevel *l, Product what, double t, double w, double *x, double *out)
{
	Edges e = edges(l, t);
	int j;

	multilevel_fill_rim(l, x);
#pragma omp parallel for schedule(static) if(multilevel_many(l))
	for (j = 0; j < l->n[1]; j++)
		if (HAS("avx2"))
			fill_row_256(l, what, e, w, j, x, out);
		else
			fill_row(l, what, e, w, j, x, out);
}

void
multilevel_apply(const Multilevel *l, double t, double c, double *x, double *y)
{
	product(l, APPLY, t, c, x, y);
}

void
multilevel_residual(Multilevel *l, double t)
{
	product(l, RESIDUAL, t, 0, l->x, l->r);
}

void
multilevel_relax(Multilevel *l, double t, double w)
{
	double *swap = l->x;

	product(l, RELAX, t, w, l->x, l->r);
	l->x = l->r;
	l->r = swap;
}

void
multilevel_begin(Multilevel *l, double w)
{
	size_t n = multilevel_row(l)*(l->n[1] + 2), p;

	for (p = 0; p < n; p++)
		l->x[p] = w*l->inverse[p]*l->b[p];
}
