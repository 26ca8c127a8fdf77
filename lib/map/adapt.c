/* adapt.c - adaptive refinement: solve, split the triangles with the largest terms of the
 * certificate, solve again. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "adapt.h"
#include "corners.h"
#include "harmonic.h"
#include "rectmap.h"
#include "vertexkey.h"
#include "worst.h"
#include "../mesh/topology.h"
#include "../base/vec3.h"

enum { GRADED = 3 };                    /* splits of the faces at the corners, before any solve */
enum { GROWTH = 4, FEW = 20000 };       /* ADAPT_HARD if the certificate is above the tolerance with
                                         * more than FEW vertices, and more than GROWTH times as
                                         * many as in the first solve: the triangles are badly
                                         * shaped */

/* The term of triangle t (worst.h). */
static double
term(const AdaptMap *m, int t)
{
	const int *c = &m->mesh.d.m.tri[3*t];
	const double *x = m->mesh.d.m.xyz;
	double a[3], b[3], n[3];

	sub3(&x[3*c[1]], &x[3*c[0]], a);
	sub3(&x[3*c[2]], &x[3*c[0]], b);
	cross3(a, b, n);
	return worst_term(c, m->u, m->v, dot3(a, a), dot3(a, b), dot3(b, b), norm3(n)/2);
}

/* Marks the triangles with the largest terms (worst.h).  Returns their number, or SPD_ENOMEM.  The
 * number is 0 if `most` is 0, or if rounding leaves no positive sum of terms. */
static int
mark(const AdaptMap *m, int most, unsigned char *marked)
{
	int nf = m->mesh.d.m.nf, t, n = 0;
	double *terms = malloc(2*(size_t)nf*sizeof *terms), least;

	if (!terms)
		return SPD_ENOMEM;
	for (t = 0; t < nf; t++)
		terms[t] = term(m, t);
	least = worst_terms(terms, nf, most, terms + nf);
	for (t = 0; t < nf; t++)
		n += marked[t] = terms[t] >= least;
	free(terms);
	return n;
}

/* Solves for the map of m's mesh; with coarse not NULL, by quadratic elements on it (rectmap.h). */
static int
solve(AdaptMap *m, const Disk *coarse, const int vertex[4], SpdReport *report)
{
	const Disk *d = &m->mesh.d;
	int e, at;

	free(m->u);
	free(m->v);
	m->u = malloc(d->m.nv*sizeof *m->u);
	m->v = malloc(d->m.nv*sizeof *m->v);
	if (!m->u || !m->v)
		return SPD_ENOMEM;
	corners_given(d, vertex, m->corner, &at);
	e = rectmap(d, coarse, m->corner, m->u, m->v, &m->T, &m->certificate, report);
	return e == SPD_EINDEFINITE ? ADAPT_HARD : e;
}

/* Splits the marked faces of m's mesh into four.  Frees marked. */
static int
split_marked(AdaptMap *m, const int vertex[4], unsigned char *marked)
{
	double *key = vertex_keys(&m->mesh.d.m, vertex);
	int e = key ? subdivision_refine(&m->mesh, marked, key, NULL) : SPD_ENOMEM;

	free(key);
	free(marked);
	m->rounds++;
	return e ? SPD_ENOMEM : 0;
}

/* Splits the faces with the largest terms, at most `most` of them.  Returns their number, or
 * SPD_ENOMEM. */
static int
split_worst(AdaptMap *m, const int vertex[4], int most)
{
	unsigned char *marked = malloc(m->mesh.d.m.nf);
	int n = marked ? mark(m, most, marked) : SPD_ENOMEM;

	if (n <= 0) {
		free(marked);
		return n;
	}
	return split_marked(m, vertex, marked) ? SPD_ENOMEM : n;
}

/* Splits and solves until the certificate is small enough, there are o->most vertices, or no face
 * can be split.  Returns ADAPT_HARD if that takes too many vertices. */
static int
refine(AdaptMap *a, const AdaptOptions *o, const int vertex[4], SpdReport *report)
{
	int e = 0, n = 1, given = a->mesh.d.m.nv;

	while (!e && n > 0 && a->certificate > o->tolerance && a->mesh.d.m.nv < o->most) {
		if (a->mesh.d.m.nv > FEW && a->mesh.d.m.nv/GROWTH > given)
			return ADAPT_HARD;
		n = split_worst(a, vertex, (o->most - a->mesh.d.m.nv)/2);
		if (n < 0)
			e = SPD_ENOMEM;
		else if (n > 0)
			e = solve(a, NULL, vertex, report);
	}
	return e;
}

/* Splits all faces into four, o->split times or as often as o->most allows.  Then solves with
 * quadratic elements on the mesh before the last split. */
static int
split_all(AdaptMap *m, const AdaptOptions *o, const int vertex[4], SpdReport *report)
{
	Disk coarse = { 0 };
	int k, e = 0;

	for (k = 0; !e && k < o->split && m->mesh.d.m.nv <= o->most/4; k++) {
		disk_free(&coarse);
		coarse = (Disk){ 0 };
		e = subdivision_refine(&m->mesh, NULL, NULL, &coarse) ? SPD_ENOMEM : 0;
		m->rounds++;
	}
	m->quadratic = k > 0;
	if (!e && k > 0)
		e = solve(m, &coarse, vertex, report);
	disk_free(&coarse);
	return e;
}

/* Splits the faces at the corners into four.  Where the boundary is smooth at a corner, the map is
 * singular, and these faces would be split first anyway; splitting them now saves solves. */
static int
split_corners(AdaptMap *m, const int vertex[4])
{
	const Mesh *mesh = &m->mesh.d.m;
	unsigned char *marked = malloc(mesh->nf), *corner = calloc(mesh->nv, 1);
	int t, k;

	if (!marked || !corner) {
		free(marked);
		free(corner);
		return SPD_ENOMEM;
	}
	for (k = 0; k < 4; k++)
		corner[vertex[k]] = 1;
	for (t = 0; t < mesh->nf; t++) {
		const int *c = &mesh->tri[3*(size_t)t];

		marked[t] = corner[c[0]] | corner[c[1]] | corner[c[2]];
	}
	free(corner);
	return split_marked(m, vertex, marked);
}

/* Splits the inner edges between two vertices of the same side of the rectangle, because the map
 * would make the triangles that they cut off flat. */
static int
split_chords(AdaptMap *m, const int vertex[4])
{
	const Disk *d = &m->mesh.d;
	unsigned char *side = malloc(d->m.nv);
	SurfacePoint *point = malloc(3*(size_t)d->m.nf*sizeof *point);
	int h, at, n = 0;

	if (side && point) {
		corners_given(d, vertex, m->corner, &at);
		harmonic_sides(d, m->corner, side);
		for (h = 0; h < 3*d->m.nf; h++)
			if (d->twin[h] > h && side[d->m.tri[h]] & side[d->m.tri[topology_next(h)]])
				point[n++] = subdivision_on_side(h, 0.5);
		n = n > 0 ? subdivision_add(&m->mesh, n, point) : 0;
	} else
		n = SPD_ENOMEM;
	free(side);
	free(point);
	return n < 0 ? SPD_ENOMEM : 0;
}

/* Whether no triangle is turned over or flat in (u,v). */
static int
is_embedded(const AdaptMap *m)
{
	return rectmap_flipped(&m->mesh.d.m, m->u, m->v) == 0 && rectmap_flat(&m->mesh.d.m, m->u, m->v) == 0;
}

int
adapt_map(const Disk *d, const int vertex[4], const AdaptOptions *o, AdaptMap *a, SpdReport *report)
{
	int graded = o->tolerance < 1 && d->m.nv < o->most, e, k;

	memset(a, 0, sizeof *a);
	memset(report, 0, sizeof *report);
	e = subdivision_init(&a->mesh, d) ? SPD_ENOMEM : 0;
	for (k = 0; !e && graded && k < GRADED && a->mesh.d.m.nv < o->most; k++)
		e = split_corners(a, vertex);
	if (!e && graded)
		e = split_chords(a, vertex);
	if (!e)
		e = solve(a, NULL, vertex, report);
	if (!e)
		e = refine(a, o, vertex, report);
	if (!e)
		e = split_all(a, o, vertex, report);
	if (!e && !is_embedded(a))
		e = ADAPT_HARD;
	if (e)
		adapt_free(a);
	return e;
}

void
adapt_free(AdaptMap *a)
{
	subdivision_free(&a->mesh);
	free(a->u);
	free(a->v);
	a->u = a->v = NULL;
}
