/* sphereface.c - derivatives of the map of a face. */
#include "../base/vec3.h"
#include "sphereface.h"

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

double
sphereface_area2(const Mesh *m, int t)
{
	Shape s = shape_of(m, t);

	return s.length*s.height;
}

/* |mu| of a face, at most 1, and its area. */
static double
beltrami(const Mesh *m, Spinor *Z, int t, double *area)
{
	Shape s = shape_of(m, t);
	double complex fz, fzbar;

	derivatives(m, Z, t, &s, &fz, &fzbar);
	*area = s.length*s.height/2;
	return cabs(fzbar) < cabs(fz) ? cabs(fzbar)/cabs(fz) : 1;
}

double
sphereface_term(const Mesh *m, Spinor *Z, int t)
{
	double area, mu = beltrami(m, Z, t, &area);

	return 2*mu*mu*area;
}

void
sphereface_beltrami(const Mesh *m, Spinor *Z, double *mu, int *turned)
{
	double sum = 0, all = 0, area, here;
	int t;

	for (*turned = 0, t = 0; t < m->nf; t++) {
		here = beltrami(m, Z, t, &area);
		*turned += here == 1;
		sum += area*here;
		all += area;
	}
	*mu = sum/all;
}
