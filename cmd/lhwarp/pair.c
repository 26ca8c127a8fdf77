/* pair.c - the two surfaces of lhwarp. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/grid/gridloss.h"
#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/disk.h"
#include "../shared/chartof.h"
#include "../shared/load.h"
#include "../shared/range.h"
#include "pair.h"

static const double APART = 2;          /* ratio of sizes above which a note is printed */

/* The signed area of the triangles of d in (u,v): negative if mesh2rect reversed its normal. */
static double
plane_area(const Disk *d, const double *uv)
{
	double sum = 0;
	int t;

	for (t = 0; t < d->m.nf; t++) {
		const int *k = d->m.tri + 3*(size_t)t;
		const double *a = uv + 2*(size_t)k[0], *b = uv + 2*(size_t)k[1], *c = uv + 2*(size_t)k[2];

		sum += (b[0] - a[0])*(c[1] - a[1]) - (b[1] - a[1])*(c[0] - a[0]);
	}
	return sum;
}

static void
open_mesh(Side *s)
{
	const double *uv;
	int p;

	load_soup(s->mesh, MESHFILE_UV, &s->s);
	if (s->s.chart && s->s.chart != &CHART_RECTANGLE)
		die("%s: its (u,v) are on a %s, those of %s on a rectangle", s->mesh, s->s.chart->name, s->in.name);
	if (s->s.T > 0 && fabs(s->s.T - s->g.T) > 1e-3*s->g.T)
		die("%s: its chart is %g high, that of %s %g: need the mesh that mesh2rect --uv wrote with this grid",
		    s->mesh, s->s.T, s->in.name, s->g.T);
	load_disk(s->mesh, &s->s, &s->d);
	uv = channel_values(&s->d.channels, MESH_UV);
	for (p = 0; p < s->d.m.nv; p++)
		if (!(uv[2*(size_t)p] >= 0 && uv[2*(size_t)p+1] >= 0))
			die("%s: vertex %d has no (u,v)", s->mesh, s->d.file ? s->d.file[p] : p);
	if (plane_area(&s->d, uv) < 0)
		disk_flip(&s->d);
}

void
side_open(Side *s, const char *path, const char *mesh)
{
	static const char *const xyz[3] = { "x", "y", "z" };
	int c, k;

	memset(s, 0, sizeof *s);
	cmd_open(&s->in, path);
	cmd_read_one(&s->in, &s->g);
	if (s->g.chart != LHG_RECTANGLE)
		die("%s: is on a %s; lhwarp takes rectangles only: mesh2rect --%s", s->in.name, lhg_chartname(s->g.chart),
		    s->g.chart == LHG_PILLOW ? "like brings closed surfaces to one chart" : "chart=rectangle");
	for (c = 0; c < 3; c++)
		s->phi[c] = cmd_need(&s->in, &s->g, xyz[c], LHG_GRID);
	for (k = 0; k < s->g.nchan; k++)
		if (s->g.chan[k].support != LHG_GRID)
			die("%s: channel %s is not on all nodes: lhwarp comes before grid2lh", s->in.name, s->g.chan[k].name);
	if (s->g.nu < 4 || s->g.nv < 4)
		die("%s: has %d x %d nodes, need 4 x 4: mesh2rect -n", s->in.name, s->g.nu, s->g.nv);
	range_height(&s->in, &s->g);
	range_positions(s->in.name, (size_t)s->g.nu*s->g.nv, 1, (const double *const *)s->phi);
	s->chart = chart_of(&s->g);
	if (gridloss_area(s->chart, s->phi, &s->area))
		die("%s: no memory for its area", s->in.name);
	if (!(s->area > 0))
		die("%s: the surface has no area", s->in.name);
	s->mesh = mesh;
	if (mesh)
		open_mesh(s);
}

void
side_free(Side *s)
{
	lhg_free(&s->g);
	if (s->mesh) {
		soup_free(&s->s);
		disk_free(&s->d);
	}
}

void
side_match(const Side *a, Side *b, int scaled)
{
	double s = sqrt(a->area/b->area), by;
	size_t p;
	int k;

	if (!scaled) {
		if (!(s <= APART && s >= 1/APART))
			note("%s is %.3g times as large as %s: surfaces between them are poor (--scale brings %s to the area of %s)",
			    s > 1 ? a->in.name : b->in.name, s > 1 ? s : 1/s, s > 1 ? b->in.name : a->in.name, b->in.name,
			    a->in.name);
		return;
	}
	for (k = 0; k < b->g.nchan; k++) {
		const LhgChannel *c = &b->g.chan[k];

		by = strcmp(c->unit, "length") == 0 ? s : strcmp(c->unit, "1/length") == 0 ? 1/s : 1;
		for (p = 0; p < c->n && by != 1; p++)
			c->f[p] *= by;
	}
	for (p = 0; b->mesh && p < 3*(size_t)b->d.m.nv; p++)
		b->d.m.xyz[p] *= s;
	b->area *= s*s;
	detail("%s scaled by %.6g, to the area of %s", b->in.name, s, a->in.name);
}
