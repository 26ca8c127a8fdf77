/* stencil.c - finite differences at and near the sides of a chart. */
#include "stencil.h"

Range
stencil_apart(Chart g, int axis, int rings)
{
	const int *joined = g.kind->joined[axis];
	int n = axis ? g.nv : g.nu;

	return (Range){ joined[0] ? 0 : rings, joined[1] ? n : n - rings };
}

Range
stencil_inner(Chart g, int axis)
{
	return stencil_apart(g, axis, 1);
}

size_t
stencil_inner_count(Chart g)
{
	Range u = stencil_inner(g, 0), v = stencil_inner(g, 1);

	return (size_t)(u.to - u.from)*(v.to - v.from);
}

int
stencil_is_inner(Chart g, int i, int j)
{
	Range u = stencil_inner(g, 0), v = stencil_inner(g, 1);

	return i >= u.from && i < u.to && j >= v.from && j < v.to;
}

Range
stencil_reach(Chart g, int axis)
{
	const int *joined = g.kind->joined[axis];
	int n = axis ? g.nv : g.nu;

	return (Range){ joined[0] ? -1 : 1, joined[1] ? n + 1 : n - 1 };
}

Stencil
stencil_at(Chart g, int axis, int order, int i, int j)
{
	static const struct { int at[3]; double w[3]; } rule[] = {
		{ { 1, 0, -1 }, { 1, 0, -1 } },         /* central */
		{ { 1, 0, -1 }, { 1, -2, 1 } },
		{ { 0, 1, 2 }, { -3, 4, -1 } },         /* at the first node of an open side */
		{ { 0, -1, -2 }, { 3, -4, 1 } },        /* at the last */
	};
	Range r = stencil_inner(g, axis);
	int at = axis ? j : i, way = at < r.from ? 2 : at >= r.to ? 3 : order - 1, k, sign = 1;
	Stencil s;

	for (k = 0; k < 3; k++) {
		int d = rule[way].at[k];

		s.node[k] = stencil_node(g, axis ? i : i + d, axis ? j + d : j, &sign);
		s.w[k] = rule[way].w[k];
	}
	return s;
}

void
stencil_second_form(Chart g, const double *const phi[3], int i, int j, double uu[3], double uv[3],
	double vv[3])
{
	Stencil u = stencil_at(g, 0, 2, i, j), v = stencil_at(g, 1, 2, i, j);
	double h = chart_h(g), k = chart_k(g);
	int sign = 1, c;
	size_t ne = stencil_node(g, i + 1, j + 1, &sign), nw = stencil_node(g, i - 1, j + 1, &sign);
	size_t se = stencil_node(g, i + 1, j - 1, &sign), sw = stencil_node(g, i - 1, j - 1, &sign);

	for (c = 0; c < 3; c++) {
		uu[c] = stencil_sum(&u, phi[c])/(h*h);
		uv[c] = (phi[c][ne] - phi[c][nw] - phi[c][se] + phi[c][sw])/(4*h*k);
		vv[c] = stencil_sum(&v, phi[c])/(k*k);
	}
}

void
quad_beside(Chart g, const double *f, int i, int j, int count, int odd, double x[NODES])
{
	int k, sign;
	size_t p;

	for (k = 0; k < NODES; k++) {
		sign = 1;
		p = stencil_node(g, k < count ? i + k : i, j, &sign);
		x[k] = odd ? sign*f[p] : f[p];
	}
}
