/* closed.c - the fit of one closed surface to another, and of its cones. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/procrustes.h"
#include "closed.h"
#include "positions.h"
#include "turns.h"

/* The nodes of a surface: positions [n][3], and the share of the area at each. */
typedef struct Nodes {
	int     n;
	double *x, *share;
} Nodes;

/* Sets s to the nodes of g, by the channels of its start, or x y z.  Returns 0 if it has none. */
static int
nodes_init(Nodes *s, const Lhg *g)
{
	static const char *const name[2][3] = { { "start.x", "start.y", "start.z" }, { "x", "y", "z" } };
	const double *lambda = lhg_find(g, "lambda")->f;
	double sum = 0;
	int k, c, p;

	for (k = 0; k < 2 && !lhg_find(g, name[k][0]); k++)
		;
	for (c = 0; c < 3; c++)
		if (k == 2 || !lhg_find(g, name[k][c]) || lhg_find(g, name[k][c])->support != LHG_GRID)
			return 0;
	s->n = g->nu*g->nv;
	s->x = cmd_alloc(s->n, 4*sizeof *s->x);
	s->share = s->x + 3*(size_t)s->n;
	for (p = 0; p < s->n; p++)
		sum += lambda[p]*lambda[p];
	for (p = 0; p < s->n; p++) {
		s->share[p] = lambda[p]*lambda[p]/sum;
		for (c = 0; c < 3; c++)
			s->x[3*p+c] = lhg_find(g, name[k][c])->f[p];
	}
	return 1;
}

/* The node to which node p goes in the way k to lay the pillow onto itself: by half its width, if k is odd, and by a turn that
 * exchanges its folds, from k = 2 on. */
static int
turned(const Lhg *g, int k, int p)
{
	int i = p%g->nu, j = p/g->nu;

	if (k & 1)
		i = (i + g->nu/2)%g->nu;
	if (k & 2) {
		i = g->nu - 1 - i;
		j = g->nv - 1 - j;
	}
	return j*g->nu + i;
}

/* The rigid motion r of the nodes b, turned in the way k, onto a.  Returns their distance over the radius of a. */
static double
fit(const Lhg *g, const Nodes *a, const Nodes *b, int k, Rigid *r)
{
	double *x = cmd_alloc(a->n, 4*sizeof *x), *w = x + 3*(size_t)a->n, mean[3] = { 0 }, radius = 0, rms, d;
	int p, q, c;

	for (p = 0; p < a->n; p++) {
		q = turned(g, k, p);
		w[p] = (a->share[p] + b->share[q])/2;
		for (c = 0; c < 3; c++) {
			x[3*p+c] = b->x[3*q+c];
			mean[c] += a->share[p]*a->x[3*p+c];
		}
	}
	for (p = 0; p < a->n; p++)
		for (c = 0; c < 3; c++) {
			d = a->x[3*p+c] - mean[c];
			radius += a->share[p]*d*d;
		}
	rms = procrustes(a->n, w, a->x, x, r, &d) ? HUGE_VAL : d/sqrt(radius);
	free(x);
	return rms;
}

/* The cones of the pillow in their order after each way. */
static const char *const ORDER[TURNS] = { "", "2,1,4,3", "3,4,1,2", "4,3,2,1" };

/* The way to turn b that fits a clearly better than none, or 0. */
static int
choose_way(const Source *A, const Nodes *a, const Source *B, const Nodes *b, int aligned)
{
	double rms[TURNS], angle[TURNS];
	int k, best;
	Rigid r;

	for (k = 0; k < TURNS; k++) {
		rms[k] = fit(&A->g, a, b, k, &r);
		angle[k] = rms[k] < HUGE_VAL ? rigid_angle(&r) : M_PI;
	}
	best = turns_better(rms, angle, aligned);
	if (best && aligned)
		note("%s is laid on with its cones in the order %s: the surfaces are then %.2g of their size apart, otherwise "
		    "%.2g", B->in.name, ORDER[best], rms[best], rms[0]);
	else if (best)
		note("%s fits %s better with its cones in the order %s (--align): the surfaces are then %.2g of their size "
		    "apart after a rotation by %.0f degrees, now %.2g after %.0f", B->in.name, A->in.name, ORDER[best],
		    rms[best], angle[best]*180/M_PI, rms[0], angle[0]*180/M_PI);
	return best;
}

/* Turns the fields of g in the way k.  They are the same at a point and its image, except tau1 and tau2, which belong to
 * the directions of u and v. */
static void
turn_fields(Lhg *g, int k)
{
	int n = g->nu*g->nv, p;
	double *f = cmd_alloc(n, sizeof *f), sign;
	LhgChannel *c;

	for (c = g->chan; c < g->chan + g->nchan; c++) {
		sign = k & 2 && (strcmp(c->name, "tau1") == 0 || strcmp(c->name, "tau2") == 0) ? -1 : 1;
		for (p = 0; p < n; p++)
			f[p] = sign*c->f[turned(g, k, p)];
		memcpy(c->f, f, n*sizeof *f);
	}
	free(f);
}

static void
align(const Source *A, const Nodes *a, Source *B, const Nodes *b, int k)
{
	Rigid r;
	double rms = fit(&A->g, a, b, k, &r);

	if (!(rms < HUGE_VAL))
		die("%s cannot be moved onto %s", B->in.name, A->in.name);
	turn_fields(&B->g, k);
	positions_move(&B->g, &r);
	detail("%s turned by %.4g degrees and moved by (%g,%g,%g): nodes %.3g of the size apart (rms)", B->in.name,
	    rigid_angle(&r)*180/M_PI, r.t[0], r.t[1], r.t[2], rms);
}

void
closed_fit(const Source *A, Source *B, int aligned)
{
	Nodes a = { 0 }, b = { 0 };
	int k;

	if (nodes_init(&a, &A->g) && nodes_init(&b, &B->g)) {
		k = choose_way(A, &a, B, &b, aligned);
		if (aligned)
			align(A, &a, B, &b, k);
	} else if (aligned)
		die("%s: --align needs the channels start.x start.y start.z: run grid2lh without --no-lattice",
			a.x ? B->in.name : A->in.name);
	free(a.x);
	free(b.x);
}
