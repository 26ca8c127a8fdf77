/* chart.h - the parameter domain [0,1] x [0,T], its nodes, and what lies beyond its sides.
 *
 * Symbols used in lib/ without further comment (doc/mathematics.md 1):
 *
 *   phi      position in R^3 at node (i,j): arrays phi[0], phi[1], phi[2] = x, y, z
 *   h, k     grid steps along u and v; on the rectangle h = 1/(nu-1), k = T/(nv-1)   (23);
 *            on the sock h = 1/nu, k = T/(nv-1/2); on the pillow h = 1/nu, k = T/nv
 *   lambda   conformal factor > 0: |phi_u| = |phi_v| = lambda, <phi_u, phi_v> = 0
 *   n        unit normal, phi_u x phi_v / |phi_u x phi_v|
 *   H        mean curvature, <Delta phi, n> / (2 lambda^2); -1 on the unit sphere whose
 *            normal points out
 *   p        node number j*nu + i, u fastest
 *
 * phi and lambda have the unit of length of the mesh, H one over it; u, v, T have none.
 */
#ifndef CHART_H
#define CHART_H

typedef struct Chart Chart;

/* There is one constant for each kind of chart.  A side of the domain is open or joined.  An open
 * side has nodes on it and nothing beyond it.  A joined side is glued to another side, and the last
 * nodes lie half a step inside it. */
typedef struct ChartKind {
	const char *name;       /* as in .lhg files and options */
	int joined[2][2];       /* 1: joined.  [0]: sides u = 0, u = 1; [1]: v = 0, v = T */

	/* Replaces (*i,*j), a place a few steps beyond joined sides, by the node of the grid
	 * that is glued to it.  Returns 1, or -1 if the directions of u and v are both reversed
	 * there, so that odd fields such as phi_u change their sign.  NULL if no side is joined. */
	int (*beyond)(Chart g, int *i, int *j);

	/* The number of cells, the quadrilaterals that make a surface of the nodes: those of a row
	 * side by side, row after row, then those across a fold.  And the nodes of cell number n,
	 * anticlockwise in (u,v).  NULL for a chart of which no surface is made. */
	int  (*cells)(Chart g);
	void (*cell)(Chart g, int n, int corner[4]);

	double lowest, highest; /* heights T within which `round` neither overflows nor vanishes */

	/* The conformal factor of a round surface on the chart, [nv][nu].  lambda goes to 0 at a cone
	 * as it does; lambda over it does not.  NULL: 1 everywhere. */
	void (*round)(Chart g, double *lambda0);

	int    folded;          /* how many sides, v = 0 and then v = T, are glued to themselves, (u,0) to (1-u,0) */
	int    closed;          /* 1: no side is open */
	int    cones;           /* cone points of angle pi, at u = cone[0][0], v = T cone[0][1], .. */
	double cone[4][2];
} ChartKind;

struct Chart {
	int    nu, nv;          /* nodes along u and v */
	double T;               /* height, > 0 */
	const ChartKind *kind;
};

/* The rectangle: all four sides are open.
 *
 * The sock: periodic in u, open at v = T, and folded at v = 0, where (u,-v) and (1-u,v) are the same
 * point.  So the only boundary is v = T, and (0,0) and (1/2,0) are cone points of angle pi, between
 * nodes.  nu is even, since i and nu-1-i are neighbours across the fold.
 *
 * The pillow: periodic in u, folded at v = 0 and at v = T, where (u,T+v) and (1-u,T-v) are the same
 * point.  There is no boundary, and the cone points are (0,0), (1/2,0), (0,T), (1/2,T).  The sock of height
 * T/2 is half of it.  nu is even. */
extern const ChartKind CHART_RECTANGLE, CHART_SOCK, CHART_PILLOW;

/* The kind of that name, or NULL. */
const ChartKind *chart_kind(const char *name);

/* Sets lambda0[nv][nu] to the conformal factor of the round surface of ChartKind.round, or to 1. */
void chart_round(Chart g, double *lambda0);

/* The distance, in units of u, of the node p from cone number c. */
double chart_from_cone(Chart g, int c, int p);

/* The number of grid steps across the domain along u (axis 0) or v (axis 1). */
static inline double
chart_steps(Chart g, int axis)
{
	const int *joined = g.kind->joined[axis];

	return (axis ? g.nv : g.nu) - 1 + (joined[0] + joined[1])*0.5;
}

static inline double
chart_h(Chart g)
{
	return 1.0/chart_steps(g, 0);
}

static inline double
chart_k(Chart g)
{
	return g.T/chart_steps(g, 1);
}

/* The coordinate u of column i, and v of row j. */
static inline double
chart_u(Chart g, int i)
{
	return (i + 0.5*g.kind->joined[0][0])*chart_h(g);
}

static inline double
chart_v(Chart g, int j)
{
	return (j + 0.5*g.kind->joined[1][0])*chart_k(g);
}

#endif
