/* supports.c - barycentric coordinates in the faces of the given disk, without cancellation. */
#include <stdlib.h>

#include "supports.h"

/* Adds the coordinate w of the given vertex v to s. */
static void
add(Support *s, int v, double w)
{
	int k;

	for (k = 0; k < 3 && v >= 0; k++)
		if (s->v[k] == v || s->v[k] < 0) {
			s->v[k] = v;
			s->w[k] += w;
			return;
		}
}

void
support_join(Support *a, const Support *b)
{
	int k;

	for (k = 0; k < 3; k++)
		add(a, b->v[k], 0);
}

Support *
supports(const Subdivision *s)
{
	Support *support = malloc(s->d.m.nv*sizeof *support);
	int i, k, l;

	for (i = 0; support && i < s->d.m.nv; i++) {
		const double *w = i < s->given ? NULL : s->w[i - s->given];

		support[i] = (Support){ { w ? -1 : i, -1, -1 }, { !w, 0, 0 } };
		for (k = 0; w && k < 3; k++) {
			const Support *corner = &support[s->corner[i - s->given][k]];

			for (l = 0; l < 3 && w[k] > 0; l++)
				add(&support[i], corner->v[l], w[k]*corner->w[l]);
		}
	}
	return support;
}

void
support_step(const Subdivision *s, const Support *support, int i, int j, double step[3])
{
	const double *x = s->d.m.xyz;
	Support from = support[i], to = { { -1, -1, -1 }, { 0, 0, 0 } };
	int k, l, c, near = 0;

	support_join(&from, &support[j]);
	for (k = 0; k < 3; k++)
		to.v[k] = from.v[k];
	for (l = 0; l < 3; l++)
		add(&to, support[j].v[l], support[j].w[l]);
	for (k = 1; k < 3; k++)
		if (from.w[k] + to.w[k] > from.w[near] + to.w[near])
			near = k;
	for (c = 0; c < 3; c++)
		for (step[c] = 0, k = 0; k < 3; k++)
			if (from.v[k] >= 0 && k != near)
				step[c] += (to.w[k] - from.w[k])*(x[3*(size_t)from.v[k] + c] - x[3*(size_t)from.v[near] + c]);
}
