/* chartmap.c - rectangle, unit disk and sock. */
#include <math.h>

#include "chartmap.h"
#include "harmonic.h"

/* ---- the rectangle and the disk -------------------------------------- */

/* With Z = sqrt(k) sn the rectangle is the upper half plane, its lower half |Z| < 1.  The upper half is
 * its reflection, 1/conj(Z).  z = (Z - i)/(Z + i). */
static double complex
disk_of(const SockPlane *half, double T, double x, double y)
{
	int upper = y > T/2;
	double complex Z = sockplane_z(half, x/2, (upper ? T - y : y)/2);

	return upper ? (1 - I*conj(Z))/(1 + I*conj(Z)) : (Z - I)/(Z + I);
}

static void
rectangle_of(const SockPlane *half, double T, double complex z, double *x, double *y)
{
	int upper = cabs(1 + z) > cabs(1 - z);
	double complex Z = upper ? conj(-I*(1 - z)/(1 + z)) : I*(1 + z)/(1 - z);
	double u, v;

	sockplane_uv(half, CMPLX(creal(Z), cimag(Z) > 0 ? cimag(Z) : 0), &u, &v);
	*x = u > 0.75 ? 0 : fmin(2*u, 1);       /* u is in 0 .. 1/2, up to rounding */
	*y = upper ? T - 2*v : 2*v;
}

double complex
chartmap_disk(double T, double x, double y)
{
	SockPlane half = sockplane(T/4);

	return disk_of(&half, T, x, y);
}

/* ---- the sock -------------------------------------------------------- */

static double complex
moved(double complex a, double complex z)
{
	return (z - a)/(1 - conj(a)*z);
}

static void
sock_place(const ChartMap *m, double u, double v, double *x, double *y)
{
	double complex f = moved(-m->sock.s, sockplane_z(&m->sock, u, v));
	double complex z = moved(-m->a, f/m->turn);

	*x = creal(z), *y = cimag(z);
}

static void
sock_clamp(const ChartMap *m, int sides, double *x, double *y)
{
	double r = hypot(*x, *y);

	(void)m;
	if (r > 1 || (sides && r > 0))
		*x /= r, *y /= r;
}

static void
sock_point(const ChartMap *m, double place_x, double place_y, double *x, double *y)
{
	rectangle_of(&m->half, m->T, CMPLX(place_x, place_y), x, y);
}

static void
sock_uv(const ChartMap *m, double x, double y, double *u, double *v)
{
	double complex f = m->turn*moved(m->a, disk_of(&m->half, m->T, x, y));

	sockplane_uv(&m->sock, moved(m->sock.s, f), u, v);
	if (x == 0 || x == 1 || y == 0 || y == m->T)
		*v = m->sock.T;
}

ChartMap
chartmap_sock(double T, double complex a, double complex b)
{
	double complex fb = moved(a, b);
	ChartMap m = { .kind = &CHART_SOCK, .T = T, .half = sockplane(T/4), .a = a, .turn = cabs(fb)/fb };

	m.sock = sockplane(sockplane_height(cabs(fb)));
	m.chart_T = m.sock.T;
	return m;
}

/* ---- the rectangle as a chart ---------------------------------------- */

static void
same(const ChartMap *m, double a, double b, double *x, double *y)
{
	(void)m;
	*x = a, *y = b;
}

static void
rectangle_clamp(const ChartMap *m, int sides, double *x, double *y)
{
	*x = sides & SIDE_LEFT ? 0 : sides & SIDE_RIGHT ? 1 : fmin(fmax(*x, 0), 1);
	*y = sides & SIDE_BOTTOM ? 0 : sides & SIDE_TOP ? m->T : fmin(fmax(*y, 0), m->T);
}

ChartMap
chartmap_rectangle(double T)
{
	return (ChartMap){ .kind = &CHART_RECTANGLE, .T = T, .chart_T = T };
}

/* ---- either ---------------------------------------------------------- */

static const struct Functions {
	const ChartKind *kind;
	void (*place)(const ChartMap *m, double u, double v, double *x, double *y);
	void (*clamp)(const ChartMap *m, int sides, double *x, double *y);
	void (*point)(const ChartMap *m, double place_x, double place_y, double *x, double *y);
	void (*uv)(const ChartMap *m, double x, double y, double *u, double *v);
} functions[] = {
	{ &CHART_RECTANGLE, same, rectangle_clamp, same, same },
	{ &CHART_SOCK, sock_place, sock_clamp, sock_point, sock_uv },
};

static const struct Functions *
of(const ChartMap *m)
{
	const struct Functions *f = functions;

	while (f->kind != m->kind)
		f++;
	return f;
}

void
chartmap_place(const ChartMap *m, double u, double v, double *x, double *y)
{
	of(m)->place(m, u, v, x, y);
}

void
chartmap_clamp(const ChartMap *m, int sides, double *x, double *y)
{
	of(m)->clamp(m, sides, x, y);
}

void
chartmap_point(const ChartMap *m, double place_x, double place_y, double *x, double *y)
{
	of(m)->point(m, place_x, place_y, x, y);
}

void
chartmap_uv(const ChartMap *m, double x, double y, double *u, double *v)
{
	of(m)->uv(m, x, y, u, v);
}
