/* stars.c - the order of the triangles at a vertex, and a choice among many of them. */
#include <math.h>
#include <stdlib.h>

#include "stars.h"
#include "../mesh/topology.h"

static const double WAVES = 100;        /* radians per side of a square as large as the chart, in
	                                 * chart_keys */

/* The directions of `meets` in the first eighth of the circle, as (cosine, sine).  The others are
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

/* Whether a ray in one of STARS_FEW directions, from the corner at the start of this side, passes
 * through the triangle.  The directions are spread over the circle, and the reflections and quarter
 * turns of the rectangle exchange them. */
static int
meets(const Mesh *m, const double *u, const double *v, int side)
{
	int o = m->tri[side], i = m->tri[topology_next(side)];
	int j = m->tri[topology_next(topology_next(side))], k;
	double iu = u[i] - u[o], iv = v[i] - v[o], ju = u[j] - u[o], jv = v[j] - v[o], area = iu*jv - iv*ju;

	for (k = 0; k < STARS_FEW; k++) {
		const double *d = DIRECTION[k/8];
		double x = k & 2 ? -d[k & 1] : d[k & 1], y = k & 4 ? -d[!(k & 1)] : d[!(k & 1)];
		double after_i = iu*y - iv*x, before_j = x*jv - y*ju;

		if (area > 0 ? after_i > 0 && before_j > 0 : after_i < 0 && before_j < 0)
			return 1;
	}
	return 0;
}

/* Moves those of the n triangles at a vertex that `meets` to the front, and returns their number,
 * at most 2*STARS_FEW. */
static int
choose(const Mesh *m, const double *u, const double *v, int n, int *side)
{
	int few = 0, k, s;

	for (k = 0; k < n && few < 2*STARS_FEW; k++)
		if (meets(m, u, v, side[k])) {
			s = side[k];
			side[k] = side[few];
			side[few++] = s;
		}
	return few > 0 ? few : STARS_FEW;
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

int
stars_init(Stars *s, const Mesh *m, const double *u, const double *v)
{
	double *key = malloc(m->nv*sizeof *key + 1);
	Spoke *spoke = NULL;
	int i;

	s->first = calloc((size_t)m->nv + 2, sizeof *s->first);
	s->side = malloc((3*(size_t)m->nf + 1)*sizeof *s->side);
	s->few = malloc(m->nv*sizeof *s->few + 1);
	if (key && s->first && s->side && s->few)
		spoke = malloc(fill(s, m)*sizeof *spoke + 1);
	if (spoke) {
		chart_keys(m->nv, u, v, key);
		for (i = 0; i < m->nv; i++) {
			int n = s->first[i + 1] - s->first[i], *side = &s->side[s->first[i]];

			sort_star(m, key, n, side, spoke);
			s->few[i] = n <= STARS_FEW ? n : choose(m, u, v, n, side);
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
	free(s->few);
	s->first = s->side = s->few = NULL;
}
