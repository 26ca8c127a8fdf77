/* disks.c - random disks: plane domains are triangulated, then given heights or bent in space. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../lib/mesh/disk.h"
#include "../lib/mesh/topology.h"
#include "../lib/synth/delaunay.h"
#include "../lib/synth/rng.h"
#include "disks.h"

enum { ROOM = 8000 };           /* the most vertices of a mesh */

/* A mesh under construction. */
typedef struct Made {
	uint64_t rng;
	int      nv, nf;
	double   p[ROOM][2], xyz[ROOM][3];
	int      tri[2*ROOM][3];
	char    *tag;
} Made;

static double
between(Made *m, double low, double high)
{
	return low + (high - low)*rng_unit(&m->rng);
}

static int
below(Made *m, int n)
{
	return (int)(rng_unit(&m->rng)*n);
}

static double
normal(Made *m)
{
	double r = sqrt(-2*log(1 - rng_unit(&m->rng)));

	return r*cos(2*M_PI*rng_unit(&m->rng));
}

static double
power(Made *m, double low, double high)
{
	return pow(10, between(m, low, high));
}

static void
name(Made *m, const char *tag)
{
	size_t n = strlen(m->tag);

	snprintf(m->tag + n, DISKS_TAG - n, "%s%s", n > 0 ? "/" : "", tag);
}

static void
add(Made *m, double x, double y)
{
	if (m->nv < ROOM) {
		m->p[m->nv][0] = x;
		m->p[m->nv++][1] = y;
	}
}

static int
inside(int n, double poly[][2], double x, double y)
{
	int i, j, in = 0;

	for (i = 0, j = n - 1; i < n; j = i++)
		if ((poly[i][1] > y) != (poly[j][1] > y)
		    && x < poly[i][0] + (y - poly[i][1])*(poly[j][0] - poly[i][0])/(poly[j][1] - poly[i][1]))
			in = !in;
	return in;
}

static double
area(const Made *m, const int *c)
{
	const double *a = m->p[c[0]], *b = m->p[c[1]], *e = m->p[c[2]];

	return (b[0] - a[0])*(e[1] - a[1]) - (b[1] - a[1])*(e[0] - a[0]);
}

/* Whether the triangles marked `in` remain a disk when triangle f is added: f shares two sides with
 * them, or it shares one side and the corner opposite this side is not among their vertices, which
 * are marked `used`. */
static int
extends(const Made *m, const Topology *t, const unsigned char *in, const unsigned char *used, int f)
{
	int k, shared = 0, opposite = 0;

	for (k = 0; k < 3; k++) {
		int twin = t->twin[3*f+k];

		if (twin >= 0 && in[twin/3]) {
			shared++;
			opposite = m->tri[f][(k+2)%3];
		}
	}
	return shared == 2 || (shared == 1 && !used[opposite]);
}

/* Keeps only triangles that form a disk, which is grown from the largest triangle. */
static int
keep_disk(Made *m)
{
	static unsigned char in[2*ROOM], used[ROOM];
	static int stack[20*ROOM];
	char err[MESH_ERRLEN];
	Topology t = { .nv = m->nv, .nf = m->nf, .tri = m->tri[0], .err = err };
	int f, k, n = 1, largest = 0;

	if (m->nf == 0 || topology_twins(&t))
		return -1;
	memset(in, 0, sizeof in);
	memset(used, 0, sizeof used);
	for (f = 1; f < m->nf; f++)
		if (area(m, m->tri[f]) > area(m, m->tri[largest]))
			largest = f;
	stack[0] = largest;
	while (n > 0) {
		f = stack[--n];
		if (in[f] || (f != largest && !extends(m, &t, in, used, f)))
			continue;
		in[f] = 1;
		for (k = 0; k < 3; k++) {
			used[m->tri[f][k]] = 1;
			if (t.twin[3*f+k] >= 0)
				stack[n++] = t.twin[3*f+k]/3;
		}
	}
	free(t.twin);
	for (n = f = 0; f < m->nf; f++)
		if (in[f])
			memmove(m->tri[n++], m->tri[f], sizeof m->tri[0]);
	m->nf = n;
	return 0;
}

/* Scales the points by sx and sy and makes their Delaunay triangulation; the points themselves do not
 * change.  If n > 0, keeps only triangles whose centroid is inside the polygon poly of n corners. */
static int
triangulate(Made *m, double sx, double sy, int n, double poly[][2])
{
	static double xy[ROOM][2];
	int i, f, nf = 0;

	for (i = 0; i < m->nv; i++)
		xy[i][0] = sx*m->p[i][0], xy[i][1] = sy*m->p[i][1];
	if (delaunay(m->nv, xy[0], m->tri[0], &m->nf))
		return -1;
	for (f = 0; f < m->nf; f++) {
		const int *c = m->tri[f];
		double x = (m->p[c[0]][0] + m->p[c[1]][0] + m->p[c[2]][0])/3;
		double y = (m->p[c[0]][1] + m->p[c[1]][1] + m->p[c[2]][1])/3;

		if ((n == 0 || inside(n, poly, x, y)) && area(m, c) > 1e-14)
			memmove(m->tri[nf++], c, sizeof m->tri[0]);
	}
	m->nf = nf;
	return keep_disk(m);
}

/* Triangulates a polygon of k corners, with points on its sides and n random points inside. */
static int
fill(Made *m, int n, int k, double poly[][2])
{
	double lo[2] = { HUGE_VAL, HUGE_VAL }, hi[2] = { -HUGE_VAL, -HUGE_VAL }, length = 0, h;
	int i, j, c, tries;

	for (i = 0; i < k; i++) {
		for (c = 0; c < 2; c++) {
			lo[c] = fmin(lo[c], poly[i][c]);
			hi[c] = fmax(hi[c], poly[i][c]);
		}
		length += hypot(poly[(i+1)%k][0] - poly[i][0], poly[(i+1)%k][1] - poly[i][1]);
	}
	h = fmax(sqrt((hi[0] - lo[0])*(hi[1] - lo[1])/n), length/1000);
	for (i = 0; i < k; i++) {
		double x = poly[(i+1)%k][0] - poly[i][0], y = poly[(i+1)%k][1] - poly[i][1];
		int parts = (int)fmax(1, hypot(x, y)/h);

		for (j = 0; j < parts; j++)
			add(m, poly[i][0] + x*j/parts, poly[i][1] + y*j/parts);
	}
	for (i = tries = 0; i < n && tries < 4*n; tries++) {
		double x = between(m, lo[0], hi[0]), y = between(m, lo[1], hi[1]);

		if (inside(k, poly, x, y))
			add(m, x, y), i++;
	}
	return triangulate(m, 1, 1, k, poly);
}

static int
square(Made *m, int n)
{
	return fill(m, n, 4, (double[4][2]){ { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 1 } });
}

static int
round_polygon(Made *m, int n, double inner)
{
	double poly[40][2];
	int k = 3 + below(m, 37), i;

	for (i = 0; i < k; i++) {
		double a = (i + between(m, -.3, .3))*2*M_PI/k, r = between(m, inner, 1);

		poly[i][0] = r*cos(a), poly[i][1] = r*sin(a);
	}
	return fill(m, n, k, poly);
}

static int
polygon(Made *m, int n)
{
	return round_polygon(m, n, 1);
}

static int
star(Made *m, int n)
{
	return round_polygon(m, n, .15);
}

static int
comb(Made *m, int n)
{
	double poly[22][2];
	int k = 2 + below(m, 4), i, at = 0;

#define CORNER(x, y) (poly[at][0] = (x)/5.0, poly[at++][1] = (y)/5.0)
	CORNER(0, 0);
	CORNER(2*k, 0);
	for (i = k - 1; i >= 0; i--) {
		CORNER(2*i + 2, 5);
		CORNER(2*i + 1, 5);
		CORNER(2*i + 1, 1);
		CORNER(2*i, 1);
	}
#undef CORNER
	return fill(m, n, at, poly);
}

/* A rectangle of width `aspect` and height 1, with points on its boundary and n random points
 * inside. */
static int
rectangle(Made *m, int n, double aspect)
{
	int along = (int)fmin(fmax(2, sqrt(n*aspect)), 1000), up = (int)fmax(2, sqrt(n/aspect)), i;
	int scaled = rng_unit(&m->rng) < .5;

	for (i = 0; i < along; i++) {
		add(m, aspect*i/(along - 1), 0);
		add(m, aspect*i/(along - 1), 1);
	}
	for (i = 1; i < up; i++) {
		add(m, 0, i/(double)up);
		add(m, aspect, i/(double)up);
	}
	for (i = 0; i < n; i++)
		add(m, aspect*between(m, 1e-9, 1), between(m, 1e-9, 1));
	return scaled ? triangulate(m, along/aspect, up, 0, NULL) : triangulate(m, 1, 1, 0, NULL);
}

static int
strip(Made *m, int n)
{
	return rectangle(m, n, power(m, 1, 3));
}

static int
spiral(Made *m, int n)
{
	return rectangle(m, n, power(m, .7, 1.6));
}

/* A lattice of squares.  The four corners of a square lie on a circle, so the Delaunay triangulation
 * is not unique.  Half of the lattices have random points inside as well. */
static int
grid(Made *m, int n)
{
	int k = (int)fmax(2, sqrt(n)), i, more = below(m, 2)*n;

	for (i = 0; i < (k + 1)*(k + 1); i++)
		add(m, i%(k + 1)/(double)k, i/(k + 1)/(double)k);
	for (i = 0; i < more; i++)
		add(m, between(m, 1e-9, 1), between(m, 1e-9, 1));
	return triangulate(m, 1, 1, 0, NULL);
}

/* Triangles round a central vertex, at equal or random angles. */
static int
fan(Made *m, int n)
{
	static const int size[4] = { 5, 20, 100, 500 };
	double angle[500];
	int k = size[below(m, 4)], i, even = below(m, 2), ragged = below(m, 2), open = below(m, 3) == 0;

	(void)n;
	for (i = 0; i < k; i++)
		angle[i] = 2*M_PI*(i + (even ? 0 : .9*rng_unit(&m->rng)))/k;
	add(m, 0, 0);
	for (i = 0; i < k; i++) {
		double r = ragged ? between(m, .3, 1) : 1;

		add(m, r*cos(angle[i]), r*sin(angle[i]));
	}
	for (i = 0; i < k - open; i++)
		memcpy(m->tri[m->nf++], (int[]){ 0, 1 + i, 1 + (i + 1)%k }, sizeof m->tri[0]);
	return 0;
}

/* Inserts points inside triangles: anywhere, very close to a corner, or very close to a side. */
static void
insert(Made *m)
{
	static const char *const tag[3] = { "inserted", "doubled", "needles" };
	int kind = below(m, 3), n = 1 + below(m, 30);

	name(m, tag[kind]);
	for (; n > 0 && m->nv < ROOM; n--) {
		int f = below(m, m->nf), c[3], v = m->nv;
		double e = power(m, -12, -2), s = sqrt(rng_unit(&m->rng)), w[3] = { .5 - e/2, .5 - e/2, e };
		const double *x[3] = { m->p[m->tri[f][0]], m->p[m->tri[f][1]], m->p[m->tri[f][2]] };

		if (kind == 0)
			w[0] = 1 - s, w[2] = s*rng_unit(&m->rng), w[1] = s - w[2];
		else if (kind == 1)
			w[0] = 1 - 2*e, w[1] = w[2] = e;
		memcpy(c, m->tri[f], sizeof c);
		add(m, w[0]*x[0][0] + w[1]*x[1][0] + w[2]*x[2][0], w[0]*x[0][1] + w[1]*x[1][1] + w[2]*x[2][1]);
		m->tri[f][2] = v;
		memcpy(m->tri[m->nf++], (int[]){ c[1], c[2], v }, sizeof c);
		memcpy(m->tri[m->nf++], (int[]){ c[2], c[0], v }, sizeof c);
	}
}

/* The height of point i, in units of the size of the disk.  (x,y) is its place, from -1/2 to 1/2; a
 * holds 16 random numbers, the same for all points. */
typedef double Height(Made *m, int i, double x, double y, const double *a);

static double
flat(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, (void)x, (void)y, (void)a, 0;
}

static double
bumps(Made *m, int i, double x, double y, const double *a)
{
	double z = 0, w;
	int k;

	(void)m, (void)i;
	for (k = 0; k < 4; k++) {
		w = pow(10, -1.5*a[4*k]);
		z += (a[4*k+1] - .5)*exp(-(pow(x - a[4*k+2] + .5, 2) + pow(y - a[4*k+3] + .5, 2))/(w*w));
	}
	return z;
}

static double
fold(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, (void)y, 3*a[0]*fabs(x);
}

static double
roughness(Made *m, int i, double x, double y, const double *a)
{
	return (void)i, (void)x, (void)y, normal(m)*pow(10, -6*a[0]);
}

static double
spike(Made *m, int i, double x, double y, const double *a)
{
	return (void)x, (void)y, i == (int)(a[0]*m->nv) ? pow(10, 3*a[1])*(a[2] < .5 ? 1 : -1) : 0;
}

static double
cusp(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, (void)y, sqrt(fabs(x) + 1e-30)*(6*a[0] - 3);
}

static double
bowl(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, (x*x + y*y)*(10*a[0] - 5);
}

static double
stair(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, (void)y, x > 0 ? 3*a[0] : 0;
}

static double
waves(Made *m, int i, double x, double y, const double *a)
{
	double z = 0;
	int k;

	(void)m, (void)i;
	for (k = 0; k < 5; k++)
		z += .1*sin(20*((2*a[3*k] - 1)*x + (2*a[3*k+1] - 1)*y) + 6*a[3*k+2]);
	return z;
}

static double
cone(Made *m, int i, double x, double y, const double *a)
{
	return (void)m, (void)i, -hypot(x, y)*(.5 + 20*a[0]);
}

static const struct { const char *name; Height *at; } HEIGHTS[] = {
	{ "flat", flat }, { "bumps", bumps }, { "bumps", bumps }, { "fold", fold }, { "noise", roughness },
	{ "spike", spike },
	{ "cusp", cusp }, { "bowl", bowl }, { "stair", stair }, { "waves", waves }, { "cone", cone }
};

static void
raise(Made *m, int k)
{
	double lo[2] = { HUGE_VAL, HUGE_VAL }, hi[2] = { -HUGE_VAL, -HUGE_VAL }, size, a[16];
	int i, c;

	for (i = 0; i < 16; i++)
		a[i] = rng_unit(&m->rng);
	for (i = 0; i < m->nv; i++)
		for (c = 0; c < 2; c++) {
			lo[c] = fmin(lo[c], m->p[i][c]);
			hi[c] = fmax(hi[c], m->p[i][c]);
		}
	size = fmax(hi[0] - lo[0], hi[1] - lo[1]);
	for (i = 0; i < m->nv; i++) {
		double x = (m->p[i][0] - (lo[0] + hi[0])/2)/size, y = (m->p[i][1] - (lo[1] + hi[1])/2)/size;

		m->xyz[i][0] = m->p[i][0], m->xyz[i][1] = m->p[i][1];
		m->xyz[i][2] = size*HEIGHTS[k].at(m, i, x, y, a);
	}
	name(m, HEIGHTS[k].name);
}

/* Bends a strip to a spiral in the plane, or rolls it up in space. */
static void
wind(Made *m)
{
	double turns = between(m, .5, 6), w = between(m, .05, .9), longest = 0;
	int i, rolled = below(m, 2);

	for (i = 0; i < m->nv; i++)
		longest = fmax(longest, m->p[i][0]);
	for (i = 0; i < m->nv; i++) {
		double s = turns*m->p[i][0]/longest, t = 2*M_PI*s, r = 1 + s + (rolled ? 0 : w*m->p[i][1]);

		m->xyz[i][0] = r*cos(t), m->xyz[i][1] = r*sin(t);
		m->xyz[i][2] = rolled ? w*m->p[i][1] : .1*m->xyz[i][2]/longest;
	}
	name(m, rolled ? "rolled" : "wound");
}

/* Rotates the mesh, and at random also scales it, translates it or reverses its orientation. */
static void
move(Made *m)
{
	double q[4], n, x[3], scale = 1, offset[3] = { 0, 0, 0 };
	int i, c, turn;

	for (n = c = 0; c < 4; c++)
		q[c] = normal(m), n += q[c]*q[c];
	if (rng_unit(&m->rng) < .4)
		scale = power(m, -6, 6), name(m, "scaled");
	if (rng_unit(&m->rng) < .25) {
		double far = (below(m, 2) ? 1e6 : 1e3)*fmin(scale, 1);

		for (c = 0; c < 3; c++)
			offset[c] = far*normal(m);
		name(m, "far");
	}
	for (i = 0; i < m->nv; i++) {
		memcpy(x, m->xyz[i], sizeof x);
		for (c = 0; c < 3; c++) {
			int d = (c + 1)%3, e = (c + 2)%3;

			m->xyz[i][c] = offset[c] + scale/n*((q[3]*q[3] + q[c]*q[c] - q[d]*q[d] - q[e]*q[e])*x[c]
			    + 2*(q[c]*q[d] - q[3]*q[e])*x[d] + 2*(q[c]*q[e] + q[3]*q[d])*x[e]);
		}
	}
	turn = rng_unit(&m->rng) < .15;
	for (i = 0; turn && i < m->nf; i++) {
		c = m->tri[i][1], m->tri[i][1] = m->tri[i][2], m->tri[i][2] = c;
	}
}

int
disks_of(int nv, const double *xyz, int nf, const int *tri, Disk *d)
{
	Soup s = { .nv = nv, .nf = nf, .xyz = (double *)xyz, .idx = (int *)tri,
		.first = malloc((nf + 1)*sizeof *s.first) };
	int i, e;

	if (!s.first)
		return MESH_ENOMEM;
	for (i = 0; i <= nf; i++)
		s.first[i] = 3*i;
	e = disk_from_soup(d, &s);
	free(s.first);
	return e;
}

static void
shuffle(uint64_t *seed, int n, int *order)
{
	int i, k, s;

	for (i = 0; i < n; i++)
		order[i] = i;
	for (i = n - 1; i > 0; i--) {
		k = (int)(rng_unit(seed)*(i + 1));
		s = order[i], order[i] = order[k], order[k] = s;
	}
}

int
disks_renumbered(const Disk *d, uint64_t seed, Disk *other, int *number)
{
	double *xyz = malloc(3*d->m.nv*sizeof *xyz);
	int *tri = malloc(3*d->m.nf*sizeof *tri), i, e;

	shuffle(&seed, d->m.nv, number);
	for (i = 0; i < d->m.nv; i++)
		memcpy(&xyz[3*number[i]], &d->m.xyz[3*i], 3*sizeof *xyz);
	for (i = 0; i < 3*d->m.nf; i++)
		tri[i] = number[d->m.tri[i]];
	e = disks_of(d->m.nv, xyz, d->m.nf, tri, other);
	free(xyz);
	free(tri);
	return e;
}

int
disks_reordered(const Disk *d, uint64_t seed, Disk *other)
{
	int *tri = malloc(3*d->m.nf*sizeof *tri), *order = malloc(d->m.nf*sizeof *order), f, k, first, e;

	shuffle(&seed, d->m.nf, order);
	for (f = 0; f < d->m.nf; f++) {
		first = (int)(3*rng_unit(&seed));
		for (k = 0; k < 3; k++)
			tri[3*order[f]+k] = d->m.tri[3*f+(first+k)%3];
	}
	e = disks_of(d->m.nv, d->m.xyz, d->m.nf, tri, other);
	free(tri);
	free(order);
	return e;
}

int
disks_is_disk(const Disk *d)
{
	char err[MESH_ERRLEN];
	Topology t = { .nv = d->m.nv, .nf = d->m.nf, .tri = d->m.tri, .err = err };
	int *loop = NULL, nb = 0, i, shift = 0, same;

	if (topology_twins(&t))
		return 0;
	same = !t.odd && memcmp(t.twin, d->twin, 3*d->m.nf*sizeof *d->twin) == 0
	    && !topology_connected(&t) && !topology_fans(&t) && !topology_loop(&t, &loop, &nb) && nb == d->nb;
	for (i = 0; same && i < nb; i++)
		if (loop[i] == d->loop[0])
			shift = i;
	for (i = 0; same && i < nb; i++)
		same = loop[(i + shift)%nb] == d->loop[i];
	free(loop);
	free(t.twin);
	return same;
}

int
disks_turned(const Disk *d, const double *u, const double *v, int *thin)
{
	int f, n = 0;

	*thin = 0;
	for (f = 0; f < d->m.nf; f++) {
		const int *t = &d->m.tri[3*f];
		long double a = u[t[0]], b = v[t[0]];
		long double x = (u[t[1]] - a)*(v[t[2]] - b), y = (u[t[2]] - a)*(v[t[1]] - b);

		n += x < y;
		*thin += x >= y && x - y <= 8*(DBL_EPSILON/2)*(fabsl(x) + fabsl(y));
	}
	return n;
}

typedef int Shape(Made *m, int n);
static const struct { const char *name; Shape *make; } SHAPES[] = {
	{ "square", square }, { "polygon", polygon }, { "star", star }, { "star", star },
	{ "strip", strip }, { "spiral", spiral },
	{ "fan", fan }, { "grid", grid }, { "comb", comb }
};

int
disks_random(uint64_t seed, int kind, Disk *d, char tag[DISKS_TAG])
{
	static Made m;
	int n, k;

	m.rng = seed*0x9e3779b97f4a7c15u + 1;
	m.nv = m.nf = 0;
	m.tag = tag;
	tag[0] = '\0';
	k = below(&m, sizeof SHAPES/sizeof *SHAPES);
	n = (int)power(&m, .6, 3);
	name(&m, SHAPES[k].name);
	if (SHAPES[k].make(&m, n < 4 ? 4 : n))
		return -1;
	if (kind == DISKS_ANY && rng_unit(&m.rng) < .3)
		insert(&m);
	raise(&m, kind == DISKS_FLAT ? 0 : below(&m, sizeof HEIGHTS/sizeof *HEIGHTS));
	if (SHAPES[k].make == spiral && kind != DISKS_FLAT)
		wind(&m);
	if (kind == DISKS_ANY)
		move(&m);
	if (disks_of(m.nv, m.xyz[0], m.nf, m.tri[0], d))
		return -1;
	if (d->nb < 4) {
		disk_free(d);
		return -1;
	}
	return 0;
}
