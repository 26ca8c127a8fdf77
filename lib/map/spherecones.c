/* spherecones.c - a downhill simplex over Moebius maps and heights. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/pillowplane.h"
#include "../base/simplex.h"
#include "../base/vec3.h"
#include "parts.h"
#include "spherecones.h"

enum {
	FREE   = 7,             /* six of the Moebius map, and log T */
	CONES  = 4,
	FEW    = 1024,          /* parts while starts are compared */
	MANY   = 8192,
	STARTS = 4,
	STEPS  = 250,
	ROUNDS = 6
};
static const double REACH = 0.3;        /* size of the first simplex */
static const double LEAST = 0.02, MOST = 12.5;  /* T; 1/(4T) is the same pillow with u and v exchanged */
static const double SPREAD = 1./16;     /* |p x Z|^2 is taken as |p x Z|^2 + S/16, the mean over a part that holds
                                         * the cone */

/* ---- parts ----------------------------------------------------------- */

typedef struct SphereParts {
	int     n;
	double *A, *S, *ratio;  /* S on the unit sphere over 4 pi */
	Spinor *Z;
} SphereParts;

static double complex
cross(const Spinor a, const Spinor b)
{
	return a[0]*b[1] - a[1]*b[0];
}

static double
square(double complex x)
{
	return creal(x)*creal(x) + cimag(x)*cimag(x);
}

static void
normalise(Spinor Z)
{
	double norm = sqrt(square(Z[0]) + square(Z[1]));

	Z[0] /= norm;
	Z[1] /= norm;
}

static double
face_area(const Mesh *m, const int c[3])
{
	double a[3], b[3], n[3];

	sub3(&m->xyz[3*(size_t)c[1]], &m->xyz[3*(size_t)c[0]], a);
	sub3(&m->xyz[3*(size_t)c[2]], &m->xyz[3*(size_t)c[0]], b);
	cross3(a, b, n);
	return norm3(n)/2;
}

/* Face t in the plane of z, or of 1/z if `far`, seen from its corner 0.  Returns whether it belongs to that half of
 * the sphere. */
static int
face_part(const Mesh *m, Spinor *Z, int t, int far, PartFace *f)
{
	const int *c = &m->tri[3*(size_t)t];
	const double complex *a = Z[c[0]];
	double complex p = sphere_seen_from(a, Z[c[1]]), q = sphere_seen_from(a, Z[c[2]]), z = (p + q)/3;
	Spinor middle = { a[0] + z*conj(a[1]), a[1] - z*conj(a[0]) };

	if ((cabs(middle[0]) > cabs(middle[1])) != far)
		return 0;
	*f = (PartFace){ face_area(m, c), fabs(cimag(conj(p)*q))/(2*M_PI), far ? middle[1]/middle[0] : middle[0]/middle[1] };
	return 1;
}

static void
parts_release(SphereParts *p)
{
	free(p->A);
	free(p->S);
	free(p->ratio);
	free(p->Z);
}

/* Makes about `parts` parts of either half of the sphere. */
static int
parts_of_sphere(const Mesh *m, Spinor *Z, int parts, SphereParts *p)
{
	PartFace *f = malloc(m->nf*sizeof *f);
	Parts half = { 0, malloc(PARTS_MOST*sizeof *half.A), malloc(PARTS_MOST*sizeof *half.S),
	    malloc(PARTS_MOST*sizeof *half.z) };
	int far, t, n, i, e;

	*p = (SphereParts){ 0, malloc(2*PARTS_MOST*sizeof *p->A), malloc(2*PARTS_MOST*sizeof *p->S),
	    malloc(2*PARTS_MOST*sizeof *p->ratio), malloc(2*PARTS_MOST*sizeof *p->Z) };
	e = f && half.A && half.S && half.z && p->A && p->S && p->ratio && p->Z ? 0 : SPHERECONES_ENOMEM;
	for (far = 0; !e && far < 2; far++) {
		for (n = t = 0; t < m->nf; t++)
			n += face_part(m, Z, t, far, &f[n]);
		half.n = 0;
		if (n)
			parts_of_faces(&half, f, n, parts);
		for (i = 0; i < half.n; i++, p->n++) {
			p->A[p->n] = half.A[i];
			p->S[p->n] = half.S[i];
			p->Z[p->n][far] = half.z[i];
			p->Z[p->n][!far] = 1;
			normalise(p->Z[p->n]);
		}
	}
	free(f);
	parts_free(&half);
	if (e)
		parts_release(p);
	return e;
}

/* log chi^2 of the cones. */
static double
value(const SphereParts *p, Spinor cone[CONES])
{
	double q;
	int i, k;

	for (i = 0; i < p->n; i++) {
		for (q = 1, k = 0; k < CONES; k++)
			q *= square(cross(cone[k], p->Z[i])) + SPREAD*4*M_PI*p->S[i];
		p->ratio[i] = p->A[i]/p->S[i]*sqrt(q);
	}
	return log(parts_chi2(p->n, p->A, p->ratio));
}

/* ---- Moebius maps ---------------------------------------------------- */

void
spherecones_move(const SphereCones *c, const Spinor Z, Spinor w)
{
	double complex x = c->M[0][0]*Z[0] + c->M[0][1]*Z[1], y = c->M[1][0]*Z[0] + c->M[1][1]*Z[1];

	w[0] = x, w[1] = y;
	normalise(w);
}

void
spherecones_back(const SphereCones *c, const Spinor w, Spinor Z)
{
	double complex x = c->M[1][1]*w[0] - c->M[0][1]*w[1], y = c->M[0][0]*w[1] - c->M[1][0]*w[0];

	Z[0] = x, Z[1] = y;
	normalise(Z);
}

/* Cone k of the pillow of height T on its sphere: (0,0), (1/2,0), (1/2,T), (0,T). */
static void
pillow_cone(double s, int k, Spinor w)
{
	w[0] = k == 0 ? -s : k == 1 ? s : k == 2 ? 1 : -1;
	w[1] = k < 2 ? 1 : s;
	normalise(w);
}

static void
multiply(double complex A[2][2], double complex B[2][2], double complex C[2][2])
{
	double complex R[2][2], root;
	int i, k;

	for (i = 0; i < 2; i++)
		for (k = 0; k < 2; k++)
			R[i][k] = A[i][0]*B[0][k] + A[i][1]*B[1][k];
	root = csqrt(R[0][0]*R[1][1] - R[0][1]*R[1][0]);
	for (i = 0; i < 2; i++)
		for (k = 0; k < 2; k++)
			C[i][k] = R[i][k]/root;
}

/* The Moebius map that takes 0, infinity and 1 to P[0], P[1], P[2]. */
static void
from_standard(Spinor P[3], double complex M[2][2])
{
	double complex a = cross(P[2], P[0]), b = cross(P[1], P[2]);
	int i;

	for (i = 0; i < 2; i++) {
		M[i][0] = a*P[1][i];
		M[i][1] = b*P[0][i];
	}
}

/* Sets c->M to the map that takes P[0], P[1], P[2] to the first three cones of the pillow of height T. */
static void
take_three(Spinor P[3], double T, SphereCones *c)
{
	double complex from[2][2], to[2][2], inverse[2][2];
	double s = pillowplane(T).half.s;
	Spinor W[3];
	int k;

	for (k = 0; k < 3; k++)
		pillow_cone(s, k, W[k]);
	from_standard(P, from);
	from_standard(W, to);
	inverse[0][0] = from[1][1], inverse[0][1] = -from[0][1];
	inverse[1][0] = -from[1][0], inverse[1][1] = from[0][0];
	multiply(to, inverse, c->M);
	c->T = T;
}

/* The maps of the search: that of `from`, changed by x. */
static void
changed(const SphereCones *from, const double *x, SphereCones *to)
{
	double complex step[2][2] = { { 1 + CMPLX(x[0], x[1]), CMPLX(x[2], x[3]) }, { CMPLX(x[4], x[5]), 1 - CMPLX(x[0], x[1]) } };
	double complex M[2][2];

	memcpy(M, from->M, sizeof M);
	multiply(step, M, to->M);
	to->T = from->T*exp(x[6]);
}

static double
value_of_map(const SphereParts *p, const SphereCones *c)
{
	Spinor cone[CONES], w;
	double s;
	int k;

	if (!(c->T >= LEAST && c->T <= MOST))
		return HUGE_VAL;
	s = pillowplane(c->T).half.s;
	for (k = 0; k < CONES; k++) {
		pillow_cone(s, k, w);
		spherecones_back(c, w, cone[k]);
	}
	return value(p, cone);
}

typedef struct Search {
	const SphereParts *p;
	const SphereCones *from;
	Spinor            *given;       /* NULL, or the first three cones: then only T is free */
} Search;

static double
value_at(void *ctx, const double *x)
{
	const Search *s = ctx;
	SphereCones c;

	if (s->given)
		take_three(s->given, s->from->T*exp(x[0]), &c);
	else
		changed(s->from, x, &c);
	return value_of_map(s->p, &c);
}

/* Improves c; returns log chi^2. */
static double
improve(const SphereParts *p, Spinor *given, int rounds, SphereCones *c)
{
	Search search = { p, c, given };
	SimplexProblem problem = { given ? 1 : FREE, value_at, &search, REACH, STEPS, 1e-5 };
	double x[FREE], f = HUGE_VAL, last = HUGE_VAL;
	SphereCones to;
	int round;

	for (round = 0; round < rounds && !(round > 0 && last - f < 1e-3); round++) {
		last = f;
		f = simplex(&problem, x);
		if (given)
			take_three(given, c->T*exp(x[0]), &to);
		else
			changed(c, x, &to);
		*c = to;
	}
	return f;
}

/* ---- starts ---------------------------------------------------------- */

/* The next number of a fixed sequence, in (0,1). */
static double
draw(unsigned long long *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return ((double)(*state >> 11) + 0.5)/(1ull << 53);
}

/* Four places: that of the part which is smallest on the sphere for its area, then, with a cone there, that of the
 * part which is smallest in the chart, and so on.  Further starts weight the parts by random numbers. */
static void
begin(const SphereParts *p, int start, unsigned long long *state, Spinor place[CONES])
{
	double worst, here, weight;
	int i, k, l;

	for (k = 0; k < CONES; k++)
		for (worst = -1, i = 0; i < p->n; i++) {
			weight = start ? -log(draw(state)) : 1;
			here = p->A[i]/p->S[i]*weight*weight;
			for (l = 0; l < k; l++)
				here *= sqrt(square(cross(place[l], p->Z[i])) + SPREAD*4*M_PI*p->S[i]);
			for (l = 0; l < k && square(cross(place[l], p->Z[i])) > 0; l++)
				;
			if (here > worst && l == k) {
				worst = here;
				memcpy(place[k], p->Z[i], sizeof place[k]);
			}
		}
}

/* The best of all starts: three of four places in every order that differs, and a low and a high pillow. */
static void
search_starts(const SphereParts *p, SphereCones *best)
{
	static const int order[6][3] = { { 0, 1, 2 }, { 0, 1, 3 }, { 0, 2, 1 }, { 0, 2, 3 }, { 0, 3, 1 }, { 0, 3, 2 } };
	unsigned long long state = 1;
	double least = HUGE_VAL, f;
	Spinor place[CONES], P[3];
	SphereCones c;
	int start, k, i;

	for (start = 0; start < STARTS; start++) {
		begin(p, start, &state, place);
		for (k = 0; k < 12; k++) {
			for (i = 0; i < 3; i++)
				memcpy(P[i], place[order[k/2][i]], sizeof P[i]);
			take_three(P, k%2 ? 0.75 : 0.35, &c);
			f = improve(p, NULL, 1, &c);
			if (f < least) {
				least = f;
				*best = c;
			}
		}
	}
}

static int
are_equal(Spinor P[3])
{
	return !(square(cross(P[0], P[1])) > 1e-20 && square(cross(P[1], P[2])) > 1e-20 && square(cross(P[2], P[0])) > 1e-20);
}

int
spherecones(const Mesh *m, Spinor *Z, const int *given, SphereCones *c)
{
	SphereParts p;
	Spinor P[3];
	int k, e = 0;

	for (k = 0; given && k < 3; k++)
		memcpy(P[k], Z[given[k]], sizeof P[k]);
	if (given && are_equal(P))
		return SPHERECONES_EEQUAL;
	if (!given) {
		e = parts_of_sphere(m, Z, FEW/2, &p);
		if (e)
			return e;
		search_starts(&p, c);
		parts_release(&p);
	} else
		c->T = 0.5;
	e = parts_of_sphere(m, Z, MANY/2, &p);
	if (e)
		return e;
	c->chi2 = exp(improve(&p, given ? P : NULL, ROUNDS, c));
	parts_release(&p);
	return 0;
}
