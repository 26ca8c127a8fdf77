/* marks.c - the file of lhwarp --landmarks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/vec3.h"
#include "../../lib/grid/stencil.h"
#include "../../lib/mesh/channel.h"
#include "marks.h"

static const double FAR = 0.05;         /* a point is noted if it is farther from the surface than
                                         * this fraction of sqrt(area) */
enum { MOST = 6 };                      /* numbers on a line */

typedef struct Line {
	const char *name;       /* of the file */
	int    line, n;
	double x[MOST];
} Line;

static void
numbers(Line *l, char *s)
{
	static const char digits[] = "0123456789.+-eE";
	char *word, *end, *rest = s;

	s[strcspn(s, "#")] = '\0';
	for (l->n = 0; (word = strtok_r(rest, " \t\r,", &rest)); l->n++) {
		if (l->n == MOST)
			die("%s: line %d: more than %d numbers", l->name, l->line, MOST);
		l->x[l->n] = strtod(word, &end);
		if (*end || word[strspn(word, digits)] || !isfinite(l->x[l->n]))
			die("%s: line %d: %.40s is not a number", l->name, l->line, word);
	}
}

static void
by_uv(const Line *l, const Side *s, const double *x, double at[2])
{
	double T = s->g.T;

	if (!(x[0] >= 0 && x[0] <= 1 && x[1] >= 0 && x[1] <= T*(1 + 1e-6)))
		die("%s: line %d: (%g,%g) is not in [0,1] x [0,%g], the chart of %s", l->name, l->line, x[0], x[1], T,
		    s->in.name);
	at[0] = x[0];
	at[1] = fmin(x[1], T);
}

static void
by_vertex(const Line *l, const Side *s, double x, const char *option, double at[2])
{
	const double *uv;

	if (!s->mesh)
		die("%s: line %d: two vertex numbers need --uv-a=MESH and --uv-b=MESH: there is no --%s", l->name, l->line,
		    option);
	if (!(x >= 0 && x < s->s.nv && x == floor(x)))
		die("%s: line %d: %s has no vertex %.17g: 0 to %d", l->name, l->line, s->mesh, x, s->s.nv - 1);
	uv = channel_values(&s->s.channels, MESH_UV) + 2*(size_t)x;
	if (uv[0] == -1 && uv[1] == -1)
		die("%s: line %d: vertex %.17g of %s has no (u,v)", l->name, l->line, x, s->mesh);
	at[0] = fmin(fmax(uv[0], 0), 1);
	at[1] = fmin(fmax(uv[1], 0), s->g.T);
}

/* Half a step at most from the nearest node p, in the plane of its tangents. */
static void
by_point(const Line *l, const Side *s, const double *x, double at[2])
{
	const double *const phi[3] = { s->phi[0], s->phi[1], s->phi[2] };
	int n = s->g.nu*s->g.nv, p, k, best = 0, c;
	double nearest = INFINITY, d[3], u[3], v[3], uu, uv, vv, det, step[2];

	for (p = 0; p < n; p++) {
		for (c = 0; c < 3; c++)
			d[c] = x[c] - phi[c][p];
		if (dot3(d, d) < nearest) {
			nearest = dot3(d, d);
			best = p;
		}
	}
	stencil_tangents(s->chart, phi, best % s->g.nu, best/s->g.nu, u, v);
	for (c = 0; c < 3; c++)
		d[c] = x[c] - phi[c][best];
	uu = dot3(u, u);
	uv = dot3(u, v);
	vv = dot3(v, v);
	det = uu*vv - uv*uv;
	step[0] = det > 0 ? (vv*dot3(u, d) - uv*dot3(v, d))/det : 0;
	step[1] = det > 0 ? (uu*dot3(v, d) - uv*dot3(u, d))/det : 0;
	for (k = 0; k < 2; k++) {
		double half = (k ? chart_k(s->chart) : chart_h(s->chart))/2, side = k ? s->g.T : 1;

		at[k] = k ? chart_v(s->chart, best/s->g.nu) : chart_u(s->chart, best % s->g.nu);
		at[k] = fmin(fmax(at[k] + fmin(fmax(step[k], -half), half), 0), side);
	}
	if (!(sqrt(nearest) <= FAR*sqrt(s->area)))
		note("%s: line %d: the point is %.3g from %s, whose sqrt(area) is %.3g", l->name, l->line, sqrt(nearest),
		    s->in.name, sqrt(s->area));
}

static void
add(Marks *m, const Line *l, const Side *const s[2])
{
	int k;

	for (k = 0; k < 2; k++) {
		double *at = m->at[k][m->n];

		switch (l->n) {
		case 2: by_vertex(l, s[k], l->x[k], k ? "uv-b" : "uv-a", at); break;
		case 4: by_uv(l, s[k], l->x + 2*k, at); break;
		case 6: by_point(l, s[k], l->x + 3*k, at); break;
		default: die("%s: line %d: %d number%s, need two vertex numbers, two pairs u v or two points x y z",
			l->name, l->line, l->n, l->n == 1 ? "" : "s");
		}
	}
	detail("%s: line %d: (%.4f,%.4f) on A, (%.4f,%.4f) on B", l->name, l->line, m->at[0][m->n][0], m->at[0][m->n][1],
	    m->at[1][m->n][0], m->at[1][m->n][1]);
	m->n++;
}

/* The file as text with a final NUL, to be freed. */
static char *
text_of(const char *path)
{
	size_t n;
	char *bytes = cmd_slurp(path, &n), *s = cmd_alloc(n + 1, 1);

	memcpy(s, bytes, n);
	s[n] = '\0';
	if (strlen(s) != n)
		die("%s: not a text file", cmd_name_of(path));
	free(bytes);
	return s;
}

void
marks_read(const char *path, const Side *a, const Side *b, Marks *m)
{
	const Side *const both[2] = { a, b };
	Line l = { .name = cmd_name_of(path) };
	char *text = text_of(path), *s, *end;
	size_t most = 1;

	for (s = text; *s; s++)
		most += *s == '\n';
	m->n = 0;
	m->at[0] = cmd_alloc(most, sizeof *m->at[0]);
	m->at[1] = cmd_alloc(most, sizeof *m->at[1]);
	for (s = text, l.line = 1; s; s = end, l.line++) {
		if ((end = strchr(s, '\n')))
			*end++ = '\0';
		numbers(&l, s);
		if (l.n)
			add(m, &l, both);
	}
	if (!m->n)
		die("%s: no landmarks", l.name);
	free(text);
}

void
marks_free(Marks *m)
{
	free(m->at[0]);
	free(m->at[1]);
}
