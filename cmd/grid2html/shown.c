/* shown.c - collects surfaces and the channels that colour them. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/grid/gridmesh.h"
#include "../../lib/picture/colourscale.h"
#include "../shared/chartof.h"
#include "../shared/place.h"
#include "shown.h"

static int
is_position(const char *name)
{
	size_t n = strlen(name);

	return n > 0 && strchr("xyz", name[n-1]) && (n == 1 || name[n-2] == '.');
}

static void *
grown(const Shown *s, void *p, size_t bytes)
{
	p = realloc(p, bytes);
	if (!p)
		die("%s: no memory for %d frames of %d nodes", s->name, s->frames, s->vertices);
	return p;
}

/* The field of that name; a new one is NaN in the frames so far. */
static ShownField *
field_of(Shown *s, const char *name)
{
	int k;
	size_t i;

	for (k = 0; k < s->fields; k++)
		if (strcmp(s->field[k].name, name) == 0)
			return &s->field[k];
	s->field = grown(s, s->field, (size_t)(s->fields + 1)*sizeof *s->field);
	s->field[k] = (ShownField){ .f = NULL };
	strcpy(s->field[k].name, name);
	s->field[k].f = grown(s, NULL, (size_t)s->frames*(size_t)s->vertices*sizeof(float));
	for (i = 0; i < (size_t)s->frames*(size_t)s->vertices; i++)
		s->field[k].f[i] = NAN;
	s->fields++;
	return &s->field[k];
}

static void
set_frame(const Shown *s, ShownField *f, int frame, const double *x)
{
	int i;

	for (i = 0; i < s->vertices; i++)
		f->f[(size_t)frame*(size_t)s->vertices + (size_t)i] = (float)x[i];
}

/* Adds the channels of g on all nodes as fields of the frame. */
static void
add_fields(Shown *s, const Lhg *g, int frame)
{
	const LhgChannel *c;

	for (c = g->chan; c < g->chan + g->nchan; c++)
		if (c->support == LHG_GRID && !is_position(c->name))
			set_frame(s, field_of(s, c->name), frame, c->f);
}

static void
begin(const CmdInput *in, Shown *s, const Lhg *g, const double *const phi[3])
{
	Mesh m;

	if (mesh_from_grid(&m, chart_of(g), phi))
		die("%s: no memory for a mesh of %d x %d vertices", in->name, g->nu, g->nv);
	s->nu = g->nu, s->nv = g->nv, s->chart = g->chart;
	s->vertices = m.nv;
	s->faces = m.nf;
	s->tri = m.tri;
	free(m.xyz);
}

static void
same_size(const CmdInput *in, const Shown *s, const Lhg *g)
{
	if (g->chart != s->chart)
		die("%s: on a %s, %s is on a %s", in->name, lhg_chartname(g->chart), s->name, lhg_chartname(s->chart));
	if (g->nu != s->nu || g->nv != s->nv)
		die("%s: a grid of %d x %d nodes, %s has %d x %d", in->name, g->nu, g->nv, s->name, s->nu, s->nv);
}

void
shown_read(const char *path, Shown *s)
{
	static const char *const name[3] = { "x", "y", "z" };
	const double *phi[3];
	CmdInput in;
	Lhg g;
	int c, k;
	size_t i;

	*s = (Shown){ .frames = 0 };
	cmd_open(&in, path);
	s->name = in.name;
	while (cmd_read(&in, &g)) {
		for (c = 0; c < 3; c++)
			phi[c] = cmd_need(&in, &g, lhg_find(&g, "x") || !lhg_find(&g, PLACE[0]) ? name[c] : PLACE[c], LHG_GRID);
		if (!s->frames)
			begin(&in, s, &g, phi);
		same_size(&in, s, &g);
		s->frames++;
		s->xyz = grown(s, s->xyz, (size_t)s->frames*(size_t)s->vertices*3*sizeof *s->xyz);
		for (c = 0; c < 3; c++)
			for (i = 0; i < (size_t)s->vertices; i++)
				s->xyz[((size_t)(s->frames - 1)*(size_t)s->vertices + i)*3 + (size_t)c] = (float)phi[c][i];
		for (k = 0; k < s->fields; k++) {
			s->field[k].f = grown(s, s->field[k].f, (size_t)s->frames*(size_t)s->vertices*sizeof(float));
			for (i = 0; i < (size_t)s->vertices; i++)
				s->field[k].f[(size_t)(s->frames - 1)*(size_t)s->vertices + i] = NAN;
		}
		add_fields(s, &g, s->frames - 1);
		lhg_free(&g);
	}
}

void
shown_colours(const char *path, Shown *s)
{
	CmdInput in;
	Lhg g;
	int k, frame = 0;
	size_t row = (size_t)s->vertices*sizeof(float);

	cmd_open(&in, path);
	for (; cmd_read(&in, &g); frame++) {
		same_size(&in, s, &g);
		if (frame < s->frames)
			add_fields(s, &g, frame);
		lhg_free(&g);
	}
	for (; frame < s->frames; frame++)
		for (k = 0; k < s->fields; k++)
			if (isnan(s->field[k].f[(size_t)frame*(size_t)s->vertices]))
				memcpy(s->field[k].f + (size_t)frame*(size_t)s->vertices,
				    s->field[k].f + (size_t)(frame - 1)*(size_t)s->vertices, row);
}

static void
distance_to(Shown *a, const Shown *b)
{
	ShownField *f = field_of(a, "distance");
	int k, l, i, c;

	for (k = 0; k < a->frames; k++) {
		l = k < b->frames ? k : b->frames - 1;
		for (i = 0; i < a->vertices; i++) {
			const float *x = a->xyz + ((size_t)k*(size_t)a->vertices + (size_t)i)*3;
			const float *y = b->xyz + ((size_t)l*(size_t)b->vertices + (size_t)i)*3;
			double d2 = 0;

			for (c = 0; c < 3; c++)
				d2 += ((double)x[c] - y[c])*((double)x[c] - y[c]);
			f->f[(size_t)k*(size_t)a->vertices + (size_t)i] = (float)sqrt(d2);
		}
	}
}

void
shown_distance(Shown *a, Shown *b)
{
	if (a->chart != b->chart)
		die("%s is on a %s, %s on a %s: no distance between them", a->name, lhg_chartname(a->chart), b->name,
		    lhg_chartname(b->chart));
	if (a->nu != b->nu || a->nv != b->nv)
		die("%s has %d x %d nodes, %s has %d x %d: no distance between them", a->name, a->nu, a->nv, b->name,
		    b->nu, b->nv);
	distance_to(a, b);
	distance_to(b, a);
}

/* Appends the finite values of a field to x. */
static size_t
append(const Shown *s, const ShownField *f, double *x, size_t n)
{
	size_t i;

	for (i = 0; i < (size_t)s->frames*(size_t)s->vertices; i++)
		if (isfinite(f->f[i]))
			x[n++] = f->f[i];
	return n;
}

static void
fit(const Shown *a, ShownField *f, const Shown *b, ShownField *g)
{
	size_t most = (size_t)a->frames*(size_t)a->vertices + (g ? (size_t)b->frames*(size_t)b->vertices : 0), n, i;
	double *x = cmd_alloc(most, sizeof *x);
	ColourScale scale = { COLOURMAP_VIRIDIS, 0, 0, 1 };
	int below = 0, above = 0;

	n = append(a, f, x, 0);
	if (g)
		n = append(b, g, x, n);
	for (i = 0; i < n; i++)
		below |= x[i] < 0, above |= x[i] > 0;
	if (below && above)
		scale.map = COLOURMAP_DIVERGING;
	if (n > 0)
		colourscale_fit(&scale, n, x, (ColourEnd){ 1, 1 }, (ColourEnd){ 99, 1 });
	f->low = scale.low, f->high = scale.high, f->diverging = scale.map == COLOURMAP_DIVERGING;
	if (g)
		g->low = f->low, g->high = f->high, g->diverging = f->diverging;
	free(x);
}

void
shown_ranges(Shown *a, Shown *b)
{
	ShownField *g;
	int k, l;

	for (k = 0; k < a->fields; k++) {
		for (g = NULL, l = 0; b && l < b->fields; l++)
			if (strcmp(a->field[k].name, b->field[l].name) == 0)
				g = &b->field[l];
		fit(a, &a->field[k], b, g);
	}
	for (l = 0; b && l < b->fields; l++)
		if (!(b->field[l].high > b->field[l].low))
			fit(b, &b->field[l], NULL, NULL);
}

void
shown_free(Shown *s)
{
	int k;

	for (k = 0; k < s->fields; k++)
		free(s->field[k].f);
	free(s->field);
	free(s->tri);
	free(s->xyz);
}
