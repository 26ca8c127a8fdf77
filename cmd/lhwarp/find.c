/* find.c - the map of lhwarp: which quarter turn, and the map itself. */
#include <math.h>
#include <stdlib.h>

#include "../../lib/morph/warpturn.h"
#include "find.h"

static const double CLEARLY = 0.8;      /* best and second best way: the mismatch of the normals is at most
                                         * this share */
static const double LESS = M_PI/4;      /* of two ways half a turn apart, one turns B in space by so much less */
enum { TRIAL = 3 };                     /* levels to compare the ways */

/* Both surfaces on the grid of the map, B turned, and the landmarks there. */
typedef struct Laid {
	WarpSurface a, b;
	double    (*q)[2];
	WarpTask    task;
} Laid;

static void
failed(int e, const Side *b, const FindOptions *o)
{
	switch (e) {
	case 0: return;
	case WARP_ENOMEM: die("no memory for the map");
	case WARP_EMU: die("%s: no map with |mu| below %g: a larger --max-mu, or other corners: mesh2rect --like", b->in.name,
		o->mumax);
	default: die("%s cannot be moved onto the other surface", b->in.name);
	}
}

static void
lay(const Side *a, const Side *b, int turns, const Marks *marks, const FindOptions *o, Laid *l)
{
	Chart g = b->chart, h = warpturn_chart(g, turns);
	int nu = warp_nodes(a->g.nu), nv = warp_nodes(a->g.nv), i, c;
	size_t n = (size_t)g.nu*g.nv;
	double *turned = cmd_alloc(3*n, sizeof *turned);
	const double *const phi[3] = { turned, turned + n, turned + 2*n };

	for (c = 0; c < 3; c++)
		warpturn_field(g, turns, b->phi[c], turned + c*n);
	failed(warpsurface_init(&l->a, a->chart, (const double *const *)a->phi, nu, nv) ? WARP_ENOMEM : 0, b, o);
	failed(warpsurface_init(&l->b, h, phi, nu, nv) ? WARP_ENOMEM : 0, b, o);
	free(turned);
	l->task = (WarpTask){ .a = &l->a, .b = &l->b, .T = a->g.T, .stretch = h.T/a->g.T, .normals = o->normals,
	    .mumax = o->mumax };
	l->q = NULL;
	if (!marks)
		return;
	l->q = cmd_alloc(marks->n, sizeof *l->q);
	for (i = 0; i < marks->n; i++) {
		l->q[i][0] = marks->at[1][i][0];
		l->q[i][1] = marks->at[1][i][1];
		warpturn_point(g, turns, &l->q[i][0], &l->q[i][1]);
		l->q[i][1] /= l->task.stretch;
	}
	l->task.marks = (WarpMarks){ marks->n, (const double (*)[2])marks->at[0], (const double (*)[2])l->q };
}

static void
lift(Laid *l)
{
	warpsurface_free(&l->a);
	warpsurface_free(&l->b);
	free(l->q);
}

/* How badly B, so turned, fits: the distance of the landmarks as they are, or the mismatch of the normals
 * after a trial.  *angle: of the rotation in space of B onto A. */
static double
misfit(const Side *a, const Side *b, int turns, const Marks *marks, const FindOptions *o, double *angle)
{
	Laid l;
	Warp w;
	WarpFit fit;

	lay(a, b, turns, marks, o, &l);
	failed(marks ? warp_identity(&l.task, &w, &fit) : warp_find(&l.task, TRIAL, &w, &fit), b, o);
	lift(&l);
	*angle = rigid_angle(&fit.move);
	return marks ? fit.marks : fit.apart;
}

/* The way to take by the misfits and angles of all, or -1 if none is clearly better than the others.  A face
 * fits nearly as well upside down, as any oval does; but in most files heads are upright.  So if two ways half a turn
 * apart fit alike, and clearly better than the others, that is taken which turns B clearly less in space. */
static int
clear_way(const double *m, const double *angle, int best)
{
	int half = (best + 2) % WARPTURN_WAYS;
	double others = fmin(m[(best + 1) % WARPTURN_WAYS], m[(best + 3) % WARPTURN_WAYS]);

	if (m[best] <= CLEARLY*fmin(others, m[half]))
		return best;
	if (!(m[half] <= CLEARLY*others) || fabs(angle[best] - angle[half]) < LESS)
		return -1;
	return angle[best] < angle[half] ? best : half;
}

/* The best way to lay B's chart onto A's, in quarter turns. */
static int
best_way(const Side *a, const Side *b, const Marks *marks, const FindOptions *o)
{
	double m[WARPTURN_WAYS], angle[WARPTURN_WAYS];
	int k, best = 0, way;

	for (k = 0; k < WARPTURN_WAYS; k++) {
		m[k] = misfit(a, b, k, marks, o, &angle[k]);
		best = m[k] < m[best] ? k : best;
	}
	detail("%s turned by 0, 1, 2, 3 quarters: %s %.3f, %.3f, %.3f, %.3f", b->in.name,
	    marks ? "landmarks apart" : "normals differ by", m[0], m[1], m[2], m[3]);
	if (marks)
		return best;
	if ((way = clear_way(m, angle, best)) >= 0) {
		if (m[way] > CLEARLY*m[(way + 2) % WARPTURN_WAYS])
			note("%s fits %s nearly as well after half a turn (%.2f, %.2f): the way that turns it less in space is "
			    "taken, by %.0f degrees, not %.0f", b->in.name, a->in.name, m[way], m[(way + 2) % WARPTURN_WAYS],
			    angle[way]*180/M_PI, angle[(way + 2) % WARPTURN_WAYS]*180/M_PI);
		return way;
	}
	if (!o->force)
		die("%s fits %s in no way clearly better than in another (quarter turns 0 to 3: %.2f %.2f %.2f %.2f): "
		    "--landmarks; or a morph without a warp, lhinterp --scale --align --cap; or --force", b->in.name, a->in.name,
		    m[0], m[1], m[2], m[3]);
	note("%s fits %s in no way clearly better than in another (quarter turns 0 to 3: %.2f %.2f %.2f %.2f)", b->in.name,
	    a->in.name, m[0], m[1], m[2], m[3]);
	return best;
}

/* Between rectangles of heights T and s T some |mu| is at least |s-1|/(s+1), by Groetzsch's theorem. */
static void
check_heights(const Side *a, const Side *b, double stretch, double mumax)
{
	double least = fabs(stretch - 1)/(stretch + 1);

	if (least >= mumax)
		die("%s: its chart is %.4g high, that of %s %.4g, so any map has |mu| of at least %.2g: a larger --max-mu, or "
		    "other corners: mesh2rect --like", b->in.name, stretch*a->g.T, a->in.name, a->g.T, least);
}

void
find_map(const Side *a, const Side *b, const Marks *marks, const FindOptions *o, Found *f)
{
	Laid l;

	cmd_progress("four quarter turns");
	f->turns = best_way(a, b, marks, o);
	if (f->turns)
		note("%s is turned by %d quarter%s to fit", b->in.name, f->turns, f->turns == 1 ? "" : "s");
	cmd_progress("map");
	lay(a, b, f->turns, marks, o, &l);
	f->stretch = l.task.stretch;
	check_heights(a, b, f->stretch, o->mumax);
	failed(warp_identity(&l.task, &f->warp, &f->before), b, o);
	failed(warp_find(&l.task, WARP_LEVELS, &f->warp, &f->after), b, o);
	lift(&l);
	cmd_progress_end();
}
