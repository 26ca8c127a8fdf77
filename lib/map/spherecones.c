/* spherecones.c - the best of several starts. */
#include <string.h>

#include "conesearch.h"
#include "draw.h"
#include "spherecones.h"

enum {
	CONES  = SPHEREPARTS_CONES,
	FEW    = 1024,          /* parts while starts are compared */
	MANY   = 8192,
	STARTS = 6
};
static const double DEEP = 1e12;        /* chi^2 from which on limbs are lost in rounding: areas on the sphere, whose points
                                         * have sixteen digits, are as small as 1e-24 */

/* ---- starts ---------------------------------------------------------- */

/* Four places: that of the part which is smallest on the sphere for its area, then, with a cone there, that of the
 * part which is smallest in the chart, and so on.  Further starts weight the parts by random numbers. */
static void
begin(const SphereParts *p, int start, unsigned long long *state, Spinor place[CONES])
{
	double worst, here, weight, apart;
	int i, k, l;

	for (k = 0; k < CONES; k++)
		for (worst = -1, i = 0; i < p->n; i++) {
			weight = start ? -log(draw(state)) : 1;
			here = p->A[i]/p->S[i]*weight*weight;
			for (apart = 1, l = 0; l < k; l++) {
				apart = fmin(apart, moebius_square(moebius_cross(place[l], p->Z[i])));
				here *= sqrt(moebius_square(moebius_cross(place[l], p->Z[i])) + p->S[i]);
			}
			if (here > worst && apart > 0) {
				worst = here;
				memcpy(place[k], p->Z[i], sizeof place[k]);
			}
		}
}

/* Sets *best to the best of all starts; returns log chi^2, which is infinite if no start is good.  Three of four
 * places become cones, and the last cone begins on each of the three arcs between them. */
static double
search_starts(const SphereParts *p, ConeSearch *best)
{
	unsigned long long state = 1;
	double least = HUGE_VAL, f;
	Spinor place[CONES];
	ConeSearch s = { .p = p };
	int start, k, i;

	for (start = 0; start < STARTS; start++) {
		begin(p, start, &state, place);
		for (k = 0; k < 4*3; k++) {
			for (i = 0; i < 3; i++)
				memcpy(s.P[i], place[(k/3 + 1 + (k + i)%3)%4], sizeof s.P[i]);
			f = conesearch_scan(&s) ? conesearch_descend(&s) : HUGE_VAL;
			if (f < least) {
				least = f;
				*best = s;
			}
		}
	}
	return least;
}

static int
are_equal(Spinor P[3])
{
	int k;

	for (k = 0; k < 3; k++)
		if (!(moebius_square(moebius_cross(P[k], P[(k+1)%3])) > 1e-20))
			return 1;
	return 0;
}

/* Begins at the given cones, or the best ones for few parts. */
static int
begin_search(const Mesh *m, Spinor *Z, const int *given, ConeSearch *s)
{
	SphereParts few;
	ConeSearch best = { .T = 1 };
	double f;
	int k;

	if (given) {
		for (k = 0; k < 3; k++)
			memcpy(s->P[k], Z[given[k]], sizeof s->P[k]);
		return are_equal(s->P) || !conesearch_scan(s) ? SPHERECONES_EEQUAL : 0;
	}
	if (sphereparts_init(&few, m, Z, FEW/2))
		return SPHERECONES_ENOMEM;
	f = search_starts(&few, &best);
	sphereparts_free(&few);
	memcpy(s->P, best.P, sizeof s->P);
	s->T = best.T;
	return f < HUGE_VAL ? 0 : SPHERECONES_EEQUAL;
}

/* Exchanges u and v if T < 1/2. */
static void
exchange(ConeMap *c)
{
	Spinor P[3];
	int k;

	if (!(c->T < 0.5))
		return;
	for (k = 0; k < 3; k++)
		conemap_place(c, k + 1, P[k]);
	conemap_three(P, 1/(4*c->T), c);
}

int
spherecones(const Mesh *m, Spinor *Z, const int *given, SphereCones *c)
{
	SphereParts many;
	ConeSearch s = { .fixed = given != NULL };
	int e;

	if (sphereparts_init(&many, m, Z, MANY/2))
		return SPHERECONES_ENOMEM;
	s.p = &many;
	e = begin_search(m, Z, given, &s);
	if (!e && !((c->chi2 = exp(conesearch_descend(&s))) < DEEP))
		e = SPHERECONES_EEQUAL;
	if (!e) {
		conemap_three(s.P, s.T, &c->map);
		if (!given)
			exchange(&c->map);
	}
	sphereparts_free(&many);
	return e;
}

int
spherecones_chi2(const Mesh *m, Spinor *Z, SphereCones *c)
{
	SphereParts many;
	Spinor cone[CONES];
	int k;

	if (sphereparts_init(&many, m, Z, MANY/2))
		return SPHERECONES_ENOMEM;
	for (k = 0; k < CONES; k++)
		conemap_place(&c->map, k, cone[k]);
	c->chi2 = exp(sphereparts_value(&many, cone));
	sphereparts_free(&many);
	return 0;
}
