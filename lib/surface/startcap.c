/* startcap.c - the start on the sock: a spherical cap. */
#include <math.h>
#include <stdlib.h>

#include "../base/field.h"
#include "../base/procrustes.h"
#include "../base/sockplane.h"
#include "../poisson/plate.h"
#include "start.h"

enum { ROUNDS = 100 };
static const double CENTRED = 1e-6;

/* The first node of the border, the row v = T. */
static size_t
border_of(Chart g)
{
	return (size_t)(g.nv - 1)*g.nu;
}

/* The length of the border edge from column i on. */
static double
edge(const Level *l, int i)
{
	size_t n = level_nodes(l->g), p = border_of(l->g) + i, q = border_of(l->g) + (i + 1)%l->g.nu;
	double sum = 0;
	int c;

	for (c = 0; c < 3; c++)
		sum = hypot(sum, l->phi[c*n+q] - l->phi[c*n+p]);
	return sum;
}

static double
border_length(const Level *l)
{
	double sum = 0;
	int i;

	for (i = 0; i < l->g.nu; i++)
		sum += edge(l, i);
	return sum;
}

/* The integral of a density f. */
static double
integral(Chart g, const double *f)
{
	size_t p;
	double sum = 0;

	for (p = 0; p < level_nodes(g); p++)
		sum += (p < border_of(g) ? 1 : 0.5)*f[p];
	return sum*chart_h(g)*chart_k(g);
}

/* Sets z to the unit disk, moved so that the border is centred. */
static void
centred_disk(const Level *l, double length, double complex *z)
{
	SockPlane plane = sockplane(l->g.T);
	size_t n = level_nodes(l->g), first = border_of(l->g), p;
	double complex mean = 1;
	int i, k;

	for (p = 0; p < n; p++)
		z[p] = sockplane_z(&plane, chart_u(l->g, p%l->g.nu), chart_v(l->g, p/l->g.nu));
	for (k = 0; k < ROUNDS && cabs(mean) > CENTRED && length > 0; k++) {
		mean = 0;
		for (i = 0; i < l->g.nu; i++)
			mean += (edge(l, i) + edge(l, (i + l->g.nu - 1)%l->g.nu))/(2*length)*z[first+i];
		for (p = 0; p < n; p++)
			z[p] = (z[p] - mean)/(1 - conj(mean)*z[p]);
	}
}

/* Sets x[n][3] to a cap of boundary length `length` and stereographic radius |c|; its border lies in the
 * plane x[2] = 0, its H has the sign of c. */
static void
cap(size_t n, const double complex *z, double length, double c, double *x)
{
	double size = length/(2*M_PI), r2, r;
	size_t p;

	for (p = 0; p < n; p++) {
		r2 = creal(z[p])*creal(z[p]) + cimag(z[p])*cimag(z[p]);
		r = 1 + c*c*r2;
		x[3*p] = size*(1 + c*c)*creal(z[p])/r;
		x[3*p+1] = size*(1 + c*c)*cimag(z[p])/r;
		x[3*p+2] = size*c*(r2 - 1)/r;
	}
}

/* Moves the cap x rigidly so that its border comes nearest to that of phi; a border that is too large to
 * be squared leaves it where it is. */
static int
place(const Level *l, double *x)
{
	size_t n = level_nodes(l->g), first = border_of(l->g);
	double (*b)[3] = malloc(l->g.nu*sizeof *b), rms;
	Rigid r;
	int i, c;

	if (!b)
		return START_ENOMEM;
	for (i = 0; i < l->g.nu; i++)
		for (c = 0; c < 3; c++)
			b[i][c] = l->phi[c*n + first + i];
	if (procrustes(l->g.nu, NULL, b[0], x + 3*first, &r, &rms) == 0)
		rigid_move(&r, (int)n, x);
	free(b);
	return 0;
}

/* phi = x plus the harmonic field whose border is that of phi - x. */
static int
bend(const Level *l, const double *x)
{
	size_t n = level_nodes(l->g), first = border_of(l->g), p;
	double *d = calloc(3*n, sizeof *d), k = chart_k(l->g);
	Plate plate;
	int c;

	if (!d || plate_init(&plate, l->g, 0)) {
		free(d);
		return START_ENOMEM;
	}
	for (c = 0; c < 3; c++)
		for (p = first; p < n; p++)
			d[c*n + p - l->g.nu] = (l->phi[c*n+p] - x[3*p+c])/(k*k);
	plate_solve(&plate, 0, 1, 0, d);
	for (c = 0; c < 3; c++)
		for (p = 0; p < first; p++)
			l->phi[c*n+p] = x[3*p+c] + d[c*n+p];
	plate_free(&plate);
	free(d);
	return 0;
}

int
start_from_cap(Chart finest, double *band, const Level *l)
{
	size_t n = level_nodes(l->g);
	double complex *z = malloc(n*sizeof *z);
	double *x = malloc(3*n*sizeof *x), length = border_length(l), area = integral(l->g, l->lambda2);
	double c2 = length > 0 ? 4*M_PI*area/(length*length) - 1 : 0;
	int e = z && x ? 0 : START_ENOMEM;

	(void)finest;
	(void)band;
	if (!e) {
		centred_disk(l, length, z);
		cap(n, z, length, copysign(sqrt(fmax(c2, 0)), integral(l->g, l->l2H)), x);
		e = place(l, x);
	}
	if (!e)
		e = bend(l, x);
	free(z);
	free(x);
	return e;
}
