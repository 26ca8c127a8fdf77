/* quality.c - reports the quality of a map: metadata, details, notes. */
#include "../../lib/meshfile/facts.h"
#include "../shared/cmd.h"
#include "quality.h"

void
quality_meta(Lhg *out, const Disk *d, const int *corner, double apart, const Conformal *c)
{
	const int *l = d->loop;

	cmd_meta(out, "vertices", "%d", d->m.nv);
	cmd_meta(out, "faces", "%d", d->m.nf);
	if (corner)
		cmd_meta(out, "corners", "%d,%d,%d,%d", d->file[l[corner[0]]], d->file[l[corner[1]]],
		    d->file[l[corner[2]]], d->file[l[corner[3]]]);
	if (apart >= 0)
		cmd_meta(out, "like", "%.6g", apart);
	cmd_meta(out, "certificate", "%.6g", c->certificate);
	cmd_meta(out, "solved", "%d", c->vertices);
	cmd_meta(out, "turned", "%d", c->uv.turned);
	cmd_meta(out, "overlaid", "%d", c->overlaid);
	cmd_meta(out, "polished", "%d", c->polished);
}

void
quality_facts(Lhg *out, const char *facts)
{
	char key[FACT_KEY], value[FACT_VALUE];

	while ((facts = fact_next(facts, key, value)))
		cmd_meta(out, key, "%s", value);
}

/* Notes a missed tolerance.  With tolerance 0 splitting goes on to --max-vertices, and with 1 it is
 * off; then there is nothing to note. */
static void
note_tolerance(const char *mesh, const AdaptOptions *o, const Conformal *c)
{
	if (!(c->certificate > o->tolerance && o->tolerance > 0 && o->tolerance < 1))
		return;
	if (c->full)
		note("%s: certificate %.3g of the map is above --tolerance=%g: "
		    "a larger --max-vertices than %d lowers it", mesh, c->certificate, o->tolerance, o->most);
	else
		note("%s: certificate %.3g of the map is above --tolerance=%g: "
		    "splitting more facets does not lower it", mesh, c->certificate, o->tolerance);
}

void
quality_notes(const char *mesh, const char *uv, const Disk *d, const ConformalOptions *o,
	const Conformal *c)
{
	detail("T %.6g, certificate %.3g on %d vertices, %d triangles turned over, %d rounds of polish",
	    c->grid.g.T, c->certificate, c->vertices, c->uv.turned, c->polished);
	if (c->overlaid && o->surface == SAMPLER_SMOOTH)
		detail("%s: %d of %d triangles are turned over or flat if drawn with straight edges in (u,v): "
		    "near them the facets are sampled", mesh, c->overlaid, d->m.nf);
	note_tolerance(mesh, &o->map, c);
	if (c->solved_turned)
		note("%s: the map turns over %d triangles of the mesh that it was solved on: parts of the surface "
		    "are as small as the rounding of its coordinates", mesh, c->solved_turned);
	if (uv && c->uv.moved)
		detail("%s: %d of %d vertices are up to %.2g away from their places, so that triangles are not "
		    "turned over", uv, c->uv.moved, d->m.nv, c->uv.farthest);
	if (uv && c->uv.turned)
		note("%s: %d of %d triangles are turned over in (u,v), where edges are straight", uv, c->uv.turned,
		    d->m.nf);
}
