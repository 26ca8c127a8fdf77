/* synth.h - surfaces given by a formula, with their exact lambda, H and T where known, and
 * unstructured triangulations of them.
 *
 * A surface is phi: D -> R^3, (x,y) -> phi(x,y), over a plane domain D.  Where phi is
 * conformal, |phi_x| = |phi_y| = lambda and phi_x . phi_y = 0; its unit normal is
 * n = phi_x x phi_y / |phi_x x phi_y|, its mean curvature H = <phi_xx + phi_yy, n> /
 * (2 lambda^2): the unit sphere with its outward normal has H = -1.  Patches of closed
 * surfaces have n outward.
 *
 * Lengths are in no unit; angles among the parameters are in degrees.
 */
#ifndef SYNTH_H
#define SYNTH_H

#include <stdint.h>

#include "../mesh/mesh.h"

enum {
	SYNTH_ENOMEM  = -1,
	SYNTH_EPAR    = -2,     /* the kind has no parameter of that name */
	SYNTH_ERANGE  = -3,     /* a parameter is outside its range */
	SYNTH_EDOMAIN = -4,     /* the parameters, each in range, do not fit together */
	SYNTH_EMESH   = -5      /* too few vertices for a disk */
};

enum { SYNTH_MAXPAR = 6 };

/* Shapes of D; its corners, counterclockwise, are vertices 0 1 2 3 of every mesh. */
enum {
	SYNTH_RECT,     /* the box [x0,x1] x [y0,y1]; vertex 0 is (x0,y0) */
	SYNTH_OVAL,     /* the ellipse in that box, with half axes a and b; the corners are
	                 * (a cos t, b sin t) from its centre, t = -135, -45, 45, 135 degrees */
	SYNTH_LSHAPE,   /* the box without its upper right quarter; the corners are (x0,y0),
	                 * (x1,y0), the middle of the box and (x0,y1) */
	SYNTH_SPHERE    /* no disk: a closed surface.  D is the stereographic images of the halves of a sphere, from
	                 * its poles: the disks of radius 1 round (0,0) and (SYNTH_FAR,0), z and 1/z + SYNTH_FAR */
};

#define SYNTH_FAR 3

typedef struct SynthDomain {
	int    shape;
	double x0, x1, y0, y1;
	double T;       /* height of the rectangle of width 1 onto which D maps conformally,
	                 * its corners in order to (0,0) (1,0) (1,T) (0,T); for a conformal
	                 * phi this is the modulus of the surface.  0: not known */
} SynthDomain;

typedef struct SynthPar {
	const char *name;       /* NULL ends the list */
	double      value, lo, hi;      /* default and range */
} SynthPar;

/* A kind of surface; p are the values of its parameters in their order. */
typedef struct SynthKind {
	const char *name;
	const char *text;       /* formula and domain, lines ended by \n */
	SynthPar    par[SYNTH_MAXPAR + 1];
	void      (*domain)(const double *p, SynthDomain *d);
	void      (*phi)(const double *p, double x, double y, double xyz[3]);
	double    (*lambda)(const double *p, double x, double y);       /* NULL: not conformal */
	double    (*H)(const double *p, double x, double y);            /* NULL: not known */
	double    (*scale)(const double *p, double x, double y);        /* about |phi_x|, for
	                                 * the mesh size; NULL: lambda, or else 1 */
} SynthKind;

typedef struct Synth {
	const SynthKind *kind;
	double           p[SYNTH_MAXPAR];
} Synth;

/* Kind i = 0, 1, 2 ..; NULL after the last. */
const SynthKind *synth_kind(int i);

/* Set up a kind with its defaults.  Returns 0, or -1 if there is none of that name. */
int synth_init(Synth *s, const char *name);

/* Set one parameter.  Returns 0, SYNTH_EPAR or SYNTH_ERANGE. */
int synth_set(Synth *s, const char *par, double value);

/* The domain.  Returns 0 or SYNTH_EDOMAIN. */
int synth_domain(const Synth *s, SynthDomain *d);

/* Whether (x,y) lies in D, its boundary included. */
int synth_inside(const SynthDomain *d, double x, double y);

/* A triangulated disk, or closed surface, with about n vertices (within 10 % from n = 50 on), n >= 4.  The vertices are
 * evenly spaced on the boundary of D and scattered inside it, nowhere closer than about r/scale,
 * where r is one number for the whole mesh.  The faces are the Delaunay triangulation of D,
 * counterclockwise seen from the side to which the normal points.
 *
 * seed  another seed gives other points inside, equal seeds give equal meshes
 * xy    out, if not NULL: *xy is malloc'd, the parameters of every vertex, [nv][2]
 *
 * Returns 0, SYNTH_ENOMEM, SYNTH_EDOMAIN or SYNTH_EMESH. */
int synth_mesh(const Synth *s, int n, uint64_t seed, Mesh *m, double **xy);

#endif
