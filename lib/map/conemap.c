/* conemap.c - Moebius map and cones of a pillow. */
#include "../base/pillowplane.h"
#include "conemap.h"

void
conemap_move(const ConeMap *c, const Spinor Z, Spinor w)
{
	moebius_apply((void *)c->M, Z, w);
}

void
conemap_back(const ConeMap *c, const Spinor w, Spinor Z)
{
	moebius_back((void *)c->M, w, Z);
}

void
conemap_pillow(double T, int k, Spinor w)
{
	double s = pillowplane(T).half.s;

	w[0] = k == 0 ? -s : k == 1 ? s : k == 2 ? 1 : -1;
	w[1] = k < 2 ? 1 : s;
	moebius_normalise(w);
}

void
conemap_place(const ConeMap *c, int k, Spinor Z)
{
	Spinor w;

	conemap_pillow(c->T, k, w);
	conemap_back(c, w, Z);
}

void
conemap_three(Spinor P[3], double T, ConeMap *c)
{
	Spinor W[3];
	int k;

	for (k = 0; k < 3; k++)
		conemap_pillow(T, k, W[k]);
	moebius_three(P, W, c->M);
	c->T = T;
}
