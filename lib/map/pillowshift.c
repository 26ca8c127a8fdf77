/* pillowshift.c - displacements in two planes. */
#include <math.h>
#include <stdlib.h>

#include "../grid/bicubic.h"
#include "pillowshift.h"

enum { MOST_STEPS = 60 };
static const double NEAR = 1e-12;       /* last step of the iteration, over |z| + s */

/* The point at z of the plane h: of z or of 1/z. */
static void
point_of(double complex z, int h, Spinor Z)
{
	Z[h] = z;
	Z[1-h] = 1;
	moebius_normalise(Z);
}

void
pillowshift_nodes(Chart g, Spinor *at)
{
	PillowPlane plane = pillowplane(g.T);
	int p;

	#pragma omp parallel for schedule(static)
	for (p = 0; p < g.nu*g.nv; p++) {
		pillowplane_z(&plane, chart_u(g, p%g.nu), chart_v(g, p/g.nu), at[p]);
		moebius_normalise(at[p]);
	}
}

int
pillowshift_init(PillowShift *s, Chart g, Spinor *at)
{
	size_t n = (size_t)g.nu*g.nv;
	Spinor *node = malloc(n*sizeof *node);
	double *room = malloc(4*n*sizeof *room);
	int p, h;

	*s = (PillowShift){ g, pillowplane(g.T), { { room, room + n }, { room + 2*n, room + 3*n } } };
	if (!node || !room) {
		free(node);
		free(room);
		return PILLOWSHIFT_ENOMEM;
	}
	pillowshift_nodes(g, node);
	for (p = 0; p < (int)n; p++)
		for (h = 0; h < 2; h++) {
			/* b/b' - a/a' without cancellation of equal points far out */
			double complex d = (at[p][h]*node[p][1-h] - node[p][h]*at[p][1-h])/(at[p][1-h]*node[p][1-h]);

			s->d[h][0][p] = isfinite(creal(d)) ? creal(d) : 0;
			s->d[h][1][p] = isfinite(cimag(d)) ? cimag(d) : 0;
		}
	free(node);
	return 0;
}

void
pillowshift_free(PillowShift *s)
{
	free(s->d[0][0]);
	s->d[0][0] = NULL;
}

/* The displacement at z in plane h. */
static double complex
displacement(const PillowShift *s, double complex z, int h)
{
	double u, v;
	Spinor Z;
	Bicubic at;

	Z[h] = z;
	Z[1-h] = 1;
	pillowplane_uv(&s->plane, Z, &u, &v);
	at = bicubic_at(s->g, u/chart_h(s->g) - 0.5, v/chart_k(s->g) - 0.5);
	return CMPLX(bicubic_value(&at, s->d[h][0]), bicubic_value(&at, s->d[h][1]));
}

void
pillowshift_to(const PillowShift *s, const Spinor from, Spinor to)
{
	int h = cabs(from[0]) > cabs(from[1]);
	double complex z = from[h]/from[1-h];

	point_of(z + displacement(s, z, h), h, to);
}

void
pillowshift_from(const PillowShift *s, const Spinor to, Spinor from)
{
	int h = cabs(to[0]) > cabs(to[1]), k;
	double complex target = to[h]/to[1-h], z = target, next;
	double step = HUGE_VAL;

	for (k = 0; k < MOST_STEPS && step > NEAR*(cabs(z) + s->plane.half.s); k++) {
		next = target - displacement(s, z, h);
		step = cabs(next - z);
		z = next;
	}
	point_of(z, h, from);
}
