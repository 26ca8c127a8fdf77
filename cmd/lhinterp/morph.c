/* morph.c - interpolation between two grids and their borders. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/morph/blend.h"
#include "../shared/borderread.h"
#include "../shared/chartof.h"
#include "../shared/place.h"
#include "closed.h"
#include "landfile.h"
#include "merge.h"
#include "morph.h"
#include "positions.h"
#include "quarters.h"
#include "size.h"

static void
check_channels(const Morph *m)
{
	const char *A = m->A.name, *B = m->B.name;
	const LhgChannel *c, *d;
	int i;

	for (i = 0; i < m->b.nchan; i++)
		if (!lhg_find(&m->a, m->b.chan[i].name))
			die("%s has a channel %s, %s has none", B, m->b.chan[i].name, A);
	for (i = 0; i < m->a.nchan; i++) {
		c = &m->a.chan[i];
		d = lhg_find(&m->b, c->name);
		if (!d)
			die("%s has a channel %s, %s has none", A, c->name, B);
		if (d->support != c->support || d->step != c->step)
			die("channel %s has another support in %s than in %s", c->name, A, B);
		if (strcmp(c->unit, d->unit) != 0)
			die("channel %s is in %s in %s, in %s in %s", c->name, c->unit, A, d->unit, B);
	}
}

/* Moves B rigidly onto A, by least squares over corresponding points. */
static void
align(Morph *m)
{
	double *w = cmd_alloc(m->match.n, sizeof *w), rms;
	Rigid r;

	matching_weights(&m->match, w);
	if (procrustes(m->match.n, w, m->match.x[0], m->match.x[1], &r, &rms))
		die("%s cannot be moved onto %s", m->B.name, m->A.name);
	positions_move(&m->b, &r);
	rigid_move(&r, m->match.n, m->match.x[1]);
	rigid_move(&r, m->border[1].n, m->border[1].x);
	detail("%s turned by %.4g degrees and moved by (%g,%g,%g): boundaries %.3g apart (rms)", m->B.name,
	    rigid_angle(&r)*180/M_PI, r.t[0], r.t[1], r.t[2], rms);
	free(w);
}

static void
match(Morph *m, const char *landmarks)
{
	m->landmarks = landmarks != NULL;
	border_read(&m->A, &m->a, &m->border[0]);
	border_read(&m->B, &m->b, &m->border[1]);
	if (landmarks)
		landfile_match(landmarks, &m->border[0], &m->border[1], &m->match);
	else if (matching_conformal(&m->match, &m->border[0], &m->border[1]))
		die("no memory for the borders");
}

void
morph_open(Morph *m, const char *pathA, const char *pathB, const char *landmarks, int scaled,
	int aligned)
{
	int closed;

	memset(m, 0, sizeof *m);
	cmd_open(&m->A, pathA);
	cmd_read_one(&m->A, &m->a);
	cmd_open(&m->B, pathB);
	cmd_read_one(&m->B, &m->b);
	if (m->a.chart != m->b.chart)
		die("%s is on a %s, %s on a %s: mesh2rect --chart=%s", m->A.name, lhg_chartname(m->a.chart), m->B.name,
			lhg_chartname(m->b.chart), lhg_chartname(m->a.chart));
	if (m->a.nu != m->b.nu || m->a.nv != m->b.nv)
		die("%s has %d x %d nodes, %s has %d x %d", m->A.name, m->a.nu, m->a.nv, m->B.name, m->b.nu, m->b.nv);
	place_drop(&m->a);      /* a blend of positions is not a filtered surface */
	place_drop(&m->b);
	cmd_need(&m->A, &m->a, "lambda", LHG_GRID);
	cmd_need(&m->A, &m->a, "H", LHG_GRID);
	check_channels(m);
	closed = chart_of(&m->a).kind->closed;
	if (closed && landmarks)
		die("%s: a %s has no boundary for --landmarks", m->A.name, lhg_chartname(m->a.chart));
	m->has_border = !closed && (landmarks || aligned || lhg_find(&m->a, "band.x"));
	if (m->has_border)
		match(m, landmarks);
	size_match(m, scaled);
	if (closed)
		closed_fit(m, aligned);
	if (!m->has_border)
		return;
	if (!landmarks && m->a.chart == LHG_RECTANGLE)
		quarters_check(&m->A, &m->border[0], &m->B, &m->border[1], aligned);
	if (aligned)
		align(m);
}

/* The border of g was interpolated between the points of A and B at the same (u,v).  Moves it to the
 * border that the landmarks define (matching.h), and the other positions along with it (coons.h). */
static void
follow_landmarks(const Morph *m, double t, Lhg *g)
{
	const Border *a = &m->border[0], *b = &m->border[1];
	double *d = cmd_alloc(a->n, 3*sizeof *d);
	int k, c;

	for (k = 0; k < a->n; k++) {
		matching_at(&m->match, t, border_place(a, k), d + 3*k);
		for (c = 0; c < 3; c++)
			d[3*k+c] -= (1 - t)*a->x[3*k+c] + t*b->x[3*k+c];
	}
	positions_shift(g, d);
	free(d);
}

void
morph_at(const Morph *m, double t, int k, int n, Lhg *g)
{
	const LhgChannel *c;
	int i;

	lhg_init(g, m->a.nu, m->a.nv, m->a.T);
	g->chart = m->a.chart;
	blend(1, t, &m->a.T, &m->b.T, &g->T);
	for (i = 0; i < m->a.nchan; i++) {
		c = &m->a.chan[i];
		blend(c->n, t, c->f, lhg_find(&m->b, c->name)->f, cmd_add(g, c->name, c->unit, c->support, c->step));
	}
	if (m->landmarks && t > 0 && t < 1)
		follow_landmarks(m, t, g);
	merge_text(&m->a, &m->b, g);
	cmd_meta(g, "t", "%.10g", t);
	g->frame = k;
	g->frames = n;
}

void
morph_free(Morph *m)
{
	lhg_free(&m->a);
	lhg_free(&m->b);
	border_free(&m->border[0]);
	border_free(&m->border[1]);
	matching_free(&m->match);
}
