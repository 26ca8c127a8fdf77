/* morph.c - the grids of lhinterp, brought into line with the first, and their blends. */
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
#include "mix.h"
#include "morph.h"
#include "positions.h"
#include "quarters.h"
#include "size.h"

static void
check_channels(const Source *a, const Source *b)
{
	const char *A = a->in.name, *B = b->in.name;
	const LhgChannel *c, *d;
	int i;

	for (i = 0; i < b->g.nchan; i++)
		if (!lhg_find(&a->g, b->g.chan[i].name))
			die("%s has a channel %s, %s has none", B, b->g.chan[i].name, A);
	for (i = 0; i < a->g.nchan; i++) {
		c = &a->g.chan[i];
		d = lhg_find(&b->g, c->name);
		if (!d)
			die("%s has a channel %s, %s has none", A, c->name, B);
		if (d->support != c->support || d->step != c->step)
			die("channel %s has another support in %s than in %s", c->name, A, B);
		if (strcmp(c->unit, d->unit) != 0)
			die("channel %s is in %s in %s, in %s in %s", c->name, c->unit, A, d->unit, B);
	}
}

static void
check_nodes(const Source *a, const Source *b)
{
	if (a->g.chart != b->g.chart)
		die("%s is on a %s, %s on a %s: mesh2rect --chart=%s", a->in.name, lhg_chartname(a->g.chart), b->in.name,
			lhg_chartname(b->g.chart), lhg_chartname(a->g.chart));
	if (a->g.nu != b->g.nu || a->g.nv != b->g.nv)
		die("%s has %d x %d nodes, %s has %d x %d", a->in.name, a->g.nu, a->g.nv, b->in.name, b->g.nu, b->g.nv);
}

/* Moves b rigidly onto the first grid, by least squares over corresponding points. */
static void
align(const Source *a, Source *b)
{
	double *w = cmd_alloc(b->match.n, sizeof *w), rms;
	Rigid r;

	matching_weights(&b->match, w);
	if (procrustes(b->match.n, w, b->match.x[0], b->match.x[1], &r, &rms))
		die("%s cannot be moved onto %s", b->in.name, a->in.name);
	positions_move(&b->g, &r);
	rigid_move(&r, b->match.n, b->match.x[1]);
	rigid_move(&r, b->border.n, b->border.x);
	detail("%s turned by %.4g degrees and moved by (%g,%g,%g): boundaries %.3g apart (rms)", b->in.name,
	    rigid_angle(&r)*180/M_PI, r.t[0], r.t[1], r.t[2], rms);
	free(w);
}

static void
match(const Source *a, Source *b, const char *landmarks)
{
	border_read(&b->in, &b->g, &b->border);
	if (landmarks)
		landfile_match(landmarks, &a->border, &b->border, &b->match);
	else if (matching_conformal(&b->match, &a->border, &b->border))
		die("no memory for the borders");
}

/* Checks that b fits the first grid; scales and moves it as the options ask. */
static void
bring_in_line(const Morph *m, Source *b)
{
	const Source *a = m->s;

	check_nodes(a, b);
	check_channels(a, b);
	if (m->has_border)
		match(a, b, m->o->landmarks);
	size_match(a, b, m->o->scale);
	if (chart_of(&a->g).kind->closed)
		closed_fit(a, b, m->o->align);
	if (!m->has_border)
		return;
	if (!m->o->landmarks && a->g.chart == LHG_RECTANGLE)
		quarters_check(&a->in, &a->border, &b->in, &b->border, m->o->align);
	if (m->o->align)
		align(a, b);
}

/* A blend of positions is not a filtered surface: places go.  With residual channels they become the start, if
 * all grids have one: a warped grid has other surfaces near its own, and a coarse start may lead to these. */
static void
take_places(Morph *m)
{
	int k, all = 1;

	for (k = 0; k < m->n; k++)
		all = all && lhg_find(&m->s[k].g, "nu1") && place_starts(&m->s[k].in, &m->s[k].g, 0);
	for (k = 0; k < m->n; k++) {
		if (all)
			place_starts(&m->s[k].in, &m->s[k].g, 1);
		place_drop(&m->s[k].g);
	}
}

void
morph_open(Morph *m, int n, char *const path[], const MorphOptions *o)
{
	int k, closed;

	*m = (Morph){ .o = o, .n = n, .s = cmd_alloc(n, sizeof *m->s) };
	memset(m->s, 0, n*sizeof *m->s);
	for (k = 0; k < n; k++) {
		cmd_open(&m->s[k].in, path[k]);
		cmd_read_one(&m->s[k].in, &m->s[k].g);
		if (k)
			check_nodes(m->s, &m->s[k]);
	}
	take_places(m);
	cmd_need(&m->s->in, &m->s->g, "lambda", LHG_GRID);
	cmd_need(&m->s->in, &m->s->g, "H", LHG_GRID);
	closed = chart_of(&m->s->g).kind->closed;
	if (closed && o->landmarks)
		die("%s: a %s has no boundary for --landmarks", m->s->in.name, lhg_chartname(m->s->g.chart));
	m->has_border = !closed && (o->landmarks || o->align || lhg_find(&m->s->g, "band.x"));
	if (m->has_border)
		border_read(&m->s->in, &m->s->g, &m->s->border);
	for (k = 1; k < n; k++)
		bring_in_line(m, &m->s[k]);
	mix_begin(m);
}

/* x = the weighted sum of the borders, [n][3], node by node. */
static void
sum_borders(const Morph *m, const double *w, double *x)
{
	const double **of = cmd_alloc(m->n, sizeof *of);
	int k;

	for (k = 0; k < m->n; k++)
		of[k] = m->s[k].border.x;
	blend(3*(size_t)m->s->border.n, m->n, w, of, x);
	free(of);
}

/* Whether the landmarks, not the nodes, say which border points of A and B correspond in a blend. */
static int
has_landmarks(const Morph *m, const double *w)
{
	return m->o->landmarks && w[1] > 0 && w[1] < 1;
}

/* Whether the blend's lambda was brought to the length of its border. */
static int
follows_border(const Morph *m, const double *w)
{
	return m->has_border && !m->o->free && m->o->rule == MORPH_METRIC && blend_single(m->n, w) < 0;
}

/* The border of the blend: by the landmarks (matching.h), or between points of equal place. */
static void
blend_border(const Morph *m, const double *w, int frame, Chart g, Border *b)
{
	const Border *a = &m->s->border;
	int k;

	if (border_init(b, g))
		die("no memory for the border of %d x %d nodes", g.nu, g.nv);
	sum_borders(m, w, b->x);
	for (k = 0; k < b->n && has_landmarks(m, w); k++)
		matching_at(&m->s[1].match, w[1], border_place(a, k), b->x + 3*k);
	if (border_measure(b) && !m->o->free)
		die("frame %d: the blend of the boundaries is a point: --align moves them onto each other first", frame);
}

/* The border of g was blended between points at the same (u,v).  Moves it to `border`, and the other positions
 * along with it (coons.h). */
static void
follow_border(const Morph *m, const double *w, const Border *border, Lhg *g)
{
	double *d = cmd_alloc(border->n, 3*sizeof *d);
	int k;

	sum_borders(m, w, d);
	for (k = 0; k < 3*border->n; k++)
		d[k] = border->x[k] - d[k];
	positions_shift(g, d);
	free(d);
}

void
morph_blend(Morph *m, const double *w, int k, int frames, Lhg *g)
{
	Border border = { .x = NULL };

	lhg_init(g, m->s->g.nu, m->s->g.nv, m->s->g.T);
	g->T = mix_height(m, w);
	g->chart = m->s->g.chart;
	if (m->has_border)
		blend_border(m, w, k, chart_of(g), &border);
	mix_channels(m, w, k, follows_border(m, w) ? &border : NULL, g);
	if (has_landmarks(m, w))
		follow_border(m, w, &border, g);
	border_free(&border);
	merge_text(m, w, g);
	if (follows_border(m, w))
		cmd_meta(g, "boundary", "held");
	g->frame = k;
	g->frames = frames;
}

void
morph_close(Morph *m)
{
	Source *s;

	mix_note(m);
	for (s = m->s; s < m->s + m->n; s++) {
		lhg_free(&s->g);
		border_free(&s->border);
		matching_free(&s->match);
		free(s->excess);
	}
	free(m->s);
	free(m->work);
}
