/* spheresampler.c - two stereographic charts, and the mean of both round the equator. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "spheresampler.h"

static const double BAND = 0.2;                 /* both halves are sampled where |log |z|| is less */
static const double LONG = 0.38268343236508977; /* sin(45 degrees/2): the chord of the longest side, over 2 */

/* z in the chart of half h. */
static double complex
chart(const double complex Z[2], int h)
{
	return Z[h]/Z[1-h];
}

/* ---- preparation ----------------------------------------------------- */

static int
is_long(const int c[3], double complex (*Z)[2])
{
	int k;

	for (k = 0; k < 3; k++) {
		const double complex *a = Z[c[k]], *b = Z[c[(k+1)%3]];

		if (!(cabs(a[0]*b[1] - a[1]*b[0]) <= LONG))
			return 1;
	}
	return 0;
}

static int
is_within(const int c[3], double complex (*Z)[2], int h)
{
	int k;

	for (k = 0; k < 3; k++)
		if (!(cabs(Z[c[k]][h]) < SPHERESAMPLER_REACH*cabs(Z[c[k]][1-h])))
			return 0;
	return 1;
}

/* Sets p to the faces of d within reach of half h, with a copy of nothing else. */
static int
restrict_to(const Disk *d, double complex (*Z)[2], int h, Disk *p)
{
	int *number = malloc(d->m.nf*sizeof *number), t, k, n = 0;

	p->m = d->m;
	p->m.tri = malloc(3*(size_t)d->m.nf*sizeof *p->m.tri);
	p->twin = malloc(3*(size_t)d->m.nf*sizeof *p->twin);
	if (!number || !p->m.tri || !p->twin) {
		free(number);
		return SPHERESAMPLER_ENOMEM;
	}
	for (t = 0; t < d->m.nf; t++)
		number[t] = is_within(&d->m.tri[3*(size_t)t], Z, h) ? n++ : -1;
	p->m.nf = n;
	for (t = 0; t < d->m.nf; t++)
		for (k = 0; k < 3 && number[t] >= 0; k++) {
			size_t to = 3*(size_t)number[t] + k;
			int twin = d->twin[3*(size_t)t + k];

			p->m.tri[to] = d->m.tri[3*(size_t)t + k];
			p->twin[to] = twin < 0 || number[twin/3] < 0 ? -1 : 3*number[twin/3] + twin%3;
		}
	free(number);
	return 0;
}

/* The places in the unit square; that of a vertex out of reach, which has no face, does not matter. */
static void
place_vertices(SphereHalf *a, int n, double complex (*Z)[2], int h)
{
	int i;

	#pragma omp parallel for schedule(static)
	for (i = 0; i < n; i++) {
		double complex z = chart(Z[i], h);
		int within = cabs(z) < SPHERESAMPLER_REACH;

		a->u[i] = within ? 0.5 + creal(z)/(2*SPHERESAMPLER_REACH) : 0;
		a->v[i] = within ? 0.5 + cimag(z)/(2*SPHERESAMPLER_REACH) : 0;
	}
}

/* Marks the vertices of faces with long sides.  Returns the number of these faces. */
static int
mark_long(const Disk *d, double complex (*Z)[2], unsigned char *rough)
{
	int t, k, n = 0;

	for (t = 0; t < d->m.nf; t++) {
		const int *c = &d->m.tri[3*(size_t)t];

		if (!is_long(c, Z))
			continue;
		n++;
		for (k = 0; rough && k < 3; k++)
			rough[c[k]] = 1;
	}
	return n;
}

/* Whether faces of half h are turned over.  *more: the number of these whose first corner lies in it, without those with
 * long sides. */
static int
find_flat(const SphereHalf *a, double complex (*Z)[2], int h, int *more)
{
	int t, any = 0;

	for (*more = t = 0; t < a->part.m.nf; t++) {
		const int *c = &a->part.m.tri[3*(size_t)t];
		double r = cabs(chart(Z[c[0]], h));

		if (r > exp(2*BAND) || !locate_is_flat(&a->s.l, t))
			continue;
		any = 1;
		*more += (h ? r < 1 : r <= 1) && !is_long(c, Z);
	}
	return any;
}

static void
half_free(SphereHalf *a)
{
	sampler_free(&a->s);
	free(a->part.m.tri);
	free(a->part.twin);
	free(a->fine.d.m.tri);
	free(a->fine.d.twin);
	free(a->u);
	free(a->v);
	free(a->rough);
}

static int
half_init(SphereSampler *s, const Disk *d, const Subdivision *mesh, double complex (*Z)[2], int surface, int h)
{
	SphereHalf *a = &s->half[h];
	int nv = mesh->d.m.nv, smooth = surface == SAMPLER_SMOOTH, rough, flat, more;

	a->fine = *mesh;
	a->fine.d.m.tri = a->fine.d.twin = NULL;
	a->u = malloc(nv*sizeof *a->u);
	a->v = malloc(nv*sizeof *a->v);
	a->rough = calloc(d->m.nv, 1);
	if (!a->u || !a->v || !a->rough || restrict_to(&mesh->d, Z, h, &a->fine.d)
	    || (smooth && restrict_to(d, Z, h, &a->part)))
		return SPHERESAMPLER_ENOMEM;
	if (a->fine.d.m.nf == 0)
		return SPHERESAMPLER_ECOARSE;
	place_vertices(a, nv, Z, h);
	if (sampler_init(&a->s, smooth ? &a->part : &a->fine.d, a->u, a->v, 1, surface))
		return SPHERESAMPLER_ENOMEM;
	if (!smooth)
		return 0;
	rough = mark_long(d, Z, a->rough);
	flat = find_flat(a, Z, h, &more);
	if (a->part.m.nf == 0 && rough < d->m.nf)
		return SPHERESAMPLER_ECOARSE;
	s->overlaid += more + (h == 0 ? rough : 0);
	return (rough || flat) && sampler_overlay(&a->s, &a->fine, a->u, a->v, a->rough) ? SPHERESAMPLER_ENOMEM : 0;
}

int
spheresampler_init(SphereSampler *s, const Disk *d, const Subdivision *mesh, double complex (*Z)[2], int surface)
{
	int h, e = 0;

	memset(s, 0, sizeof *s);
	if (mark_long(&mesh->d, Z, NULL))
		return SPHERESAMPLER_ECOARSE;
	for (h = 0; h < 2 && !e; h++)
		e = half_init(s, d, mesh, Z, surface, h);
	if (e)
		spheresampler_free(s);
	return e;
}

void
spheresampler_free(SphereSampler *s)
{
	half_free(&s->half[0]);
	half_free(&s->half[1]);
}

/* ---- sampling -------------------------------------------------------- */

/* The points that half h samples: their numbers and places. */
typedef struct Points {
	int     n, *number;
	double *x, *y, *to[3];
} Points;

static int
points_init(Points *p, int n, double complex (*at)[2], int h)
{
	int i, c;
	double complex z;

	*p = (Points){ 0, malloc(n*sizeof *p->number), malloc(5*(size_t)n*sizeof *p->x), NULL, { NULL, NULL, NULL } };
	if (!p->number || !p->x)
		return SPHERESAMPLER_ENOMEM;
	p->y = p->x + n;
	for (c = 0; c < 3; c++)
		p->to[c] = p->x + (2 + c)*(size_t)n;
	for (i = 0; i < n; i++) {
		if (!(cabs(at[i][h]) < exp(BAND)*cabs(at[i][1-h])))
			continue;
		z = chart(at[i], h);
		p->x[p->n] = 0.5 + creal(z)/(2*SPHERESAMPLER_REACH);
		p->y[p->n] = 0.5 + cimag(z)/(2*SPHERESAMPLER_REACH);
		p->number[p->n++] = i;
	}
	return 0;
}

static void
points_free(Points *p)
{
	free(p->number);
	free(p->x);
}

/* The weight of half h at a point within its band. */
static double
weight(const double complex at[2], int h)
{
	double t = (log(cabs(at[h])/cabs(at[1-h]))/BAND + 1)/2;

	return t <= 0 ? 1 : t >= 1 ? 0 : 1 - t*t*(3 - 2*t);
}

/* Samples the positions, or the field f, on both halves. */
static int
sample(const SphereSampler *s, const double *f, int n, double complex (*at)[2], int dimensions, double *const to[])
{
	int h, c, i, e = 0;
	Channel channel = { .n = 1, .f = (double *)f };

	for (c = 0; c < dimensions; c++)
		memset(to[c], 0, n*sizeof *to[c]);
	for (h = 0; h < 2 && !e; h++) {
		const Sampler *on = &s->half[h].s;
		Points p;

		e = points_init(&p, n, at, h);
		if (!e && p.n > 0)
			e = f ? sampler_channel(on, &channel, p.n, p.x, p.y, p.to) : sampler_points(on, p.n, p.x, p.y, p.to);
		for (i = 0; !e && i < p.n; i++)
			for (c = 0; c < dimensions; c++)
				to[c][p.number[i]] += weight(at[p.number[i]], h)*p.to[c][i];
		points_free(&p);
	}
	return e ? SPHERESAMPLER_ENOMEM : 0;
}

int
spheresampler_points(const SphereSampler *s, int n, double complex (*at)[2], double *const phi[3])
{
	return sample(s, NULL, n, at, 3, phi);
}

int
spheresampler_field(const SphereSampler *s, const double *f, int n, double complex (*at)[2], double *to)
{
	return sample(s, f, n, at, 1, &to);
}
