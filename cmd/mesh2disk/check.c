/* check.c - the report of mesh2disk --check, as text and as JSON. */
#include <math.h>
#include <stdarg.h>

#include "../shared/json.h"
#include "check.h"

enum { MOST = 10 };             /* components and loops that are listed one by one */

static double
diagonal(const MendReport *r)
{
	return hypot(hypot(r->hi[0] - r->lo[0], r->hi[1] - r->lo[1]), r->hi[2] - r->lo[2]);
}

/* Prints a row of the table, if n is not 0. */
static void
row(FILE *f, int n, const char *what, const char *fmt, ...)
{
	va_list ap;

	if (n == 0)
		return;
	fprintf(f, "%-22s %8d   ", what, n);
	va_start(ap, fmt);
	vfprintf(f, fmt, ap);
	va_end(ap);
	putc('\n', f);
}

/* The units of length in which the size of the surface is between that of a tooth, 5 mm, and of a body,
 * 2 m. */
static const char *
unit_of(const MendReport *r)
{
	const double d = diagonal(r);
	const int m = d >= 0.005 && d <= 2, cm = d >= 0.5 && d <= 200, mm = d >= 5 && d <= 2000;
	static const char *const units[] = { "none of m, cm, mm", "m", "cm", "m or cm", "mm", "m or mm", "cm or mm",
		"m, cm or mm" };

	return units[m + 2*cm + 4*mm];
}

static void
faults_text(FILE *f, const MendReport *r)
{
	row(f, r->unused, "vertices of no face", "dropped");
	row(f, r->missing, "faces of no vertex", "dropped: corners that do not exist; first face %d", r->missing_at);
	row(f, r->infinite, "faces not finite", "dropped; first vertex %d", r->infinite_at);
	row(f, r->broken, "faces without corners", "dropped: fewer than three different; first face %d", r->broken_at);
	row(f, r->twice, "faces said twice", "dropped");
	row(f, r->coincident, "coincident vertices", "on the boundary, at the place of another: a seam");
	row(f, r->close, "close vertices", "on the boundary, within %.2g of another: --weld=auto", r->within);
	if (r->nearest > 0)
		fprintf(f, "%-22s %8.3g   apart, on the boundary and of no common face\n", "nearest vertices",
		    r->nearest);
	row(f, r->welded, "vertices welded", "within %g", r->weld);
	row(f, r->many, "edges of many faces", "more than two; parted; first %d-%d", r->many_at[0], r->many_at[1]);
	row(f, r->parted, "pinched vertices", "several fans of faces; a vertex added for each");
	row(f, r->flaps, "flaps", "faces at these edges, dropped");
	row(f, r->turned, "faces turned", "to agree in orientation with the rest");
	row(f, r->one_sided, "one-sided surface", "no orientation agrees: nothing can mend this but a cut by hand");
	if (r->short_at[0] >= 0)
		row(f, r->collapsed + r->flipped + r->dropped, "faces without area",
		    "collapsed, flipped or dropped; first short edge %d-%d", r->short_at[0], r->short_at[1]);
	else
		row(f, r->collapsed + r->flipped + r->dropped, "faces without area", "collapsed, flipped or dropped");
	row(f, r->flat_left, "faces without area", "that cannot be mended; first at vertex %d", r->flat_at);
	row(f, r->seams, "T-junctions", "vertices on an edge: the edge is split");
}

static void
components_text(FILE *f, const MendReport *r)
{
	int i;

	row(f, r->npiece, "components", "%s", r->npiece > 1 ? "--components=largest|N|all" : "hangs together");
	for (i = 0; i < r->npiece && i < MOST && r->npiece > 1; i++)
		fprintf(f, "  %-28s   %6.3g %% of the area, %d faces%s\n", r->piece[i].kept ? "kept" : "dropped",
		    r->area > 0 ? 100*r->piece[i].area/r->area : 0, r->piece[i].nf,
		    r->piece[i].loops ? "" : ", closed");
	row(f, r->npiece - i > 0 && r->npiece > 1 ? r->npiece - i : 0, "  more", "smaller");
}

static void
loops_text(FILE *f, const MendReport *r)
{
	int i;

	row(f, r->nloop, "boundary loops", "%s", r->nloop > 1 ? "--holes=fill|keep|all, --max-hole" : "the rim");
	for (i = 0; i < r->nloop && i < MOST; i++)
		fprintf(f, "  %-28s   %g round, %d vertices, at vertex %d\n", i ? "hole" : "longest",
		    r->loop[i].length, r->loop[i].n, r->loop[i].at);
	row(f, r->nloop - i, "  more", "shorter");
	row(f, r->holes, "holes filled", "%d vertices and %d faces made", r->vertices, r->faces);
	row(f, r->holes_left, "holes not filled", "no triangulation; first at vertex %d", r->left_at);
	row(f, r->genus, "handles", "--handles=cut cuts and closes them");
	row(f, r->handles, "handles cut", "%g round together", r->handle_length);
	row(f, r->closed, "closed", "no boundary: --open=auto cuts it open");
	row(f, r->opened, "closed, cut open", "along %g", r->cut);
}

/* Why mesh2disk refuses the file, or NULL; refusal is the reason with which mend failed, or NULL. */
static const char *
reason(const MendReport *r, const char *refusal)
{
	return refusal ? refusal : r->one_sided ? "one-sided" : r->genus ? "handles, without --handles=cut" : NULL;
}

/* Whether the result is a single component, and it is counted in n: r->disks or r->closed. */
static int
single(const MendReport *r, int n)
{
	return r->left == 1 && n == 1;
}

void
check_text(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r, const char *refusal)
{
	fprintf(f, "%s: %d vertices, %d faces, %.4g x %.4g x %.4g, from tooth to body if the unit is %s\n", name,
	    s->nv, s->nf, r->hi[0] - r->lo[0], r->hi[1] - r->lo[1], r->hi[2] - r->lo[2], unit_of(r));
	faults_text(f, r);
	components_text(f, r);
	loops_text(f, r);
	if (reason(r, refusal))
		fprintf(f, "result: refused: %s\n", reason(r, refusal));
	else
		fprintf(f, "result: %s, %d vertices, %d faces\n", single(r, r->disks) ? "a disk" :
		    single(r, r->closed) ? "a closed surface" : "no disk", out->nv, out->nf);
}

static void
count(FILE *f, const char *key, int n)
{
	fprintf(f, ", \"%s\": %d", key, n);
}

static void
number(FILE *f, const char *key, double x)
{
	if (isfinite(x))
		fprintf(f, ", \"%s\": %.17g", key, x);
}

static void
lists_json(FILE *f, const MendReport *r)
{
	int i;

	fprintf(f, ", \"components\": [");
	for (i = 0; i < r->npiece; i++)
		fprintf(f, "%s{\"area\": %.17g, \"vertices\": %d, \"faces\": %d, \"loops\": %d, \"genus\": %d, "
		    "\"kept\": %s}", i ? ", " : "", r->piece[i].area, r->piece[i].nv, r->piece[i].nf,
		    r->piece[i].loops, r->piece[i].genus, r->piece[i].kept ? "true" : "false");
	fprintf(f, "], \"loops\": [");
	for (i = 0; i < r->nloop; i++)
		fprintf(f, "%s{\"length\": %.17g, \"vertices\": %d, \"at\": %d}", i ? ", " : "",
		    r->loop[i].length, r->loop[i].n, r->loop[i].at);
	putc(']', f);
}

static void
counts_json(FILE *f, const MendReport *r)
{
	count(f, "unused_vertices", r->unused);
	count(f, "faces_of_no_vertex", r->missing);
	count(f, "faces_not_finite", r->infinite);
	count(f, "faces_without_corners", r->broken);
	count(f, "faces_twice", r->twice);
	count(f, "coincident_vertices", r->coincident);
	count(f, "close_vertices", r->close);
	if (r->nearest > 0)
		number(f, "nearest_vertices", r->nearest);
	count(f, "vertices_welded", r->welded);
	count(f, "edges_of_many_faces", r->many);
	count(f, "pinched_vertices", r->parted);
	count(f, "flaps_dropped", r->flaps);
	count(f, "faces_turned", r->turned);
	fprintf(f, ", \"one_sided\": %s", r->one_sided ? "true" : "false");
	count(f, "faces_without_area", r->collapsed + r->flipped + r->dropped + r->flat_left);
	count(f, "t_junctions", r->seams);
	count(f, "holes_filled", r->holes);
	count(f, "holes_not_filled", r->holes_left);
	count(f, "handles", r->genus);
	count(f, "handles_cut", r->handles);
	count(f, "closed", r->closed);
}

void
check_json(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r, const char *refusal)
{
	const char *why = reason(r, refusal);

	fprintf(f, "{\"file\": ");
	json_string(f, name);
	fprintf(f, ", \"vertices\": %d, \"faces\": %d", s->nv, s->nf);
	number(f, "diagonal", diagonal(r));
	fprintf(f, ", \"units_from_tooth_to_body\": \"%s\"", unit_of(r));
	counts_json(f, r);
	lists_json(f, r);
	fprintf(f, ", \"result\": \"%s\"", why ? "refused" : single(r, r->disks) ? "disk" :
	    single(r, r->closed) ? "closed" : "other");
	if (why) {
		fprintf(f, ", \"reason\": ");
		json_string(f, why);
	} else {
		fprintf(f, ", \"result_vertices\": %d, \"result_faces\": %d", out->nv, out->nf);
	}
	fprintf(f, "}\n");
}
