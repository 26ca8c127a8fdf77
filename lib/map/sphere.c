/* sphere.c - dipole, alternating harmonic functions, and splitting where the map is least conformal. */
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "cotangent.h"
#include "sphere.h"
#include "worst.h"
#include "../base/vec3.h"
#include "../sparse/chol.h"

enum { ROUNDS = 2 };                    /* of Schwarz's method */
enum { CENTRING = 200 };                /* steps */
enum { FEWEST = 200 };                  /* vertices: less do not resolve a pole */
static const double FREE = 0.75;        /* share of the vertices that are free in a half round */
static const double FAR = 1e100;        /* 1/z at z = 0, a vertex that is not free */

/* ---- the faces ------------------------------------------------------- */

/* The shape of a face: its side from corner 0 to 1 is (length,0), that to corner 2 is (x,height). */
typedef struct Shape {
	double length, x, height;
} Shape;

static Shape
shape_of(const Mesh *m, int t)
{
	const int *c = &m->tri[3*(size_t)t];
	double a[3], b[3], n[3];
	Shape s;

	sub3(&m->xyz[3*(size_t)c[1]], &m->xyz[3*(size_t)c[0]], a);
	sub3(&m->xyz[3*(size_t)c[2]], &m->xyz[3*(size_t)c[0]], b);
	cross3(a, b, n);
	s.length = norm3(a);
	s.x = dot3(a, b)/s.length;
	s.height = norm3(n)/s.length;
	return s;
}

/* The derivatives of the map of face t to the plane in which its corner 0 is at 0: f_z and f_zbar. */
static void
derivatives(const Mesh *m, Spinor *Z, int t, const Shape *s, double complex *fz, double complex *fzbar)
{
	const int *c = &m->tri[3*(size_t)t];
	double complex fx = moebius_seen_from(Z[c[0]], Z[c[1]])/s->length;
	double complex fy = (moebius_seen_from(Z[c[0]], Z[c[2]]) - fx*s->x)/s->height;

	*fz = (fx - I*fy)/2;
	*fzbar = (fx + I*fy)/2;
}

void
sphere_beltrami(const Mesh *m, Spinor *Z, double *mu, int *turned)
{
	double sum = 0, all = 0, area, small;
	double complex fz, fzbar;
	Shape s;
	int t;

	for (*turned = 0, t = 0; t < m->nf; t++) {
		s = shape_of(m, t);
		derivatives(m, Z, t, &s, &fz, &fzbar);
		area = s.length*s.height/2;
		small = cabs(fzbar) < cabs(fz) ? cabs(fzbar)/cabs(fz) : 1;
		*turned += small == 1;
		sum += area*small;
		all += area;
	}
	*mu = sum/all;
}

/* The energy of face t less the area of its image, on the unit sphere, whose element at 0 is 2 |dz|:
 * 4 (|f_z|^2 + |f_zbar|^2) A - 4 (|f_z|^2 - |f_zbar|^2) A. */
static double
term(const Mesh *m, Spinor *Z, int t)
{
	Shape s = shape_of(m, t);
	double complex fz, fzbar;

	derivatives(m, Z, t, &s, &fz, &fzbar);
	return 4*s.length*s.height*(creal(fzbar)*creal(fzbar) + cimag(fzbar)*cimag(fzbar));
}

/* ---- harmonic functions ---------------------------------------------- */

typedef struct System {
	const Disk    *d;
	Cotangent      C;
	Chol           chol;
	double        *diagonal, *x;    /* [nv] */
	unsigned char *held;
	double complex *z;
} System;

static void
system_free(System *s)
{
	chol_free(&s->chol);
	cotangent_free(&s->C);
	free(s->diagonal);
	free(s->x);
	free(s->held);
	free(s->z);
}

static int
matrix(System *s, const Disk *coarse)
{
	Cotangent C0;
	int e = cotangent_init(&s->C, s->d);

	if (e || !coarse)
		return e;
	e = cotangent_init(&C0, coarse);
	if (!e) {
		e = cotangent_quadratic(&s->C, &C0);
		cotangent_free(&C0);
	}
	return e;
}

/* Linear elements on d; or quadratic ones on coarse, of which d is the refinement (rectmap.h). */
static int
system_init(System *s, const Disk *d, const Disk *coarse)
{
	int n = d->m.nv, *order = malloc(n*sizeof *order), e = SPD_ENOMEM, i, k;

	*s = (System){ .d = d, .diagonal = malloc(n*sizeof *s->diagonal), .x = malloc(n*sizeof *s->x), .held = malloc(n),
	    .z = malloc(n*sizeof *s->z) };
	if (order && s->diagonal && s->x && s->held && s->z && !matrix(s, coarse) && !order_graph(&s->C.g, order)
	    && !chol_init(&s->chol, &s->C.g, order))
		e = 0;
	for (i = 0; !e && i < n; i++)
		for (s->diagonal[i] = 0, k = s->C.g.first[i]; k < s->C.g.first[i+1]; k++)
			s->diagonal[i] -= s->C.c[k];
	free(order);
	if (e)
		system_free(s);
	return e;
}

/* Solves for s->x, the right-hand side, with the held vertices given. */
static int
solve(System *s, SpdReport *report)
{
	CholMatrix a = { s->diagonal, s->C.c, s->held };
	const Graph *g = &s->C.g;
	int i, k, e;

	for (i = 0; i < g->n; i++)
		for (k = g->first[i]; s->held[i] && k < g->first[i+1]; k++)
			if (!s->held[g->adj[k]])
				s->x[g->adj[k]] -= s->C.c[k]*s->x[i];
	e = chol_solve(&s->chol, &a, s->x, &report->column);
	for (i = 0; !e && i < g->n; i++)
		if (!isfinite(s->x[i])) {
			report->column = i;
			e = CHOL_EINDEFINITE;
		}
	return e == CHOL_ENOMEM ? SPD_ENOMEM : e ? SPD_EINDEFINITE : 0;
}

/* Makes s->z harmonic at the vertices that are not held. */
static int
fill(System *s, SpdReport *report)
{
	int n = s->C.g.n, part, i, e = 0;

	for (part = 0; !e && part < 2; part++) {
		for (i = 0; i < n; i++)
			s->x[i] = !s->held[i] ? 0 : part ? cimag(s->z[i]) : creal(s->z[i]);
		e = solve(s, report);
		for (i = 0; !e && i < n; i++)
			if (!s->held[i])
				s->z[i] = part ? CMPLX(creal(s->z[i]), s->x[i]) : CMPLX(s->x[i], 0);
	}
	return e;
}

static int
rising(const void *a, const void *b)
{
	double x = *(const double *)a, y = *(const double *)b;

	return (x > y) - (x < y);
}

/* Replaces z by 1/z, and makes it harmonic but at the vertices where it is largest. */
static int
half_round(System *s, SpdReport *report)
{
	int n = s->C.g.n, i;
	double bound;

	for (i = 0; i < n; i++) {
		s->z[i] = s->z[i] == 0 ? FAR : 1/s->z[i];
		s->x[i] = cabs(s->z[i]);
	}
	qsort(s->x, n, sizeof *s->x, rising);
	bound = s->x[(int)(FREE*n)];
	for (i = 0; i < n; i++)
		s->held[i] = cabs(s->z[i]) > bound;
	return fill(s, report);
}

static int
alternate(System *s, SpdReport *report)
{
	int k, e = 0;

	for (k = 0; !e && k < 2*ROUNDS; k++)
		e = half_round(s, report);
	return e;
}

static int
largest_face(const Mesh *m)
{
	int t, at = 0;
	double most = -1, area;
	Shape s;

	for (t = 0; t < m->nf; t++) {
		s = shape_of(m, t);
		area = s.length*s.height;
		if (area > most) {
			most = area;
			at = t;
		}
	}
	return at;
}

/* The function with a pole in the largest face: the Laplacians of its parts are the derivatives of a delta
 * function there, along the two axes of the face. */
static int
dipole(System *s, SpdReport *report)
{
	const Mesh *m = &s->d->m;
	int t = largest_face(m), part, i, e = 0;
	const int *c = &m->tri[3*(size_t)t];
	Shape f = shape_of(m, t);
	const double slope[2][3] = {
		{ -1/f.length, 1/f.length, 0 },
		{ (1 - f.x/f.length)/f.height, f.x/(f.length*f.height), -1/f.height }
	};

	memset(s->held, 0, m->nv);
	s->held[c[0]] = 1;
	for (part = 0; !e && part < 2; part++) {
		memset(s->x, 0, m->nv*sizeof *s->x);
		s->x[c[1]] = slope[part][1];
		s->x[c[2]] = slope[part][2];
		e = solve(s, report);
		for (i = 0; !e && i < m->nv; i++)
			s->z[i] = part ? CMPLX(creal(s->z[i]), s->x[i]) : CMPLX(s->x[i], 0);
	}
	return e;
}

/* ---- places on the sphere -------------------------------------------- */

/* The areas of the faces at each vertex. */
static void
areas_at_vertices(const Mesh *m, double *area)
{
	int t, k;

	memset(area, 0, m->nv*sizeof *area);
	for (t = 0; t < m->nf; t++) {
		Shape s = shape_of(m, t);

		for (k = 0; k < 3; k++)
			area[m->tri[3*(size_t)t+k]] += s.length*s.height;
	}
}

/* One step towards the centre and the size of z, below. */
static double
centre_step(const System *s, const double *area, double complex *centre, double *size)
{
	double sum[2] = { 0, 0 }, w, far;
	double complex z = 0, old = *centre;
	int i;

	for (i = 0; i < s->C.g.n; i++) {
		far = moebius_square(s->z[i] - old);
		w = area[i]/(far + *size**size);
		z += w*s->z[i];
		sum[0] += w;
		sum[1] += w*far;
	}
	*centre = z/sum[0];
	far = sqrt(sum[1]/sum[0]);
	w = fabs(far - *size) + cabs(*centre - old);
	*size = far;
	return w/far;
}

/* Moves and scales z so that the centre of the area on the sphere is its middle.  The iteration is the EM algorithm for
 * the position and the width of a Cauchy distribution, which has the same equations; it does not depend on the
 * direction of the axes of z. */
static int
centre(System *s)
{
	double *area = malloc(s->C.g.n*sizeof *area), size, all = 0;
	double complex middle = 0;
	int i, k;

	if (!area)
		return SPD_ENOMEM;
	areas_at_vertices(&s->d->m, area);
	for (i = 0; i < s->C.g.n; i++) {
		middle += area[i]*s->z[i];
		all += area[i];
	}
	middle /= all;
	for (size = 0, i = 0; i < s->C.g.n; i++)
		size += area[i]*cabs(s->z[i] - middle)/all;
	for (k = 0; k < CENTRING && centre_step(s, area, &middle, &size) > 1e-14; k++)
		;
	for (i = 0; i < s->C.g.n; i++)
		s->z[i] = (s->z[i] - middle)/size;
	free(area);
	return 0;
}

/* Mirrors z if most faces are turned over. */
static void
orient(System *s)
{
	const Mesh *m = &s->d->m;
	int i, t, turned = 0;

	for (t = 0; t < m->nf; t++) {
		const int *c = &m->tri[3*(size_t)t];

		turned += cimag(conj(s->z[c[1]] - s->z[c[0]])*(s->z[c[2]] - s->z[c[0]])) < 0;
	}
	for (i = 0; 2*turned > m->nf && i < m->nv; i++)
		s->z[i] = conj(s->z[i]);
}

static void
store(const System *s, Spinor *Z)
{
	int i;

	for (i = 0; i < s->C.g.n; i++) {
		double r = cabs(s->z[i]), norm = hypot(1, r < 1 ? r : 1/r);

		Z[i][0] = (r < 1 ? s->z[i] : s->z[i]/r)/norm;
		Z[i][1] = (r < 1 ? 1 : 1/r)/norm;
	}
}

/* Places of new vertices of s: means of those of their faces, as vectors that are multiplied by numbers of modulus 1,
 * so that all products with the first are real. */
static void
extend(const Subdivision *s, Spinor *Z)
{
	int i, k;

	for (i = s->given; i < s->d.m.nv; i++) {
		const int *c = s->corner[i - s->given];
		const double *w = s->w[i - s->given];
		const double complex *a = NULL, *b;
		double complex turn;

		Z[i][0] = Z[i][1] = 0;
		for (k = 0; k < 3; k++) {
			if (!(w[k] > 0))
				continue;
			b = Z[c[k]];
			a = a ? a : b;
			turn = conj(b[0])*a[0] + conj(b[1])*a[1];
			Z[i][0] += w[k]*turn/cabs(turn)*b[0];
			Z[i][1] += w[k]*turn/cabs(turn)*b[1];
		}
		moebius_normalise(Z[i]);
	}
}

/* ---- the map --------------------------------------------------------- */

/* Solves on m's mesh by linear elements from the dipole. */
static int
solve_linear(SphereMap *m, SpdReport *report)
{
	const Disk *d = &m->mesh.d;
	System s;
	int e = system_init(&s, d, NULL);

	if (e)
		return e;
	report->bytes = chol_bytes(&s.chol);
	e = dipole(&s, report);
	if (!e)
		e = centre(&s);
	if (!e) {
		orient(&s);
		e = alternate(&s, report);
	}
	free(m->Z);
	m->Z = e ? NULL : malloc(d->m.nv*sizeof *m->Z);
	if (m->Z)
		store(&s, m->Z);
	else if (!e)
		e = SPD_ENOMEM;
	system_free(&s);
	return e;
}

/* Splits the faces with the largest terms, if the certificate is above the tolerance.  Returns the number of
 * new vertices, or SPD_ENOMEM. */
static int
refine(SphereMap *m, const AdaptOptions *o)
{
	int nf = m->mesh.d.m.nf, nv = m->mesh.d.m.nv, t, e;
	double *terms = malloc(2*(size_t)nf*sizeof *terms), least;
	unsigned char *marked = malloc(nf);

	e = terms && marked ? 0 : SPD_ENOMEM;
	for (m->certificate = 0, t = 0; !e && t < nf; t++)
		m->certificate += (terms[t] = term(&m->mesh.d.m, m->Z, t))/(4*M_PI);
	if (!e && m->certificate > o->tolerance && nv < o->most) {
		least = worst_terms(terms, nf, (o->most - nv)/2, terms + nf);
		for (t = 0; t < nf; t++)
			marked[t] = terms[t] >= least;
		e = subdivision_refine(&m->mesh, marked, NULL, NULL) ? SPD_ENOMEM : m->mesh.d.m.nv - nv;
	}
	free(terms);
	free(marked);
	return e;
}

/* Splits every face into four, and solves by quadratic elements, from the linear solution. */
static int
solve_quadratic(SphereMap *m, SpdReport *report)
{
	Disk coarse = { 0 };
	System s = { 0 };
	Spinor *Z;
	int e = subdivision_refine(&m->mesh, NULL, NULL, &coarse) ? SPD_ENOMEM : 0, i;

	Z = e ? NULL : realloc(m->Z, m->mesh.d.m.nv*sizeof *Z);
	if (!Z) {
		disk_free(&coarse);
		return SPD_ENOMEM;
	}
	m->Z = Z;
	extend(&m->mesh, Z);
	e = system_init(&s, &m->mesh.d, &coarse);
	if (!e) {
		report->bytes = chol_bytes(&s.chol);
		for (i = 0; i < m->mesh.d.m.nv; i++)
			s.z[i] = Z[i][0]/Z[i][1];
		e = alternate(&s, report);
		if (!e)
			store(&s, Z);
		system_free(&s);
	}
	disk_free(&coarse);
	m->quadratic = 1;
	return e;
}

int
sphere_map(const Disk *d, const AdaptOptions *o, SphereMap *m, SpdReport *report)
{
	int e, k, n = 1;

	memset(m, 0, sizeof *m);
	memset(report, 0, sizeof *report);
	e = subdivision_init(&m->mesh, d) ? SPD_ENOMEM : 0;
	while (!e && m->mesh.d.m.nv < FEWEST)
		e = subdivision_refine(&m->mesh, NULL, NULL, NULL) ? SPD_ENOMEM : 0;
	while (!e && n > 0) {
		e = solve_linear(m, report);
		n = e ? 0 : refine(m, o);
		if (n < 0)
			e = SPD_ENOMEM;
	}
	for (k = 0; !e && k < o->split && m->mesh.d.m.nv <= o->most/4; k++)
		e = solve_quadratic(m, report);
	if (!e)
		sphere_beltrami(&m->mesh.d.m, m->Z, &m->mu, &m->turned);
	if (e)
		sphere_free(m);
	return e;
}

void
sphere_free(SphereMap *m)
{
	subdivision_free(&m->mesh);
	free(m->Z);
	m->Z = NULL;
}
