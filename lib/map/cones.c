/* cones.c - parts of equal area by halving, and a downhill simplex over pairs of points. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/sockplane.h"
#include "../base/vec3.h"
#include "cones.h"

enum {
	PARTS  = 16384,
	STARTS = 6,
	ROUNDS = 4,             /* of the simplex, each about the best pair so far */
	STEPS  = 200,           /* of a round */
	FREE   = 4,             /* two coordinates of each cone */
	BINS   = 16*160         /* of ratios from 2^-80 to 2^80 */
};
static const double TRIMMED = 0.01;     /* of the area: as much as mesh2rect -n auto may lose.  Nostrils and
                                         * folds would outweigh all limbs */
static const double REACH = 0.15;       /* size of the first simplex, as a hyperbolic distance */
static const double SPREAD = 1./16;     /* |z - a|^2 is taken as |z - a|^2 + S/16, the mean over a part
                                         * that holds the cone */

/* ---- parts ----------------------------------------------------------- */

typedef struct Face {
	double         A, S;
	double complex z;
} Face;

static int
by_real(const void *x, const void *y)
{
	double a = creal(((const Face *)x)->z), b = creal(((const Face *)y)->z);

	return (a > b) - (a < b);
}

static int
by_imag(const void *x, const void *y)
{
	double a = cimag(((const Face *)x)->z), b = cimag(((const Face *)y)->z);

	return (a > b) - (a < b);
}

/* Whether the faces extend farther along the real axis. */
static int
is_wide(const Face *f, int n)
{
	double lo[2] = { HUGE_VAL, HUGE_VAL }, hi[2] = { -HUGE_VAL, -HUGE_VAL };
	int i;

	for (i = 0; i < n; i++) {
		lo[0] = fmin(lo[0], creal(f[i].z)), hi[0] = fmax(hi[0], creal(f[i].z));
		lo[1] = fmin(lo[1], cimag(f[i].z)), hi[1] = fmax(hi[1], cimag(f[i].z));
	}
	return hi[0] - lo[0] >= hi[1] - lo[1];
}

static void
add_part(Parts *p, const Face *f, int n)
{
	double A = 0, S = 0;
	double complex z = 0;
	int i;

	for (i = 0; i < n; i++) {
		A += f[i].A;
		S += f[i].S;
		z += f[i].A*f[i].z;
	}
	if (!(A > 0 && S > 0))
		return;
	p->A[p->n] = A;
	p->S[p->n] = S;
	p->z[p->n++] = z/A;
}

/* Halves the faces by area until there are about `parts` parts. */
static void
halve(Parts *p, Face *f, int n, int parts)
{
	double half = 0, sum = 0;
	int i;

	if (parts <= 1 || n <= 1) {
		add_part(p, f, n);
		return;
	}
	qsort(f, n, sizeof *f, is_wide(f, n) ? by_real : by_imag);
	for (i = 0; i < n; i++)
		half += f[i].A/2;
	for (i = 0; i < n - 1 && (i == 0 || sum + f[i].A/2 < half); i++)
		sum += f[i].A;
	halve(p, f, i, parts/2);
	halve(p, f + i, n - i, parts/2);
}

static Face
face_of(const Mesh *m, const double complex *z, int t)
{
	const int *c = &m->tri[3*(size_t)t];
	double complex a = z[c[1]] - z[c[0]], b = z[c[2]] - z[c[0]];
	double e[3], g[3], n[3];

	sub3(m->xyz + 3*(size_t)c[1], m->xyz + 3*(size_t)c[0], e);
	sub3(m->xyz + 3*(size_t)c[2], m->xyz + 3*(size_t)c[0], g);
	cross3(e, g, n);
	return (Face){ norm3(n)/2, fabs(cimag(conj(a)*b))/2, (z[c[0]] + z[c[1]] + z[c[2]])/3 };
}

int
parts_init(Parts *p, const Mesh *m, const double complex *z)
{
	Face *f = malloc(m->nf*sizeof *f);
	int t;

	*p = (Parts){ 0, malloc(PARTS*sizeof *p->A), malloc(PARTS*sizeof *p->S), malloc(PARTS*sizeof *p->z) };
	if (!f || !p->A || !p->S || !p->z) {
		free(f);
		parts_free(p);
		return CONES_ENOMEM;
	}
	for (t = 0; t < m->nf; t++)
		f[t] = face_of(m, z, t);
	halve(p, f, m->nf, PARTS);
	free(f);
	return 0;
}

void
parts_free(Parts *p)
{
	free(p->A);
	free(p->S);
	free(p->z);
	memset(p, 0, sizeof *p);
}

static double
softened(double complex d, double S)
{
	return creal(d)*creal(d) + cimag(d)*cimag(d) + SPREAD*S;
}

/* The bin of a ratio: sixteen for each power of two. */
static int
bin_of(double ratio)
{
	int e;
	double m = frexp(ratio, &e);

	e += BINS/32;
	return e < 0 ? 0 : e >= BINS/16 ? BINS - 1 : 16*e + (int)(32*m - 16);
}

/* The lowest bin whose parts, with those of all higher bins, have at most the share TRIMMED of the area. */
static int
trim(const Parts *p, const double *ratio)
{
	double area[BINS] = { 0 }, left = 0;
	int i, b;

	for (i = 0; i < p->n; i++) {
		area[bin_of(ratio[i])] += p->A[i];
		left += TRIMMED*p->A[i];
	}
	for (b = BINS - 1; b >= 0 && area[b] <= left; b--)
		left -= area[b];
	return b + 1;
}

/* chi^2 for the areas S/sqrt(q), without the parts that are smallest in the chart for their area. */
static double
chi2(const Parts *p, const double *q)
{
	double A = 0, a, sum = 0, inverse = 0, ratio[PARTS];
	int i, end;

	for (i = 0; i < p->n; i++)
		ratio[i] = p->A[i]/p->S[i]*sqrt(q[i]);
	end = trim(p, ratio);
	for (i = 0; i < p->n; i++) {
		if (bin_of(ratio[i]) >= end)
			continue;
		a = p->A[i]/ratio[i];
		A += p->A[i];
		sum += a;
		inverse += p->A[i]*ratio[i];
	}
	return inverse*sum/(A*A);
}

double
parts_sock(const Parts *p, double complex a, double complex b)
{
	double q[PARTS];
	int i;

	for (i = 0; i < p->n; i++)
		q[i] = softened(p->z[i] - a, p->S[i])*softened(1 - conj(a)*p->z[i], p->S[i])
		    *softened(p->z[i] - b, p->S[i])*softened(1 - conj(b)*p->z[i], p->S[i]);
	return chi2(p, q);
}

double
parts_rectangle(const Parts *p, const double complex corner[4])
{
	double q[PARTS];
	int i, k;

	for (i = 0; i < p->n; i++)
		for (q[i] = 1, k = 0; k < 4; k++)
			q[i] *= softened(p->z[i] - corner[k], p->S[i]);
	return chi2(p, q);
}

/* ---- the best pair --------------------------------------------------- */

/* The point of the disk that is (x,y) away from c, as a hyperbolic distance. */
static double complex
step(double complex c, double x, double y)
{
	double r = hypot(x, y);
	double complex w = r > 0 ? tanh(r)/r*CMPLX(x, y) : 0;

	return (w + c)/(1 + conj(c)*w);
}

/* What the simplex minimises: log chi^2, or infinity where the sock is too low. */
static double
value(const Parts *p, const double complex cone[2], const double x[FREE])
{
	double complex a = step(cone[0], x[0], x[1]), b = step(cone[1], x[2], x[3]);
	double rho = cabs((a - b)/(1 - conj(a)*b));

	if (!(rho > 0 && rho < 1) || sockplane_height(rho) < CONES_LEAST)
		return HUGE_VAL;
	return log(parts_sock(p, a, b));
}

typedef struct Simplex {
	double x[FREE+1][FREE], f[FREE+1];
} Simplex;

/* Sorts the last corner into the others, which are in order. */
static void
insert(Simplex *s, int k)
{
	double x[FREE], f = s->f[k];

	memcpy(x, s->x[k], sizeof x);
	for (; k > 0 && s->f[k-1] > f; k--) {
		memcpy(s->x[k], s->x[k-1], sizeof x);
		s->f[k] = s->f[k-1];
	}
	memcpy(s->x[k], x, sizeof x);
	s->f[k] = f;
}

/* The point at `share` of the way from the centre of all corners but the worst to the worst. */
static double
try(const Parts *p, const double complex cone[2], const Simplex *s, double share, double x[FREE])
{
	double centre;
	int k, c;

	for (c = 0; c < FREE; c++) {
		for (centre = 0, k = 0; k < FREE; k++)
			centre += s->x[k][c]/FREE;
		x[c] = centre + share*(s->x[FREE][c] - centre);
	}
	return value(p, cone, x);
}

static void
shrink(const Parts *p, const double complex cone[2], Simplex *s)
{
	int k, c;

	for (k = 1; k <= FREE; k++) {
		for (c = 0; c < FREE; c++)
			s->x[k][c] = (s->x[k][c] + s->x[0][c])/2;
		s->f[k] = value(p, cone, s->x[k]);
		insert(s, k);
	}
}

/* Nelder and Mead's downhill simplex (The Computer Journal 7 (1965) 308). */
static void
descend(const Parts *p, const double complex cone[2], Simplex *s)
{
	double x[FREE], y[FREE], f, g;

	f = try(p, cone, s, -1, x);
	if (f < s->f[0] && (g = try(p, cone, s, -2, y)) < f)
		f = g, memcpy(x, y, sizeof x);
	else if (f >= s->f[FREE-1]) {
		g = try(p, cone, s, f < s->f[FREE] ? -0.5 : 0.5, y);
		if (g >= fmin(f, s->f[FREE])) {
			shrink(p, cone, s);
			return;
		}
		f = g, memcpy(x, y, sizeof x);
	}
	memcpy(s->x[FREE], x, sizeof x);
	s->f[FREE] = f;
	insert(s, FREE);
}

/* Improves the pair; returns log chi^2. */
static double
improve(const Parts *p, double complex cone[2])
{
	Simplex s;
	int round, k;

	for (round = 0; round < ROUNDS; round++) {
		memset(&s, 0, sizeof s);
		for (k = 0; k <= FREE; k++) {
			if (k)
				s.x[k][k-1] = REACH;
			s.f[k] = value(p, cone, s.x[k]);
			insert(&s, k);
		}
		for (k = 0; k < STEPS && s.f[FREE] - s.f[0] > 1e-6; k++)
			descend(p, cone, &s);
		cone[0] = step(cone[0], s.x[0][0], s.x[0][1]);
		cone[1] = step(cone[1], s.x[0][2], s.x[0][3]);
		if (fabs(s.x[0][0]) + fabs(s.x[0][1]) + fabs(s.x[0][2]) + fabs(s.x[0][3]) < 1e-3)
			break;
	}
	return s.f[0];
}

/* The next number of a fixed sequence, in (0,1). */
static double
draw(unsigned long long *state)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return ((double)(*state >> 11) + 0.5)/(1ull << 53);
}

/* Starts: the part that is smallest in the disk for its area, and then, with a double cone there, the one
 * that is smallest in the sock.  Further starts weight the parts by random numbers. */
static void
begin(const Parts *p, int start, unsigned long long *state, double complex cone[2])
{
	double worst, here, weight;
	int i, k;

	for (k = 0; k < 2; k++)
		for (worst = -1, i = 0; i < p->n; i++) {
			weight = start ? -log(draw(state)) : 1;
			here = p->A[i]/p->S[i]*weight*weight;
			if (k)
				here *= softened(p->z[i] - cone[0], p->S[i])*softened(1 - conj(cone[0])*p->z[i], p->S[i]);
			if (here > worst && (k == 0 || p->z[i] != cone[0])) {
				worst = here;
				cone[k] = p->z[i];
			}
		}
	for (k = 0; k < 2; k++)
		cone[k] *= fmin(1, 0.98/cabs(cone[k]));
	while (cabs((cone[0] - cone[1])/(1 - conj(cone[0])*cone[1])) > 0.99)
		cone[0] *= 0.9, cone[1] *= 0.9;
}

void
cones_choose(const Parts *p, double complex cone[2])
{
	unsigned long long state = 1;
	double complex at[2] = { 0, 0 };
	double best = HUGE_VAL, f;
	int start;

	for (start = 0; start < STARTS; start++) {
		begin(p, start, &state, at);
		f = improve(p, at);
		if (start == 0 || f < best) {
			best = f;
			cone[0] = at[0], cone[1] = at[1];
		}
	}
}
