/* sampled.c - B on the chart of A. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/base/procrustes.h"
#include "../../lib/base/vec3.h"
#include "../../lib/grid/gridpoint.h"
#include "../../lib/grid/stencil.h"
#include "../../lib/mesh/channel.h"
#include "../../lib/morph/warpturn.h"
#include "../../lib/sample/sampler.h"
#include "sampled.h"

/* Where the nodes of A lie on B's chart: u and v. */
static void
places(const Side *a, const Side *b, const Found *f, double *u, double *v)
{
	int nu = a->g.nu, nv = a->g.nv;
	size_t n = (size_t)nu*nv, p;
	double *both = cmd_alloc(2*n, sizeof *both);

	if (warp_field(&f->warp, nu, nv, f->stretch, both))
		die("the map is folded between its nodes, or there is no memory for it: fewer nodes in %s", a->in.name);
	for (p = 0; p < n; p++) {
		u[p] = both[p];
		v[p] = both[n+p];
		warpturn_back(b->chart, f->turns, &u[p], &v[p]);
		u[p] = fmin(fmax(u[p], 0), 1);
		v[p] = fmin(fmax(v[p], 0), b->g.T);
	}
	free(both);
}

static void
from_grid(const Side *b, size_t n, const double *u, const double *v, Lhg *out)
{
	const double *from[LHG_MAXCHAN];
	double *to[LHG_MAXCHAN];
	int count = b->g.nchan, k;
	size_t p;

	for (k = 0; k < count; k++) {
		const LhgChannel *c = &b->g.chan[k];

		from[k] = c->f;
		to[k] = cmd_add(out, c->name, c->unit, LHG_GRID, 0);
	}
#pragma omp parallel for schedule(static)
	for (p = 0; p < n; p++) {
		double x[LHG_MAXCHAN];
		int c;

		gridpoint(b->chart, count, from, u[p], v[p], x);
		for (c = 0; c < count; c++)
			to[c][p] = x[c];
	}
}

/* Samples the positions of the mesh: smooth, or its facets if its map has flat or turned triangles. */
static void
from_mesh(const Side *b, size_t n, const double *u, const double *v, Lhg *out)
{
	double *phi[3] = { lhg_find(out, "x")->f, lhg_find(out, "y")->f, lhg_find(out, "z")->f };
	const double *uv = channel_values(&b->d.channels, MESH_UV);
	double *mu = cmd_alloc(2*(size_t)b->d.m.nv, sizeof *mu), *mv = mu + b->d.m.nv, s = b->s.T > 0 ? b->g.T/b->s.T : 1;
	int p, t, flat = 0;
	Sampler smooth;

	for (p = 0; p < b->d.m.nv; p++) {
		mu[p] = uv[2*(size_t)p];
		mv[p] = s*uv[2*(size_t)p+1];
	}
	if (sampler_init(&smooth, &b->d, mu, mv, b->g.T, SAMPLER_SMOOTH))
		die("%s: no memory to sample it", b->mesh);
	for (t = 0; t < b->d.m.nf; t++)
		flat += locate_is_flat(&smooth.l, t);
	if (flat)
		note("%s: %d triangle%s turned over in (u,v): its grid is sampled", b->mesh, flat, flat == 1 ? " is" : "s are");
	else if (sampler_points(&smooth, (int)n, u, v, phi))
		die("%s: no memory to sample it", b->mesh);
	sampler_free(&smooth);
	free(mu);
}

/* Moves the nodes of out rigidly onto those of a, weighted by a's area. */
static void
move(const Side *a, size_t n, Lhg *out)
{
	double *w = cmd_alloc(7*n, sizeof *w), *x = w + n, *y = w + 4*n, u[3], v[3], normal[3], rms;
	double *phi[3] = { lhg_find(out, "x")->f, lhg_find(out, "y")->f, lhg_find(out, "z")->f };
	size_t p;
	Rigid r;
	int c;

	for (p = 0; p < n; p++) {
		stencil_tangents(a->chart, (const double *const *)a->phi, (int)(p % a->g.nu), (int)(p/a->g.nu), u, v);
		cross3(u, v, normal);
		w[p] = norm3(normal);
		for (c = 0; c < 3; c++) {
			x[3*p+c] = a->phi[c][p];
			y[3*p+c] = phi[c][p];
		}
	}
	if (procrustes((int)n, w, x, y, &r, &rms))
		die("the surfaces cannot be moved onto each other");
	rigid_move(&r, (int)n, y);
	for (p = 0; p < n; p++)
		for (c = 0; c < 3; c++)
			phi[c][p] = y[3*p+c];
	detail("turned by %.4g degrees and moved by (%g,%g,%g): %.3g apart (rms), %.3g %% of sqrt(area)",
	    rigid_angle(&r)*180/M_PI, r.t[0], r.t[1], r.t[2], rms, 100*rms/sqrt(a->area));
	free(w);
}

/* Copies the history of b, line by line. */
static void
copy_history(const Side *b, Lhg *out)
{
	char *copy = b->g.hist ? strdup(b->g.hist) : NULL, *line, *rest = copy;

	if (b->g.hist && !copy)
		die("no memory for the history");
	while (rest && (line = strtok_r(rest, "\n", &rest)))
		if (lhg_note(out, line))
			die("no memory for the history");
	free(copy);
}

static void
copy_metadata(const Side *b, Lhg *out)
{
	char *copy = b->g.meta ? strdup(b->g.meta) : NULL, *line, *value, *rest = copy;

	if (b->g.meta && !copy)
		die("no memory for the metadata");
	while (rest && (line = strtok_r(rest, "\n", &rest)))
		if ((value = strchr(line, ' '))) {
			*value++ = '\0';
			cmd_meta(out, line, "%s", value);
		}
	free(copy);
}

void
sampled(const Side *a, const Side *b, const Found *f, Lhg *out)
{
	size_t n = (size_t)a->g.nu*a->g.nv;
	double *u = cmd_alloc(2*n, sizeof *u), *v = u + n;

	lhg_init(out, a->g.nu, a->g.nv, a->g.T);
	places(a, b, f, u, v);
	from_grid(b, n, u, v, out);
	if (b->mesh)
		from_mesh(b, n, u, v, out);
	move(a, n, out);
	copy_metadata(b, out);
	copy_history(b, out);
	cmd_meta(out, "warped", "%.4g %.4g", f->after.mu_mean, f->after.mu_max);
	cmd_meta(out, "warp-normals", "%.4g %.4g", f->before.apart, f->after.apart);
	if (f->before.marks > 0)
		cmd_meta(out, "warp-landmarks", "%.4g %.4g", f->before.marks, f->after.marks);
	if (f->turns)
		cmd_meta(out, "warp-turned", "%d", f->turns);
	free(u);
}
