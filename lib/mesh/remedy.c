/* remedy.c - names the options of mesh2disk that mend a mesh that is no disk. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "fail.h"
#include "nearpoints.h"
#include "remedy.h"
#include "repair.h"

int
remedy(char err[MESH_ERRLEN], int code, const char *what)
{
	const size_t n = strlen(err);

	snprintf(err + n, MESH_ERRLEN - n, "; mesh2disk %s", what);
	return code;
}

static double
area_of(const double *xyz, const int t[3])
{
	double u[3], v[3], n[3];

	sub3(xyz + 3*(size_t)t[1], xyz + 3*(size_t)t[0], u);
	sub3(xyz + 3*(size_t)t[2], xyz + 3*(size_t)t[0], v);
	cross3(u, v, n);
	return norm3(n)/2;
}

static int
root(int *up, int v)
{
	while (up[v] != v)
		v = up[v] = up[up[v]];
	return v;
}

/* The share that the largest component has of the area.  up and area are workspace, [nv]. */
static double
largest_share(const Topology *t, const double *xyz, int *up, double *area)
{
	double all = 0, most = 0;
	int i, v;

	for (v = 0; v < t->nv; v++)
		up[v] = v, area[v] = 0;
	for (i = 0; i < 3*t->nf; i++)
		up[root(up, topology_from(t, i))] = root(up, topology_to(t, i));
	for (i = 0; i < t->nf; i++)
		area[root(up, t->tri[3*(size_t)i])] += area_of(xyz, t->tri + 3*(size_t)i);
	for (v = 0; v < t->nv; v++) {
		all += area[v];
		most = larger(most, area[v]);
	}
	return all > 0 ? most/all : 1;
}

int
remedy_components(const Topology *t, const double *xyz, int code)
{
	int *up = malloc((size_t)t->nv*sizeof *up);
	double *area = malloc((size_t)t->nv*sizeof *area);
	char what[100] = "keeps the largest";

	if (up && area)
		snprintf(what, sizeof what, "keeps the largest, %.3g %% of the area",
		    100*largest_share(t, xyz, up, area));
	free(up);
	free(area);
	return remedy(t->err, code, what);
}

/* The vertices on the boundary; list is [nv], on workspace of as many bytes. */
static int
boundary_vertices(const Topology *t, int *list, unsigned char *on)
{
	int i, v, n = 0;

	memset(on, 0, (size_t)t->nv);
	for (i = 0; i < 3*t->nf; i++)
		if (t->twin[i] < 0)
			on[topology_from(t, i)] = on[topology_to(t, i)] = 1;
	for (v = 0; v < t->nv; v++)
		if (on[v])
			list[n++] = v;
	return n;
}

static double
diagonal(const double *xyz, int nv)
{
	double lo[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, hi[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL }, d[3];
	int v, c;

	for (v = 0; v < nv; v++)
		for (c = 0; c < 3; c++) {
			lo[c] = fmin(lo[c], xyz[3*(size_t)v + (size_t)c]);
			hi[c] = fmax(hi[c], xyz[3*(size_t)v + (size_t)c]);
		}
	sub3(hi, lo, d);
	return norm3(d);
}

static void
unite(int v, int w, double distance, void *to)
{
	int *up = to;

	(void)distance;
	up[root(up, w)] = root(up, v);
}

int
remedy_close(const Topology *t, const double *xyz, int code)
{
	int *up = malloc((size_t)t->nv*sizeof *up), *list = malloc((size_t)t->nv*sizeof *list), v, n, count = 0;
	unsigned char *on = malloc((size_t)t->nv);
	const double distance = 1e-6*diagonal(xyz, t->nv);
	const size_t at = strlen(t->err);

	if (up && list && on && distance > 0) {
		for (v = 0; v < t->nv; v++)
			up[v] = v;
		n = boundary_vertices(t, list, on);
		nearpoints(xyz, list, n, distance, unite, up);
		for (v = 0; v < t->nv; v++)
			count += up[v] != v;
	}
	if (count)
		snprintf(t->err + at, MESH_ERRLEN - at,
		    "; %d boundary vertices lie within %.2g of others: --weld=auto welds them", count, distance);
	free(up);
	free(list);
	free(on);
	return code;
}

int
remedy_coincident(Disk *d)
{
	double *x = malloc(3*(size_t)d->nb*sizeof *x);
	int *to = malloc((size_t)d->nb*sizeof *to), i, n, count = -1;

	if (x && to) {
		for (i = 0; i < d->nb; i++)
			memcpy(x + 3*(size_t)i, d->m.xyz + 3*(size_t)d->loop[i], 3*sizeof *x);
		if (repair_weld(d->nb, x, to, &n) == 0)
			count = d->nb - n;
	}
	free(x);
	free(to);
	return count >= 0 ? count : mesh_fail(d->err, MESH_ENOMEM, "no memory to compare %d vertices", d->nb);
}
