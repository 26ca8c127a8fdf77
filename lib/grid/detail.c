/* detail.c - offsets of vertices from a gridded surface, in frames of the surface. */
#include <stdlib.h>

#include "../base/vec3.h"
#include "detail.h"
#include "gridpoint.h"

enum { WIDE = 16 };     /* windows wider than this many cells along u and v are integrated by
                         * differences of sums over the grid; in smaller ones these differences lose
                         * too many digits where lambda is small */

/* A window in units of cells, [x0,x1] x [y0,y1]. */
typedef struct Window {
	double x0, x1, y0, y1;
} Window;

/* Adds weight times the integrals of phi_u (f[0..2]), phi_v (f[3..5]) and lambda^2 (f[6]) over cell
 * (i,j).  phi_u and phi_v are means of the differences along two opposite sides of the cell, and
 * lambda^2 = (|phi_u|^2 + |phi_v|^2)/2. */
static void
add_cell(const Detail *d, int i, int j, double weight, double f[7])
{
	const size_t p = (size_t)j*d->g.nu + i, q = p + d->g.nu;
	const double h = chart_h(d->g), k = chart_k(d->g);
	double u, v, lambda2 = 0;
	int c;

	for (c = 0; c < 3; c++) {
		const double *x = d->phi[c];

		u = (x[p+1] - x[p] + x[q+1] - x[q])/2;
		v = (x[q] - x[p] + x[q+1] - x[p+1])/2;
		f[c] += weight*k*u;
		f[3+c] += weight*h*v;
		lambda2 += (u*u*k/h + v*v*h/k)/2;
	}
	f[6] += weight*lambda2;
}

int
detail_init(Detail *d, Chart g, const double *const phi[3])
{
	const size_t n = (size_t)g.nu*g.nv;
	int c, i, j;

	*d = (Detail){ g, phi, calloc(n, sizeof *d->sum) };
	if (!d->sum)
		return DETAIL_ENOMEM;
	for (j = 1; j < g.nv; j++)
		for (i = 1; i < g.nu; i++) {
			double (*s)[7] = d->sum + (size_t)j*g.nu + i;

			for (c = 0; c < 7; c++)
				s[0][c] = s[-1][c] + s[-g.nu][c] - s[-g.nu-1][c];
			add_cell(d, i - 1, j - 1, 1, *s);
		}
	return 0;
}

void
detail_free(Detail *d)
{
	free(d->sum);
}

/* Adds weight times the integrals d->sum at the point (x,y), given in grid steps.  Inside a cell the
 * integrals are bilinear. */
static void
add_sum(const Detail *d, double x, double y, double weight, double f[7])
{
	const int i = x < d->g.nu - 2 ? (int)x : d->g.nu - 2, j = y < d->g.nv - 2 ? (int)y : d->g.nv - 2;
	const double (*s)[7] = (const double (*)[7])d->sum + (size_t)j*d->g.nu + i, t = x - i, r = y - j;
	int c;

	for (c = 0; c < 7; c++)
		f[c] += weight*((1 - r)*((1 - t)*s[0][c] + t*s[1][c]) +
		    r*((1 - t)*s[d->g.nu][c] + t*s[d->g.nu+1][c]));
}

/* The integrals of phi_u, phi_v and lambda^2 over the window. */
static void
integrate(const Detail *d, Window w, double f[7])
{
	int c, i, j;

	for (c = 0; c < 7; c++)
		f[c] = 0;
	if (w.x1 - w.x0 > WIDE && w.y1 - w.y0 > WIDE) {
		add_sum(d, w.x1, w.y1, 1, f);
		add_sum(d, w.x0, w.y1, -1, f);
		add_sum(d, w.x1, w.y0, -1, f);
		add_sum(d, w.x0, w.y0, 1, f);
		return;
	}
	for (j = (int)w.y0; j < w.y1; j++)
		for (i = (int)w.x0; i < w.x1; i++)
			add_cell(d, i, j, (fmin(i + 1, w.x1) - fmax(i, w.x0))*(fmin(j + 1, w.y1) - fmax(j, w.y0)), f);
}

/* The window round (u,v) of half width r and half height rv, each at least one cell, cut off at the
 * border of the grid. */
static Window
window(Chart g, double u, double v, double r, double rv)
{
	const double x = u/chart_h(g), y = v/chart_k(g);
	const double rx = fmax(r/chart_h(g), 1), ry = fmax(rv/chart_k(g), 1);

	return (Window){ fmax(x - rx, 0), fmin(x + rx, g.nu - 1), fmax(y - ry, 0), fmin(y + ry, g.nv - 1) };
}

/* Divides a by its length.  Returns 0, with a unchanged, if the length is 0. */
static int
normalise(double a[3])
{
	const double length = norm3(a);
	int c;

	if (!(length > 0))
		return 0;
	for (c = 0; c < 3; c++)
		a[c] /= length;
	return 1;
}

/* Some unit vector perpendicular to the unit vector a. */
static void
perpendicular(const double a[3], double b[3])
{
	const double axis[3] = { fabs(a[0]) < 0.6, fabs(a[0]) >= 0.6, 0 };

	cross3(a, axis, b);
	normalise(b);
}

/* Sets frame to e1, e2, n of detail.h for the directions a and b.  Overwrites a and b. */
static void
orthonormal(double a[3], double b[3], double frame[3][3])
{
	const double half = sqrt(0.5);
	double plus[3], minus[3];
	int c, has_a = normalise(a), has_b = normalise(b);

	if (!has_a && !has_b)
		a[0] = 1, a[1] = a[2] = 0;
	else if (!has_a)
		perpendicular(b, a);
	if (!has_b)
		perpendicular(a, b);
	for (c = 0; c < 3; c++)
		plus[c] = a[c] + b[c], minus[c] = a[c] - b[c];
	if (!normalise(plus))
		perpendicular(a, plus);
	if (!normalise(minus))
		perpendicular(a, minus);
	for (c = 0; c < 3; c++) {
		frame[0][c] = half*(plus[c] + minus[c]);
		frame[1][c] = half*(plus[c] - minus[c]);
	}
	cross3(frame[0], frame[1], frame[2]);
}

/* Computes the frame of the window round (u,v) of half width r and half height rv.  Returns the scale
 * s of detail.h. */
static double
frame_at(const Detail *d, double u, double v, double r, double rv, double frame[3][3])
{
	const Window w = window(d->g, u, v, r, rv);
	const double area = (w.x1 - w.x0)*chart_h(d->g)*(w.y1 - w.y0)*chart_k(d->g);
	double f[7];

	integrate(d, w, f);
	orthonormal(f, f + 3, frame);
	return sqrt(fmax(f[6], 0)/area);
}

/* Whether the window of half side r has an area of at least side^2 on the surface. */
static int
reaches(const Detail *d, double u, double v, double r, double side)
{
	double f[7];

	integrate(d, window(d->g, u, v, r, r), f);
	return f[6] >= side*side;
}

/* The half side of the smallest window with an area of at least side^2, by bisection; at most
 * max(1, T). */
static double
half_side(const Detail *d, double u, double v, double side)
{
	const double most = fmax(1, d->g.T);
	double lo = 0, hi = fmax(chart_h(d->g), chart_k(d->g));
	int i;

	if (reaches(d, u, v, 0, side))
		return 0;
	for (; hi < most && !reaches(d, u, v, hi, side); hi *= 2)
		lo = hi;
	if (hi >= most && !reaches(d, u, v, most, side))
		return most;
	for (i = 0; i < 20; i++) {
		const double r = (lo + hi)/2;

		if (reaches(d, u, v, r, side))
			hi = r;
		else
			lo = r;
	}
	return hi;
}

void
detail_offset(const Detail *d, double u, double v, const double x[3], double o[DETAIL_SIZE])
{
	double place[3], apart[3], frame[3][3], s;
	int c;

	gridpoint(d->g, 3, d->phi, u, v, place);
	sub3(x, place, apart);
	o[3] = half_side(d, u, v, DETAIL_REACH*norm3(apart));
	s = frame_at(d, u, v, o[3], o[3], frame);
	for (c = 0; c < 3; c++)
		o[c] = s > 0 ? dot3(apart, frame[c])/s : 0;
}

void
detail_vertex(const Detail *d, double T, double u, double v, const double o[DETAIL_SIZE], double x[3])
{
	double frame[3][3], s;
	int c;

	gridpoint(d->g, 3, d->phi, u, v, x);
	s = frame_at(d, u, v, o[3], o[3]*d->g.T/T, frame);
	for (c = 0; c < 3; c++)
		x[c] += s*(o[0]*frame[0][c] + o[1]*frame[1][c] + o[2]*frame[2][c]);
}
