/* mix.c - the channels of a blend: lambda, H and residual channels by the rule, others linearly. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/field.h"
#include "../../lib/morph/blend.h"
#include "../../lib/morph/blendmetric.h"
#include "../../lib/morph/borderlength.h"
#include "../../lib/morph/cap.h"
#include "../shared/chartof.h"
#include "../shared/range.h"
#include "mix.h"

static const char *const BY_RULE[] = { "lambda", "H", "nu1", "nu2", "tau1", "tau2" };
enum { FIELDS = sizeof BY_RULE/sizeof *BY_RULE };

static const double LEAST = 1e-60, MOST = 1e60;        /* of lambda, as range.h has it */

static const double FAR = 1;    /* excess beyond the grids' that is noted; jumps were seen from 1.3 on, none
                                 * below 0.8.  A round sphere with H = 0 has 4 pi */

static int
is_by_rule(const char *name)
{
	int i;

	for (i = 0; i < FIELDS; i++)
		if (strcmp(name, BY_RULE[i]) == 0)
			return 1;
	return 0;
}

static Metric
metric_of(const Morph *m, const Lhg *g)
{
	Metric f = { .g = chart_of(g), .lambda = lhg_find(g, "lambda")->f, .H = lhg_find(g, "H")->f };
	int c;

	for (c = 0; c < 2 && m->residual; c++) {
		f.nu[c] = lhg_find(g, BY_RULE[2+c])->f;
		f.tau[c] = lhg_find(g, BY_RULE[4+c])->f;
	}
	return f;
}

static void
excess_of(const Lhg *g, double *x)
{
	if (cap_excess(chart_of(g), lhg_find(g, "lambda")->f, lhg_find(g, "H")->f, x))
		die("no memory for the excess of %d x %d nodes", g->nu, g->nv);
}

static void
check_ranges(const Source *s)
{
	int i;

	range_height(&s->in, &s->g);
	range_lambda_h(&s->in, &s->g, lhg_find(&s->g, "lambda")->f, lhg_find(&s->g, "H")->f);
	for (i = 2; i < FIELDS; i++)
		range_channel(&s->in, &s->g, BY_RULE[i]);
}

/* Whether the excess is computed: it is one of lambda and H of a conformal grid. */
static int
watches(const Morph *m)
{
	return !m->residual && (m->o->cap || m->o->rule == MORPH_METRIC);
}

void
mix_begin(Morph *m)
{
	Source *s;
	int i;

	m->residual = 0;
	for (i = 2; i < FIELDS; i++)
		m->residual |= lhg_find(&m->s->g, BY_RULE[i]) != NULL;
	for (i = 2; i < FIELDS && m->residual && m->o->rule != MORPH_LINEAR; i++)
		cmd_need(&m->s->in, &m->s->g, BY_RULE[i], LHG_GRID);
	if (m->o->cap && m->residual)
		die("%s has residual channels, --cap is for grids without: grid2lh without --residual", m->s->in.name);
	for (s = m->s; s < m->s + m->n && (m->o->cap || m->o->rule != MORPH_LINEAR); s++)
		check_ranges(s);
	if (!watches(m))
		return;
	m->work = cmd_alloc(2*(size_t)m->s->g.nu*m->s->g.nv, sizeof *m->work);
	for (s = m->s; s < m->s + m->n; s++) {
		s->excess = cmd_alloc((size_t)s->g.nu*s->g.nv, sizeof *s->excess);
		excess_of(&s->g, s->excess);
	}
}

/* The channel `name` of all grids, summed with the weights. */
static void
sum_channel(const Morph *m, const double *w, const LhgChannel *c, double *f)
{
	const double **of = cmd_alloc(m->n, sizeof *of);
	int k;

	for (k = 0; k < m->n; k++)
		of[k] = lhg_find(&m->s[k].g, c->name)->f;
	blend(c->n, m->n, w, of, f);
	free(of);
}

/* What log lambda gains by the length of the border of the blend. */
static void
border_change(const Morph *m, const double *w, const Border *border, double *e)
{
	const Border **of = cmd_alloc(m->n, sizeof *of);
	int k;

	for (k = 0; k < m->n; k++)
		of[k] = &m->s[k].border;
	if (borderlength(m->n, w, of, border, e))
		die("no memory for the borders of %d x %d nodes", border->g.nu, border->g.nv);
	free(of);
}

static void
mix_metric(const Morph *m, const double *w, const Border *border, Lhg *g)
{
	Metric *of = cmd_alloc(m->n, sizeof *of), to = metric_of(m, g);
	double *e = border ? cmd_alloc((size_t)g->nu*g->nv, sizeof *e) : NULL;
	int k;

	if (e)
		border_change(m, w, border, e);

	for (k = 0; k < m->n; k++)
		of[k] = metric_of(m, &m->s[k].g);
	blendmetric(m->n, w, of, e, &to);
	free(e);
	free(of);
}

/* Sets f to the excess that the weights give the grids, without those below 0. */
static void
blend_excess(const Morph *m, const double *w, size_t n, double *f)
{
	int k;

	memset(f, 0, n*sizeof *f);
	for (k = 0; k < m->n; k++)
		if (w[k] > 0)
			field_add(n, w[k], m->s[k].excess, f);
}

/* Compares the excess of g, frame k, with those of the grids; with --cap lowers lambda. */
static void
watch(Morph *m, const double *w, int k, Lhg *g)
{
	size_t n = (size_t)g->nu*g->nv, p;
	double *x = m->work, *allowed = x + n, beyond;

	excess_of(g, x);
	blend_excess(m, w, n, allowed);
	for (p = 0; p < n; p++)
		x[p] = fmax(0, x[p] - allowed[p]);
	beyond = cap_integral(chart_of(g), x);
	if (beyond > m->most) {
		m->most = beyond;
		m->worst = k;
	}
	detail("frame %d: integral of (K - H^2)+ %.3g beyond that of the grids, %.3g", k, beyond,
	    cap_integral(chart_of(g), allowed));
	if (m->o->cap && cap_lower(chart_of(g), x, lhg_find(g, "lambda")->f, lhg_find(g, "H")->f))
		die("no memory for the cap of %d x %d nodes", g->nu, g->nv);
}

/* Weights below 0 lead outside the grids, where lambda need not be positive, or its square a number. */
static void
check_blend(const Lhg *g)
{
	const LhgChannel *lambda = lhg_find(g, "lambda");
	size_t p;

	for (p = 0; p < lambda->n; p++)
		if (!(lambda->f[p] >= LEAST && lambda->f[p] <= MOST))
			die("the weights give lambda %g at node (%zu,%zu), not in %g .. %g: those below 0 have to be nearer to 0",
			    lambda->f[p], p%g->nu, p/g->nu, LEAST, MOST);
}

double
mix_height(const Morph *m, const double *w)
{
	const double **of = cmd_alloc(m->n, sizeof *of);
	double T;
	int k;

	for (k = 0; k < m->n; k++)
		of[k] = &m->s[k].g.T;
	blend(1, m->n, w, of, &T);
	free(of);
	if (!(T > 0))
		die("the weights give a height T of %g, must be positive: those below 0 have to be nearer to 0", T);
	return T;
}

void
mix_channels(Morph *m, const double *w, int k, const Border *border, Lhg *g)
{
	const LhgChannel *c;
	double *f;

	for (c = m->s->g.chan; c < m->s->g.chan + m->s->g.nchan; c++) {
		f = cmd_add(g, c->name, c->unit, c->support, c->step);
		if (m->o->rule == MORPH_LINEAR || !is_by_rule(c->name))
			sum_channel(m, w, c, f);
	}
	if (m->o->rule != MORPH_LINEAR)
		mix_metric(m, w, border, g);
	check_blend(g);
	if (m->work && blend_single(m->n, w) < 0)
		watch(m, w, k, g);
}

void
mix_note(const Morph *m)
{
	if (m->most > FAR && !m->o->cap)
		note("frame %d asks for K > H^2, which no surface has: an integral of %.2g beyond the grids' own; "
		    "surfaces may jump there (--cap lowers lambda)", m->worst, m->most);
}
