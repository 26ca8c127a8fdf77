/* sheet.c - triangles under repair: dropping faces, and a vertex for each fan. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/fail.h"
#include "sheet.h"

void
sheet_free(Sheet *s)
{
	free(s->xyz);
	free(s->source);
	free(s->tri);
	free(s->twin);
	free(s->filled);
	s->xyz = NULL;
	s->source = s->tri = s->twin = NULL;
	s->filled = NULL;
	s->nv = s->nf = 0;
}

int
sheet_keep(Sheet *s, const unsigned char *keep)
{
	int *to = mesh_alloc(s->err, (size_t)s->nf, sizeof *to), f, k, n = 0;

	if (!to)
		return MESH_ENOMEM;
	for (f = 0; f < s->nf; f++)
		to[f] = keep[f] ? n++ : -1;
	for (f = 0; f < s->nf; f++) {
		if (to[f] < 0)
			continue;
		memmove(s->tri + 3*(size_t)to[f], s->tri + 3*(size_t)f, 3*sizeof *s->tri);
		s->filled[to[f]] = s->filled[f];
		for (k = 0; s->twin && k < 3; k++) {
			const int t = s->twin[3*f+k];

			s->twin[3*to[f]+k] = t < 0 || to[t/3] < 0 ? -1 : 3*to[t/3] + t%3;
		}
	}
	s->nf = n;
	free(to);
	return 0;
}

int
sheet_corners(const int *vertex, int n, int nv, int **first, int **corner, char *err)
{
	int i, v;

	*first = mesh_alloc(err, (size_t)nv + 2, sizeof **first);
	*corner = mesh_alloc(err, (size_t)n, sizeof **corner);
	if (!*first || !*corner) {
		free(*first);
		free(*corner);
		*first = *corner = NULL;
		return MESH_ENOMEM;
	}
	memset(*first, 0, ((size_t)nv + 2)*sizeof **first);
	for (i = 0; i < n; i++)
		(*first)[vertex[i] + 2]++;
	for (v = 2; v < nv + 2; v++)
		(*first)[v] += (*first)[v-1];
	for (i = 0; i < n; i++)
		(*corner)[(*first)[vertex[i] + 1]++] = i;
	return 0;
}

/* Makes vertex i a copy of vertex from[i] <= i or, beyond the old count, of any, for i < n.  Returns
 * 0 or MESH_ENOMEM with the sheet unchanged. */
static int
gather(Sheet *s, const int *from, int n)
{
	double *xyz = mesh_alloc(s->err, (size_t)n, 3*sizeof *xyz);
	int *source = mesh_alloc(s->err, (size_t)n, sizeof *source), i;

	if (!xyz || !source) {
		free(xyz);
		free(source);
		return MESH_ENOMEM;
	}
	for (i = 0; i < n; i++) {
		memcpy(xyz + 3*(size_t)i, sheet_at(s, from[i]), 3*sizeof *xyz);
		source[i] = s->source[from[i]];
	}
	free(s->xyz);
	free(s->source);
	s->xyz = xyz;
	s->source = source;
	s->nv = n;
	return 0;
}

int
sheet_compact(Sheet *s)
{
	const int before = s->nv;
	int *to = mesh_alloc(s->err, (size_t)s->nv, sizeof *to);
	int *from = mesh_alloc(s->err, (size_t)s->nv, sizeof *from), v, i, n = 0, e = MESH_ENOMEM;

	if (to && from) {
		memset(to, -1, (size_t)s->nv*sizeof *to);
		for (i = 0; i < 3*s->nf; i++)
			to[s->tri[i]] = 0;
		for (v = 0; v < s->nv; v++)
			if (to[v] == 0)
				from[n] = v, to[v] = n++;
		e = n == before ? 0 : gather(s, from, n);
		for (i = 0; !e && i < 3*s->nf; i++)
			s->tri[i] = to[s->tri[i]];
	}
	free(to);
	free(from);
	return e ? e : before - n;
}

/* The corners that lie at one vertex, as a forest on all corners. */
static void
unite_fans(const Sheet *s, int *up)
{
	int i, t;

	for (i = 0; i < 3*s->nf; i++)
		up[i] = i;
	for (i = 0; i < 3*s->nf; i++) {
		if ((t = s->twin[i]) < i)
			continue;
		if (s->tri[i] == s->tri[t]) {   /* the faces disagree in orientation */
			sheet_unite(up, i, t);
			sheet_unite(up, sheet_next(i), sheet_next(t));
		} else {
			sheet_unite(up, i, sheet_next(t));
			sheet_unite(up, sheet_next(i), t);
		}
	}
}

/* A vertex for each fan.  slot[r]: the number of the fan with representative corner r, first among
 * the old vertices; from[i]: the old vertex that vertex i copies. */
typedef struct Fans {
	int *up, *slot, *from, *first, *corner;
	int  nv, pairs, used;
} Fans;

/* Gives each old vertex to the first of its fans that has none; then numbers the fans left over. */
static void
number_fans(Fans *a, const Sheet *s)
{
	int v, i, r, n = s->nv;

	for (i = 0; i < 3*s->nf; i++)
		a->slot[i] = -1;
	for (v = 0; v < s->nv; v++) {
		a->from[v] = -1;
		for (i = a->first[v]; i < a->first[v+1] && a->from[v] < 0; i++)
			if (a->slot[r = sheet_root(a->up, a->corner[i])] < 0)
				a->slot[r] = a->from[v] = v;
	}
	for (v = 0; v < s->nv; v++)
		for (i = a->first[v]; i < a->first[v+1]; i++)
			if (a->slot[r = sheet_root(a->up, a->corner[i])] < 0) {
				a->from[n] = v;
				a->slot[r] = n++;
			}
	a->nv = n;
}

/* Counts the old vertices in use, and the pairs of an old vertex and one of its fans. */
static void
count_pairs(Fans *a, const Sheet *s, int *stamp)
{
	int v, i, r;

	memset(stamp, -1, 3*(size_t)s->nf*sizeof *stamp);
	for (v = 0; v < s->nv; v++) {
		a->used += a->first[v] < a->first[v+1];
		for (i = a->first[v]; i < a->first[v+1]; i++)
			if (stamp[r = sheet_root(a->up, a->corner[i])] != v) {
				stamp[r] = v;
				a->pairs++;
			}
	}
}

/* Closes the gaps that unused old vertices leave in the numbers. */
static int
apply_fans(Fans *a, Sheet *s, int *to)
{
	int i, n = 0, e;

	for (i = 0; i < a->nv; i++)
		if (a->from[i] >= 0) {
			to[i] = n;
			a->from[n++] = a->from[i];
		}
	if ((e = gather(s, a->from, n)) != 0)
		return e;
	for (i = 0; i < 3*s->nf; i++)
		s->tri[i] = to[a->slot[sheet_root(a->up, i)]];
	return 0;
}

int
sheet_part(Sheet *s, const int *was, int *merged, int *split)
{
	const size_t n = 3*(size_t)s->nf;
	Fans a = { 0 };
	int e = MESH_ENOMEM, *to = mesh_alloc(s->err, n + (size_t)s->nv, sizeof *to);

	a.up = mesh_alloc(s->err, n, sizeof *a.up);
	a.slot = mesh_alloc(s->err, n, sizeof *a.slot);
	a.from = mesh_alloc(s->err, n + (size_t)s->nv, sizeof *a.from);
	if (to && a.up && a.slot && a.from &&
	    !sheet_corners(was ? was : s->tri, 3*s->nf, s->nv, &a.first, &a.corner, s->err)) {
		unite_fans(s, a.up);
		count_pairs(&a, s, a.slot);
		number_fans(&a, s);
		if ((e = apply_fans(&a, s, to)) == 0) {
			*merged = a.pairs - s->nv;
			*split = a.pairs - a.used;
		}
	}
	free(to);
	free(a.up);
	free(a.slot);
	free(a.from);
	free(a.first);
	free(a.corner);
	return e;
}
