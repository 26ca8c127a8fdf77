/* charted.h - triangulated surfaces with chart coordinates, for tests.  Include after
 * cmock.h. */
#ifndef CHARTED_H
#define CHARTED_H

#include <math.h>
#include <string.h>

#include "../lib/sample/clough.h"
#include "../lib/synth/delaunay.h"
#include "../lib/synth/rng.h"
#include "../lib/synth/synth.h"
#include "../lib/base/vec3.h"

typedef struct Charted {
	Mesh           m;
	double        *u, *v;
	Jet           *jet;
	int            low, limited;    /* vertices whose state has GRADIENT_LOW, GRADIENT_LIMITED */
	Clough         c;
} Charted;

/* A surface: computes phi(u,v) and its exact derivatives. */
typedef void Surface(double u, double v, double phi[3], Jet *jet);

static inline double
rng_between(uint64_t *s, double lo, double hi)
{
	return lo + (hi - lo)*rng_unit(s);
}

static inline Charted
charted_of(Mesh m, const double *uv)
{
	Charted s = { .m = m };
	int i;

	s.u = malloc(m.nv*sizeof *s.u);
	s.v = malloc(m.nv*sizeof *s.v);
	s.jet = malloc(m.nv*sizeof *s.jet);
	assert_true(s.u && s.v && s.jet);
	for (i = 0; i < m.nv; i++) {
		s.u[i] = uv[2*i];
		s.v[i] = uv[2*i + 1];
	}
	return s;
}

/* The rectangle [0,1.5] x [0,1], triangulated with about n evenly spread vertices.  The positions
 * in space are not set: see charted_place. */
static inline Charted
charted_even(int n)
{
	double *uv;
	Charted s;
	Synth y;
	Mesh m;

	assert_int_equal(synth_init(&y, "rectangle"), 0);
	assert_int_equal(synth_mesh(&y, n, 1, &m, &uv), 0);
	s = charted_of(m, uv);
	free(uv);
	return s;
}

static inline Charted
charted_random(int n, uint64_t seed)
{
	double *uv = malloc(2*n*sizeof *uv);
	Mesh m = { n, 0, calloc(3*n, sizeof(double)), malloc(6*n*sizeof(int)) };
	Charted s;
	int i;

	assert_true(uv && m.xyz && m.tri);
	for (i = 0; i < n; i++) {
		uv[2*i] = i < 4 ? 1.5*(i == 1 || i == 2) : rng_between(&seed, 0, 1.5);
		uv[2*i + 1] = i < 4 ? i >= 2 : rng_between(&seed, 0, 1);
	}
	assert_int_equal(delaunay(n, uv, m.tri, &m.nf), 0);
	s = charted_of(m, uv);
	free(uv);
	return s;
}

static inline void
charted_place(Charted *s, Surface *f)
{
	Jet ignored;
	int i;

	for (i = 0; i < s->m.nv; i++)
		f(s->u[i], s->v[i], &s->m.xyz[3*i], &ignored);
}

static inline void
charted_fit(Charted *s)
{
	unsigned char *state = malloc(s->m.nv + 1);
	Stars stars;
	int i;

	assert_non_null(state);
	memset(state, GRADIENT_WANTED, s->m.nv);
	assert_int_equal(stars_init(&stars, &s->m, s->u, s->v), 0);
	gradient_fit(&stars, &s->m, s->u, s->v, state, s->jet);
	for (s->low = s->limited = i = 0; i < s->m.nv; i++) {
		assert_true(state[i] & GRADIENT_KNOWN);
		s->low += (state[i] & GRADIENT_LOW) != 0;
		s->limited += (state[i] & GRADIENT_LIMITED) != 0;
	}
	stars_free(&stars);
	free(state);
	s->c = (Clough){ &s->m, s->u, s->v, s->jet };
}

static inline void
charted_free(Charted *s)
{
	mesh_free(&s->m);
	free(s->u);
	free(s->v);
	free(s->jet);
}

static inline double
distance3(const double a[3], const double b[3])
{
	double d[3];

	sub3(a, b, d);
	return norm3(d);
}

static inline double
charted_longest(const Mesh *m, int t)
{
	double most = 0;
	int k;

	for (k = 0; k < 3; k++)
		most = fmax(most, distance3(&m->xyz[3*m->tri[3*t + k]], &m->xyz[3*m->tri[3*t + (k+1)%3]]));
	return most;
}

#define CHARTED_SIZE 1000

/* Rotates x by 1 radian about (1,2,2)/3 and multiplies it by CHARTED_SIZE.  A position (place = 1)
 * is also translated; a derivative (place = 0) is not. */
static inline void
charted_move(double x[3], int place)
{
	const double a[3] = { 1/3.0, 2/3.0, 2/3.0 }, d = dot3(a, x)*(1 - cos(1));
	double ax[3];
	int c;

	cross3(a, x, ax);
	for (c = 0; c < 3; c++)
		x[c] = CHARTED_SIZE*(cos(1)*x[c] + sin(1)*ax[c] + d*a[c]) + 4*place;
}

/* A surface whose coordinates are cubic polynomials of u and v, without any symmetry. */
static inline void
cubic(double u, double v, double phi[3], Jet *j)
{
	double z = 0.3 + 0.2*u - 0.1*v + 0.3*u*u - 0.2*u*v + 0.1*v*v + 0.2*u*u*u - 0.3*u*u*v + 0.1*u*v*v - 0.2*v*v*v;

	phi[0] = 2*u - v, phi[1] = u + v + 0.1*u*u*v, phi[2] = z;
	*j = (Jet){ { 2, 1 + 0.2*u*v, 0.2 + 0.6*u - 0.2*v + 0.6*u*u - 0.6*u*v + 0.1*v*v },
		{ -1, 1 + 0.1*u*u, -0.1 - 0.2*u + 0.2*v - 0.3*u*u + 0.2*u*v - 0.6*v*v },
		{ 0, 0.2*v, 0.6 + 1.2*u - 0.6*v }, { 0, 0.2*u, -0.2 - 0.6*u + 0.2*v },
		{ 0, 0, 0.2 + 0.2*u - 1.2*v } };
}

static inline void
wavy(double u, double v, double phi[3], Jet *j)
{
	double s = sin(3*u + v), c = cos(3*u + v), e = exp(u - 2*v)/2;

	phi[0] = u + s/5, phi[1] = v + e, phi[2] = c/3;
	*j = (Jet){ { 1 + 3*c/5, e, -s }, { c/5, 1 - 2*e, -s/3 }, { -9*s/5, e, -3*c },
		{ -3*s/5, -2*e, -c }, { -s/5, 4*e, -c/3 } };
}

/* Degenerate input: in (u,v) some triangles are flat, flipped, tiny or collapsed to a point; the
 * positions in space are noise of sizes from 1e-4 to 1. */
static inline Charted
charted_rubbish(uint64_t seed)
{
	Charted s = charted_random(400, seed);
	int i, c;

	for (i = 0; i < s.m.nv; i++) {
		double size = pow(10, -4*rng_unit(&seed));

		if (i%7 == 0)
			s.u[i] = 0;
		if (i%11 == 0)
			s.u[i] = s.u[i/2], s.v[i] = s.v[i/2];
		if (i%13 == 0)
			s.u[i] += rng_between(&seed, -0.3, 0.3);
		if (i > 200)
			s.u[i] *= 1e-4;
		for (c = 0; c < 3; c++)
			s.m.xyz[3*i + c] = i%17 ? size*rng_between(&seed, -1, 1) : 0;
	}
	return s;
}

#endif
