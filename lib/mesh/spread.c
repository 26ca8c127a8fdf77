/* spread.c - numbers for vertices that have none, from their neighbours. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "fail.h"
#include "spread.h"

static int
is_vertex(const Soup *s, int v)
{
	return v >= 0 && v < s->nv;
}

/* The faces at each vertex, f as often as v is a corner of it: face[first[v]] .. face[first[v+1]-1]. */
typedef struct Stars {
	int *first, *face;
} Stars;

static void
stars_free(Stars *t)
{
	free(t->first);
	free(t->face);
}

static int
stars_init(Stars *t, const Soup *s, char *err)
{
	const size_t corners = (size_t)s->first[s->nf];
	size_t i;
	int f, v, k;

	t->first = mesh_alloc(err, (size_t)s->nv + 2, sizeof *t->first);
	t->face = mesh_alloc(err, corners, sizeof *t->face);
	if (!t->first || !t->face) {
		stars_free(t);
		return MESH_ENOMEM;
	}
	memset(t->first, 0, ((size_t)s->nv + 2)*sizeof *t->first);
	for (i = 0; i < corners; i++)
		if (is_vertex(s, s->idx[i]))
			t->first[s->idx[i] + 2]++;
	for (v = 2; v < s->nv + 2; v++)
		t->first[v] += t->first[v-1];
	for (f = 0; f < s->nf; f++)
		for (k = s->first[f]; k < s->first[f+1]; k++)
			if (is_vertex(s, s->idx[k]))
				t->face[t->first[s->idx[k] + 1]++] = f;
	return 0;
}

/* Each corner k of each face at v. */
#define FOR_NEIGHBOURS(s, t, v, i, k) \
	for (i = (t)->first[v]; i < (t)->first[(v)+1]; i++) \
		for (k = (s)->first[(t)->face[i]]; k < (s)->first[(t)->face[i]+1]; k++) \
			if (is_vertex(s, (s)->idx[k]))

/* Finds the vertices in their order.  layer[v]: how many steps v is from a vertex with numbers; -1: not reached. */
static void
find_layers(Spread *a, const Soup *s, const Stars *t, const unsigned char *known, int *layer)
{
	int v, i, k, q;

	a->n = 0;
	for (v = 0; v < s->nv; v++)
		layer[v] = known[v] ? 0 : -1;
	for (v = 0; v < s->nv; v++) {
		if (!known[v])
			FOR_NEIGHBOURS(s, t, v, i, k)
				if (known[s->idx[k]] && layer[v] < 0)
					layer[v] = 1;
		if (layer[v] == 1)
			a->vertex[a->n++] = v;
	}
	for (q = 0; q < a->n; q++)
		FOR_NEIGHBOURS(s, t, a->vertex[q], i, k)
			if (layer[s->idx[k]] < 0) {
				layer[s->idx[k]] = layer[a->vertex[q]] + 1;
				a->vertex[a->n++] = s->idx[k];
			}
}

/* Finds the neighbours of each vertex that come before it, in layers of their own. */
static int
find_near(Spread *a, const Soup *s, const Stars *t, const int *layer, char *err)
{
	size_t n = 0;
	int q, i, k, pass;

	for (pass = 0; pass < 2; pass++) {
		for (n = 0, q = 0; q < a->n; q++) {
			a->first[q] = (int)n;
			FOR_NEIGHBOURS(s, t, a->vertex[q], i, k)
				if (layer[s->idx[k]] < layer[a->vertex[q]]) {
					if (pass)
						a->near[n] = s->idx[k];
					n++;
				}
		}
		a->first[q] = (int)n;
		if (!pass && !(a->near = mesh_alloc(err, n, sizeof *a->near)))
			return MESH_ENOMEM;
	}
	return 0;
}

static double
distance(const Soup *s, int v, int w)
{
	const double *x = s->xyz + 3*(size_t)v, *y = s->xyz + 3*(size_t)w;

	return sqrt((x[0] - y[0])*(x[0] - y[0]) + (x[1] - y[1])*(x[1] - y[1]) + (x[2] - y[2])*(x[2] - y[2]));
}

/* way is [nv], and origin [nv] the vertex with numbers that a way begins at. */
static void
find_nearest(Spread *a, const Soup *s, double *way, int *origin)
{
	double far;
	int v, q, i;

	for (v = 0; v < s->nv; v++) {
		way[v] = 0;
		origin[v] = v;
	}
	for (q = 0; q < a->n; q++) {
		v = a->vertex[q];
		way[v] = HUGE_VAL;
		origin[v] = origin[a->near[a->first[q]]];
		for (i = a->first[q]; i < a->first[q+1]; i++)
			if ((far = way[a->near[i]] + distance(s, v, a->near[i])) < way[v]) {
				way[v] = far;
				origin[v] = origin[a->near[i]];
			}
		a->nearest[q] = origin[v];
	}
}

int
spread_init(Spread *a, const Soup *s, const unsigned char *known)
{
	char err[MESH_ERRLEN];
	Stars t;
	int *layer = mesh_alloc(err, (size_t)s->nv, sizeof *layer), e = MESH_ENOMEM;
	double *way = mesh_alloc(err, (size_t)s->nv, sizeof *way);

	*a = (Spread){ .n = 0 };
	a->vertex = mesh_alloc(err, (size_t)s->nv, sizeof *a->vertex);
	a->first = mesh_alloc(err, (size_t)s->nv + 1, sizeof *a->first);
	a->nearest = mesh_alloc(err, (size_t)s->nv, sizeof *a->nearest);
	if (layer && way && a->vertex && a->first && a->nearest && stars_init(&t, s, err) == 0) {
		find_layers(a, s, &t, known, layer);
		if ((e = find_near(a, s, &t, layer, err)) == 0)
			find_nearest(a, s, way, layer);
		stars_free(&t);
	}
	free(layer);
	free(way);
	if (e)
		spread_free(a);
	return e;
}

void
spread_free(Spread *a)
{
	free(a->vertex);
	free(a->first);
	free(a->near);
	free(a->nearest);
	*a = (Spread){ .n = 0 };
}

/* The mean of the finite numbers at the neighbours of vertex[q], times `scale`; f + n*v is the number at v. */
static double
mean(const Spread *a, int q, int n, const double *f, double scale)
{
	double sum = 0;
	int i, count = 0;

	for (i = a->first[q]; i < a->first[q+1]; i++) {
		const double x = f[(size_t)n*(size_t)a->near[i]];

		if (isfinite(x))
			sum += x*scale, count++;
	}
	return count ? sum/count : NAN;
}

void
spread_mean(const Spread *a, int n, double *f)
{
	int q, k;

	for (q = 0; q < a->n; q++)
		for (k = 0; k < n; k++) {
			double x = mean(a, q, n, f + k, 1);

			/* a sum may be too large for a double where no number is */
			f[(size_t)n*(size_t)a->vertex[q] + (size_t)k] = isinf(x) ? mean(a, q, n, f + k, 0x1p-32)*0x1p32 : x;
		}
}

void
spread_nearest(const Spread *a, int n, double *f)
{
	int q;

	for (q = 0; q < a->n; q++)
		memcpy(f + (size_t)n*(size_t)a->vertex[q], f + (size_t)n*(size_t)a->nearest[q], (size_t)n*sizeof *f);
}
