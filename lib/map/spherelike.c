/* spherelike.c - damped Newton steps over the Moebius maps, the best motion for each of them. */
#include <stdlib.h>
#include <string.h>

#include "../base/damped.h"
#include "../base/vec3.h"
#include "likestart.h"
#include "spherelike.h"

enum {
	FREE  = 6,              /* numbers of a Moebius map */
	ALL   = FREE + 6,       /* and of a motion */
	FEW   = 512,            /* points of B while starts are compared */
	MANY  = 4096,
	OF_A  = 1024,           /* points of A, of which the nearest are taken */
	TRIED = 4,              /* starts from which steps are made */
	STEPS = 40
};
static const double NEAR = 1e-3;        /* of the log of the mean square distance */
static const double OTHER = M_PI/6;     /* angle between fits that count as different, */
static const double SAME = M_PI/12;     /* and below which starts count as one */
static const double EQUAL = 1.05;       /* distances within this factor count as equal: then B is turned least */

typedef struct Search {
	const LikeGrid   *a;
	const LikePoints *b;
	Moebius           M;
	double           *to;   /* [b->n][3] of likestart_motion */
	double          (*J)[ALL][3];   /* [b->n] of columns */
} Search;

/* The matrices of small changes of a map: these and i times them. */
static const double BASIS[3][2][2] = { { { .5, 0 }, { 0, -.5 } }, { { 0, 1 }, { 0, 0 } }, { { 0, 0 }, { 1, 0 } } };

/* The map after the change x: (1 + X) M. */
static void
change(const Search *s, const double *x, Moebius M)
{
	Moebius X = { { 1, 0 }, { 0, 1 } };
	int k;

	for (k = 0; k < 3*4; k++)
		X[k%4/2][k%2] += CMPLX(x[2*(k/4)], x[2*(k/4)+1])*BASIS[k/4][k%4/2][k%2];
	moebius_multiply(X, (void *)s->M, M);
}

static double
value(void *ctx, const double *x)
{
	const Search *s = ctx;
	Moebius M;
	double rms;
	Rigid r;

	change(s, x, M);
	rms = likestart_motion(s->a, s->b, M, s->to, &r);
	return 2*log(rms);
}

static void
move(void *ctx, const double *x)
{
	Search *s = ctx;
	Moebius M;

	change(s, x, M);
	memcpy(s->M, M, sizeof M);
}

/* J: the derivatives of the residual of one point, by the map and then by the rotation and translation of the moved
 * point y. */
static void
columns(const LikeGrid *a, const Spinor w, const double y[3], double J[ALL][3])
{
	double slope[2][3], unit[3];
	double complex X[2], d;
	int k, c;

	likegrid_slopes(a, w, slope);
	for (k = 0; k < 3; k++) {
		X[0] = BASIS[k][0][0]*w[0] + BASIS[k][0][1]*w[1];
		X[1] = BASIS[k][1][0]*w[0] + BASIS[k][1][1]*w[1];
		d = X[0]*w[1] - X[1]*w[0];              /* as moebius_seen_from has it */
		for (c = 0; c < 3; c++) {
			J[2*k][c] = creal(d)*slope[0][c] + cimag(d)*slope[1][c];
			J[2*k+1][c] = -cimag(d)*slope[0][c] + creal(d)*slope[1][c];
		}
		for (c = 0; c < 3; c++)
			unit[c] = c == k;
		cross3(y, unit, J[FREE+k]);             /* - unit x y */
		for (c = 0; c < 3; c++)
			J[FREE+3+k][c] = -unit[c];
	}
}

/* Takes the motion out of the sums: what is left belongs to the best motion for each map (a Schur complement). */
static void
eliminate(double g[ALL], double H[ALL][ALL])
{
	int i, j, k;

	for (k = ALL - 1; k >= FREE; k--) {
		if (!(H[k][k] > 0))
			continue;
		for (i = 0; i < k; i++) {
			for (j = 0; j < k; j++)
				H[i][j] -= H[i][k]*H[k][j]/H[k][k];
			g[i] -= H[i][k]*g[k]/H[k][k];
		}
	}
}

static double
derivatives(void *ctx, double *g, double (*H)[DAMPED_MOST])
{
	Search *s = ctx;
	int n = s->b->n, i, k, l, c;
	double sg[ALL] = { 0 }, sH[ALL][ALL] = { { 0 } }, rms, f, e[3], y[3];
	Rigid r;

	rms = likestart_motion(s->a, s->b, s->M, s->to, &r);
	if (!(rms > 0 && rms < HUGE_VAL)) {
		memset(g, 0, FREE*sizeof *g);
		memset(H, 0, FREE*sizeof *H);
		return rms > 0 ? HUGE_VAL : -HUGE_VAL;
	}
	f = rms*rms;
	#pragma omp parallel for schedule(static)
	for (i = 0; i < n; i++) {
		double x[3];
		Spinor w;

		memcpy(x, &s->b->x[3*i], sizeof x);
		rigid_move(&r, 1, x);
		moebius_apply(s->M, s->b->Z[i], w);
		columns(s->a, w, x, s->J[i]);
	}
	for (i = 0; i < n; i++) {
		memcpy(y, &s->b->x[3*i], sizeof y);
		rigid_move(&r, 1, y);
		sub3(&s->to[3*i], y, e);
		for (k = 0; k < ALL; k++)
			for (sg[k] += 2*dot3(s->J[i][k], e)/(n*f), l = 0; l < ALL; l++)
				sH[k][l] += 2*dot3(s->J[i][k], s->J[i][l])/(n*f);
	}
	eliminate(sg, sH);
	for (k = 0; k < FREE; k++)
		for (g[k] = sg[k], c = 0; c < FREE; c++)
			H[k][c] = sH[k][c];
	return log(f);
}

/* Moves the position s of b on a to the least distance near it.  Returns 0 or SPHERELIKE_ENOMEM. */
static int
descend(const LikeGrid *a, const LikePoints *b, LikeStart *at)
{
	Search s = { .a = a, .b = b, .to = malloc(3*b->n*sizeof *s.to), .J = malloc(b->n*sizeof *s.J) };
	DampedProblem problem = { FREE, &s, value, move, derivatives, STEPS, NEAR };
	int e = s.to && s.J ? 0 : SPHERELIKE_ENOMEM;

	if (!e) {
		memcpy(s.M, at->M, sizeof s.M);
		damped_newton(&problem);
		memcpy(at->M, s.M, sizeof s.M);
		at->rms = likestart_motion(a, b, at->M, s.to, &at->r);
	}
	free(s.to);
	free(s.J);
	return e;
}

/* The angle between two rotations. */
static double
angle_between(const Rigid *r, const Rigid *q)
{
	double trace = 0;
	int k;

	for (k = 0; k < 9; k++)
		trace += r->R[k/3][k%3]*q->R[k/3][k%3];
	return acos(fmin(fmax((trace - 1)/2, -1), 1));
}

/* Whether start k is about one of those before it. */
static int
is_known(const LikeStart *s, int k)
{
	int i;

	for (i = 0; i < k && angle_between(&s[i].r, &s[k].r) >= SAME; i++)
		;
	return i < k;
}

/* Keeps the best starts, no two of them alike.  Returns their number. */
static int
choose_starts(LikeStart s[LIKESTART_COUNT])
{
	int k, n = 0;

	for (k = 0; k < LIKESTART_COUNT && n < TRIED && s[k].rms < HUGE_VAL; k++) {
		s[n] = s[k];
		n += !is_known(s, n);
	}
	return n;
}

/* The least distance of n fits, of those only that are turned otherwise than `than`, if that is given. */
static double
least_rms(int n, const LikeStart *s, const Rigid *than)
{
	double least = HUGE_VAL;
	int k;

	for (k = 0; k < n; k++)
		if (!than || angle_between(&s[k].r, than) >= OTHER)
			least = fmin(least, s[k].rms);
	return least;
}

/* Tries the starts with the points b; sets *best and l->next. */
static int
try_starts(const LikeGrid *a, const LikePoints *b, LikeStart *best, SphereLike *l)
{
	LikeStart s[LIKESTART_COUNT];
	double least;
	int k, n;

	if (likestart(a, b, s))
		return SPHERELIKE_ENOMEM;
	for (n = choose_starts(s), k = 0; k < n; k++)
		if (descend(a, b, &s[k]))
			return SPHERELIKE_ENOMEM;
	least = least_rms(n, s, NULL);
	if (!(least < HUGE_VAL))
		return SPHERELIKE_EEQUAL;
	for (best->rms = HUGE_VAL, k = 0; k < n; k++)
		if (s[k].rms <= EQUAL*least && (best->rms == HUGE_VAL || rigid_angle(&s[k].r) < rigid_angle(&best->r)))
			*best = s[k];
	l->next = least_rms(n, s, &best->r);
	return 0;
}

/* Sets l to the fit of `few` points, and then of `many`. */
static int
fit(const LikeGrid *a, const LikePoints *few, const LikePoints *many, SphereLike *l)
{
	LikeStart at;
	int e = try_starts(a, few, &at, l);

	if (!e)
		e = descend(a, many, &at);
	memcpy(l->map.M, at.M, sizeof at.M);
	l->rms = at.rms;
	return e;
}

/* Sets l to the map of the given cones. */
static int
take_cones(const LikeGrid *a, const LikePoints *b, Spinor *Z, const int *given, SphereLike *l)
{
	double *to = malloc(3*b->n*sizeof *to);
	Spinor P[3];
	Rigid r;
	int k;

	if (!to)
		return SPHERELIKE_ENOMEM;
	for (k = 0; k < 3; k++)
		memcpy(P[k], Z[given[k]], sizeof P[k]);
	conemap_three(P, a->g.T, &l->map);
	l->rms = likestart_motion(a, b, l->map.M, to, &r);
	free(to);
	return l->rms < HUGE_VAL ? 0 : SPHERELIKE_EEQUAL;
}

static int
error_of(int e)
{
	return e == 0 ? 0 : e == LIKEPOINTS_ENOMEM ? SPHERELIKE_ENOMEM : SPHERELIKE_EEQUAL;
}

int
spherelike(const Mesh *m, Spinor *Z, const int *given, Chart g, const double *const phi[3], SphereLike *l)
{
	LikePoints few = { 0 }, many = { 0 };
	LikeGrid a = { 0 };
	int e = error_of(likegrid_init(&a, g, phi, OF_A));

	*l = (SphereLike){ .map.T = g.T, .next = HUGE_VAL };
	if (!e)
		e = error_of(likepoints_init(&few, m, Z, FEW));
	if (!e)
		e = error_of(likepoints_init(&many, m, Z, MANY));
	if (!e)
		e = given ? take_cones(&a, &many, Z, given, l) : fit(&a, &few, &many, l);
	likepoints_free(&few);
	likepoints_free(&many);
	likegrid_free(&a);
	return e;
}
