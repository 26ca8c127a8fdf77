/* stars.c - the order of the triangles at a vertex, and a choice among many of them. */
#include <math.h>
#include <stdlib.h>

#include "stars.h"
#include "../mesh/topology.h"

static const double WAVES = 100;        /* radians per side of a square as large as the chart, in
	                                 * chart_keys */

/* The directions of `direction` in the first eighth of the circle, as (cosine, sine).  The others are
 * their images under the symmetries of the square.  No regular polygon has a corner, or the middle
 * of a side, in one of them: the angles 0.2 and 0.57 are no fractions of pi.  So rounding never
 * decides which triangle of a regular fan a direction meets. */
static const double DIRECTION[STARS_FEW/8][2] = {
	{ 0.98006657784124163, 0.19866933079506122 }, { 0.84190097514622751, 0.53963204618835703 }
};

/* Sets a key for each vertex, a number by which to sort.  It depends only on the place in the
 * rectangle, not on the numbering of the vertices, and does not change when the rectangle is
 * reflected in u or v, or turned. */
static void
chart_keys(int nv, const double *u, const double *v, double *key)
{
	double T = 0, wave;
	int i;

	for (i = 0; i < nv; i++)
		T = fmax(T, v[i]);
	wave = T > 0 ? WAVES/sqrt(T) : WAVES;
	for (i = 0; i < nv; i++)
		key[i] = sin(wave*fabs(u[i] - 0.5)) + sin(wave*fabs(v[i] - T/2));
}

typedef struct Spoke {
	double key;
	int    side;
} Spoke;

static int
by_key(const void *a, const void *b)
{
	const Spoke *p = a, *q = b;

	return p->key != q->key ? (p->key < q->key ? -1 : 1) : (p->side > q->side) - (p->side < q->side);
}

/* Sorts the n triangles at a vertex by the sum of the keys of their two other vertices. */
static void
sort_star(const Mesh *m, const double *key, int n, int *side, Spoke *spoke)
{
	int k, l;
	Spoke next;

	for (k = 0; k < n; k++) {
		next = (Spoke){ 0, side[k] };
		next.key = key[m->tri[topology_next(side[k])]] + key[m->tri[topology_next(topology_next(side[k]))]];
		for (l = k; n <= STARS_FEW && l > 0 && by_key(&spoke[l-1], &next) > 0; l--)
			spoke[l] = spoke[l-1];
		spoke[l] = next;
	}
	if (n > STARS_FEW)
		qsort(spoke, n, sizeof *spoke, by_key);
	for (k = 0; k < n; k++)
		side[k] = spoke[k].side;
}

/* Direction k, 0..STARS_FEW-1, as a unit vector.  The directions are spread over the circle, and the
 * reflections and quarter turns of the rectangle exchange them. */
static void
direction(int k, double d[2])
{
	const double *e = DIRECTION[k/8];

	d[0] = k & 2 ? -e[k & 1] : e[k & 1];
	d[1] = k & 4 ? -e[!(k & 1)] : e[!(k & 1)];
}

/* If the ray in direction d from the corner at the start of this side passes through the triangle,
 * returns that of the two other corners whose direction is nearer to d; else -1. */
static int
nearest_end(const Mesh *m, const double *u, const double *v, int side, const double d[2])
{
	int o = m->tri[side], i = m->tri[topology_next(side)], j = m->tri[topology_next(topology_next(side))];
	double iu = u[i] - u[o], iv = v[i] - v[o], ju = u[j] - u[o], jv = v[j] - v[o], area = iu*jv - iv*ju;
	double after_i = iu*d[1] - iv*d[0], before_j = d[0]*jv - d[1]*ju;

	if (area > 0 ? after_i <= 0 || before_j <= 0 : after_i >= 0 || before_j >= 0)
		return -1;
	return fabs(after_i)*hypot(ju, jv) < fabs(before_j)*hypot(iu, iv) ? i : j;
}

/* Sets near to the neighbours of a hub in the directions of STARS_FEW rays, in the order of their
 * keys, and to -1 for rays that meet none of its n triangles.  If no ray meets any, all of them are
 * flat, and the first ones are taken. */
static void
choose(const Mesh *m, const double *u, const double *v, const double *key, int n, const int *side,
	int near[STARS_FEW])
{
	int k, l, i, found = 0;
	double d[2];

	for (k = 0; k < STARS_FEW; k++)
		near[k] = -1;
	for (k = 0; k < STARS_FEW; k++) {
		direction(k, d);
		for (i = -1, l = 0; l < n && i < 0; l++)
			i = nearest_end(m, u, v, side[l], d);
		if (i < 0)
			continue;
		for (l = found++; l > 0 && key[near[l-1]] > key[i]; l--)
			near[l] = near[l-1];
		near[l] = i;
	}
	for (k = 0; k < STARS_FEW && !found; k++)
		near[k] = m->tri[topology_next(side[k])];
}

/* Fills s->first and s->side.  Returns the largest number of triangles at a vertex. */
static int
fill(Stars *s, const Mesh *m)
{
	int i, k, most = 0;

	for (k = 0; k < 3*m->nf; k++)
		s->first[m->tri[k] + 2]++;
	for (i = 0; i < m->nv; i++) {
		most = s->first[i + 2] > most ? s->first[i + 2] : most;
		s->first[i + 2] += s->first[i + 1];
	}
	for (k = 0; k < 3*m->nf; k++)
		s->side[s->first[m->tri[k] + 1]++] = k;
	return most;
}

/* Numbers the hubs, and makes room for their neighbours. */
static int
find_hubs(Stars *s, int nv)
{
	int i, n = 0;

	s->hub = malloc(nv*sizeof *s->hub + 1);
	for (i = 0; s->hub && i < nv; i++)
		s->hub[i] = s->first[i + 1] - s->first[i] > STARS_FEW ? n++ : -1;
	s->near = malloc((size_t)n*STARS_FEW*sizeof *s->near + 1);
	return s->hub && s->near ? 0 : STARS_ENOMEM;
}

int
stars_init(Stars *s, const Mesh *m, const double *u, const double *v)
{
	double *key = malloc(m->nv*sizeof *key + 1);
	Spoke *spoke = NULL;
	int i;

	*s = (Stars){ .first = calloc((size_t)m->nv + 2, sizeof *s->first) };
	s->side = malloc((3*(size_t)m->nf + 1)*sizeof *s->side);
	if (key && s->first && s->side)
		spoke = malloc(fill(s, m)*sizeof *spoke + 1);
	if (spoke && !find_hubs(s, m->nv)) {
		chart_keys(m->nv, u, v, key);
		for (i = 0; i < m->nv; i++) {
			int n = s->first[i + 1] - s->first[i], *side = &s->side[s->first[i]];

			sort_star(m, key, n, side, spoke);
			if (s->hub[i] >= 0)
				choose(m, u, v, key, n, side, &s->near[STARS_FEW*(size_t)s->hub[i]]);
		}
	} else
		stars_free(s);
	free(key);
	free(spoke);
	return s->side ? 0 : STARS_ENOMEM;
}

void
stars_free(Stars *s)
{
	free(s->first);
	free(s->side);
	free(s->hub);
	free(s->near);
	*s = (Stars){ .first = NULL };
}
