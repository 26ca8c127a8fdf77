/* remedy.c - what mesh2disk can do about a mesh that is no disk. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "fail.h"
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
