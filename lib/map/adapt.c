/* adapt.c - adaptive refinement: solve, split the facets with the largest share of the
 * certificate, solve again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adapt.h"
#include "rectmap.h"
#include "../mesh/refine.h"
#include "../base/vec3.h"

enum { GRADED = 3 };                    /* splits of the faces at the corners before any solve */
static const double SHARE = 0.7;        /* of the certificate that the faces to split hold together */

/* The term of triangle t in the sum for T certificate (adapt.h).  With a, b its sides at
 * corner 0, g their Gram matrix and A its area, grad u . grad u = (u_b^2 g_aa - 2 u_a u_b g_ab + u_a^2 g_bb)/(4 A^2). */
static double
term(const AdaptMap *m, int t)
{
	const int *c = &m->d.m.tri[3*t];
	const double *x = m->d.m.xyz;
	double a[3], b[3], n[3], area, gaa, gab, gbb, energy;
	double ua = m->u[c[1]] - m->u[c[0]], ub = m->u[c[2]] - m->u[c[0]];
	double va = m->v[c[1]] - m->v[c[0]], vb = m->v[c[2]] - m->v[c[0]];

	sub3(&x[3*c[1]], &x[3*c[0]], a);
	sub3(&x[3*c[2]], &x[3*c[0]], b);
	cross3(a, b, n);
	area = norm3(n)/2;
	gaa = dot3(a, a), gab = dot3(a, b), gbb = dot3(b, b);
	energy = (ub*ub + vb*vb)*gaa - 2*(ua*ub + va*vb)*gab + (ua*ua + va*va)*gbb;
	return energy/(8*area) - (ua*vb - ub*va)/2;
}

typedef struct Ranked {
	double term;
	int    t;
} Ranked;

static int
larger_first(const void *a, const void *b)
{
	const Ranked *x = a, *y = b;

	if (x->term != y->term)
		return x->term < y->term ? 1 : -1;
	return x->t > y->t ? 1 : -1;
}

/* Marks the triangles with the largest terms: the fewest that hold SHARE of the certificate,
 * and at most `most`.  Returns their number, or SPD_ENOMEM.  It is 0 if `most` is 0 or if
 * rounding leaves no term above 0. */
static int
mark(const AdaptMap *m, int most, unsigned char *marked)
{
	int nf = m->d.m.nf, t, k;
	Ranked *r = malloc(nf*sizeof *r);
	double all = 0, sum = 0;

	if (!r)
		return SPD_ENOMEM;
	memset(marked, 0, nf);
	for (t = 0; t < nf; t++) {
		r[t] = (Ranked){ term(m, t), t };
		all += r[t].term;
	}
	qsort(r, nf, sizeof *r, larger_first);
	for (k = 0; k < nf && k < most && sum < SHARE*all; k++) {
		sum += r[k].term;
		marked[r[k].t] = 1;
	}
	free(r);
	return k;
}

static int
solve(AdaptMap *m, const Disk *coarse, const int vertex[4], SpdReport *report)
{
	int i, k;

	free(m->u);
	free(m->v);
	m->u = malloc(m->d.m.nv*sizeof *m->u);
	m->v = malloc(m->d.m.nv*sizeof *m->v);
	if (!m->u || !m->v)
		return SPD_ENOMEM;
	for (i = 0; i < m->d.nb; i++)
		for (k = 0; k < 4; k++)
			if (m->d.loop[i] == vertex[k])
				m->corner[k] = i;
	return rectmap(&m->d, coarse, m->corner, m->u, m->v, &m->T, &m->certificate, report);
}

/* Splits the marked faces of d, which may be m's own disk, into four; the result is m's disk.
 * Frees marked. */
static int
split_marked(AdaptMap *m, const Disk *d, unsigned char *marked)
{
	Disk finer;
	int e = refine_split(d, marked, &finer);

	free(marked);
	if (e)
		return SPD_ENOMEM;
	disk_free(&m->d);
	m->d = finer;
	m->rounds++;
	return 0;
}

/* Splits the faces with the largest terms, at most `most` of them.  Returns their number, or
 * SPD_ENOMEM. */
static int
split_worst(AdaptMap *m, int most)
{
	unsigned char *marked = malloc(m->d.m.nf);
	int n = marked ? mark(m, most, marked) : SPD_ENOMEM;

	if (n <= 0) {
		free(marked);
		return n;
	}
	return split_marked(m, &m->d, marked) ? SPD_ENOMEM : n;
}

/* Splits and solves until the certificate is small enough, or no face can be split. */
static int
refine(AdaptMap *a, const AdaptOptions *o, const int vertex[4], SpdReport *report)
{
	int e = 0, n = 1;

	while (!e && n > 0 && a->certificate > o->tolerance && a->d.m.nv < o->most) {
		n = split_worst(a, (o->most - a->d.m.nv)/2);
		if (n < 0)
			e = SPD_ENOMEM;
		else if (n > 0)
			e = solve(a, NULL, vertex, report);
	}
	return e;
}

/* Splits all faces into four, o->split times or as often as o->most allows, and solves with
 * quadratic elements on the mesh before the last split. */
static int
split_all(AdaptMap *m, const AdaptOptions *o, const int vertex[4], SpdReport *report)
{
	Disk coarse = { 0 }, finer;
	int k, e = 0;

	for (k = 0; !e && k < o->split && m->d.m.nv <= o->most/4; k++) {
		e = refine_split(&m->d, NULL, &finer) ? SPD_ENOMEM : 0;
		if (e)
			break;
		disk_free(&coarse);
		coarse = m->d;
		m->d = finer;
		m->rounds++;
	}
	m->quadratic = k > 0;
	if (!e && k > 0)
		e = solve(m, &coarse, vertex, report);
	disk_free(&coarse);
	return e;
}

/* Splits the faces of d at the corners into four; the result is m's disk.  At a corner on a
 * smooth boundary the map is singular: these faces would be the first to be split anyway, and
 * a solve is saved. */
static int
split_corners(AdaptMap *m, const Disk *d, const int vertex[4])
{
	unsigned char *marked = malloc(d->m.nf), *corner = calloc(d->m.nv, 1);
	int t, k;

	if (!marked || !corner) {
		free(marked);
		free(corner);
		return SPD_ENOMEM;
	}
	for (k = 0; k < 4; k++)
		corner[vertex[k]] = 1;
	for (t = 0; t < d->m.nf; t++) {
		const int *c = &d->m.tri[3*t];

		marked[t] = corner[c[0]] | corner[c[1]] | corner[c[2]];
	}
	free(corner);
	return split_marked(m, d, marked);
}

static void *
duplicate(const void *p, size_t bytes)
{
	void *q = malloc(bytes);

	return q ? memcpy(q, p, bytes) : NULL;
}

/* A deep copy of the mesh, the loop and the twins of d. */
static int
copy_disk(const Disk *d, Disk *copy)
{
	*copy = (Disk){ .m = { .nv = d->m.nv, .nf = d->m.nf }, .nb = d->nb };
	copy->m.xyz = duplicate(d->m.xyz, 3*(size_t)d->m.nv*sizeof(double));
	copy->m.tri = duplicate(d->m.tri, 3*(size_t)d->m.nf*sizeof(int));
	copy->loop = duplicate(d->loop, d->nb*sizeof(int));
	copy->twin = duplicate(d->twin, 3*(size_t)d->m.nf*sizeof(int));
	return copy->m.xyz && copy->m.tri && copy->loop && copy->twin ? 0 : SPD_ENOMEM;
}

int
adapt_map(const Disk *d, const int vertex[4], const AdaptOptions *o, AdaptMap *a, SpdReport *report)
{
	int graded = o->tolerance < 1 && d->m.nv < o->most, e, k;

	memset(a, 0, sizeof *a);
	e = graded ? split_corners(a, d, vertex) : copy_disk(d, &a->d);
	for (k = 1; !e && graded && k < GRADED && a->d.m.nv < o->most; k++)
		e = split_corners(a, &a->d, vertex);
	if (!e)
		e = solve(a, NULL, vertex, report);
	if (!e)
		e = refine(a, o, vertex, report);
	if (!e)
		e = split_all(a, o, vertex, report);
	if (e)
		adapt_free(a);
	return e;
}

void
adapt_free(AdaptMap *a)
{
	disk_free(&a->d);
	free(a->u);
	free(a->v);
	a->u = a->v = NULL;
}
