/* notes.c - the notes of mesh2disk: a line for each change. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../shared/cmd.h"
#include "notes.h"

/* The lines so far, and the name of the input. */
typedef struct Lines {
	CmdText     t;
	const char *name;
	const Soup *s;
} Lines;

/* Prints a note and appends the same line to the comments, if n > 0. */
static void
line(Lines *l, int n, const char *fmt, ...)
{
	char buf[300];
	va_list ap;

	if (n == 0)
		return;
	va_start(ap, fmt);
	vsnprintf(buf, sizeof buf, fmt, ap);
	va_end(ap);
	note("%s: %s", l->name, buf);
	fprintf(l->t.f, "mesh2disk: %s\n", buf);
}

/* " at vertex 12 (1 2 3)", or nothing for -1. */
static const char *
at(const Lines *l, int v, char buf[120])
{
	const double *x = l->s->xyz + 3*(size_t)(v < 0 ? 0 : v);

	buf[0] = '\0';
	if (v >= 0)
		snprintf(buf, 120, " at vertex %d (%g %g %g)", v, x[0], x[1], x[2]);
	return buf;
}

static const char *
s_of(int n)
{
	return n == 1 ? "" : "s";
}

/* Notes the vertices and faces dropped before neighbours were found. */
static void
cleaned(Lines *l, const MendReport *r)
{
	line(l, r->unused, "%d %s no face dropped", r->unused, r->unused == 1 ? "vertex of" : "vertices of");
	line(l, r->missing, "%d face%s dropped that refer%s to vertices that do not exist, first face %d",
	    r->missing, s_of(r->missing), r->missing == 1 ? "s" : "", r->missing_at);
	line(l, r->infinite, "%d face%s dropped at vertices that are not finite, first vertex %d",
	    r->infinite, s_of(r->infinite), r->infinite_at);
	line(l, r->broken, "%d face%s without three different corners dropped, first face %d",
	    r->broken, s_of(r->broken), r->broken_at);
	line(l, r->twice, "%d triangle%s dropped, as others lie on the same vertices", r->twice, s_of(r->twice));
}

static void
connected(Lines *l, const MendReport *r)
{
	char where[120];

	if (r->weld > 0)
		snprintf(where, sizeof where, "within %g", r->weld);
	else
		snprintf(where, sizeof where, "at the same place");
	line(l, r->welded, "%d boundary %s welded to others %s", r->welded,
	    r->welded == 1 ? "vertex" : "vertices", where);
	line(l, r->weld > 0 ? 0 : r->close, "%d boundary %s within %.2g of others, but not at their place, stay%s apart; "
	    "--weld=auto welds them", r->close, r->close == 1 ? "vertex" : "vertices", r->within,
	    r->close == 1 ? "s" : "");
	line(l, r->many, "%d edge%s of more than two faces parted, first%s", r->many, s_of(r->many),
	    at(l, r->many_at[0], where));
	line(l, r->parted, "%d %s added where fans of faces met at one vertex", r->parted,
	    r->parted == 1 ? "vertex" : "vertices");
	line(l, r->flaps, "%d face%s dropped at edges of more than two faces", r->flaps, s_of(r->flaps));
}

static void
kept(Lines *l, const MendReport *r)
{
	double area = 0;
	int i, n = 0;

	for (i = 0; i < r->npiece; i++)
		if (r->piece[i].kept)
			n++, area += r->piece[i].area;
	line(l, r->npiece - n, "%d of %d components kept; the others have %.3g %% of the area", n, r->npiece,
	    r->area > 0 ? 100*(1 - area/r->area) : 0);
	line(l, r->turned, "%d face%s turned to agree with the rest", r->turned, s_of(r->turned));
}

static void
flat(Lines *l, const MendReport *r)
{
	char where[120];

	if (r->short_at[0] >= 0)
		line(l, r->collapsed, "%d face%s or edges without extent collapsed, the first edge between vertices %d and %d",
		    r->collapsed, s_of(r->collapsed), r->short_at[0], r->short_at[1]);
	else
		line(l, r->collapsed, "%d face%s without extent collapsed", r->collapsed, s_of(r->collapsed));
	line(l, r->flipped, "%d longest edge%s of faces without area flipped", r->flipped, s_of(r->flipped));
	line(l, r->dropped, "%d face%s without area dropped at the boundary", r->dropped, s_of(r->dropped));
	line(l, r->flat_left, "%d face%s without area could not be mended, first%s", r->flat_left,
	    s_of(r->flat_left), at(l, r->flat_at, where));
}

static void
filled(Lines *l, const MendReport *r)
{
	static const char *const how[] = { "flat", "going on with the slope (C1)",
		"going on with the slope and curvature (C2)" };
	char where[120];

	line(l, r->seams, "%d edge%s split at vertices that lie on them (T-junctions)", r->seams, s_of(r->seams));
	line(l, r->holes, "%d hole%s filled by %d face%s and %d vert%s, %s, the longest %g round", r->holes,
	    s_of(r->holes), r->faces, s_of(r->faces), r->vertices, r->vertices == 1 ? "ex" : "ices",
	    how[r->vertices ? r->order : 0], r->longest);
	line(l, r->holes_left, "%d hole%s could not be filled, first%s", r->holes_left, s_of(r->holes_left),
	    at(l, r->left_at, where));
	line(l, r->handles, "%d handle%s cut and closed, %g round together", r->handles, s_of(r->handles),
	    r->handle_length);
	line(l, r->opened, "closed surface cut open along %g", r->cut);
}

/* Notes the faults that remain, for which mesh2rect would refuse the result. */
static void
left(Lines *l, const MendReport *r)
{
	if (r->closed)
		line(l, 1, "the surface is closed and stays so, for the pillow of mesh2rect; --open=auto cuts it open");
	else if (r->left > 1)
		line(l, 1, "%d components, of which %d are disks", r->left, r->disks);
	else if (r->disks < r->left)
		line(l, 1, "no disk: more than one boundary loop is left");
}

/* Notes the numbers of the file that the result or its format has no place for. */
static void
unplaced(const char *name, const Soup *s, const MendReport *r, const MeshFormat *format)
{
	const int fields = s->channels.n - (channel_find(&s->channels, MESH_SOURCE) != NULL);

	if (s->left_out)
		note("%s: left out: %s", name, s->left_out);
	if (fields && !(format->can & MESHFORMAT_FIELDS))
		note("%s: %s has no place for the %d propert%s of the vertices, PLY does", name, format->name, fields,
		    fields == 1 ? "y" : "ies");
	if (strcmp(format->name, "PLY") != 0 && (r->unused || r->holes))
		note("%s: %s has no place for source and filled, PLY does", name, format->name);
}

char *
notes(const char *name, const Soup *s, const MendReport *r, const MeshFormat *format)
{
	Lines l = { .name = name, .s = s };

	cmd_text_open(&l.t);
	cleaned(&l, r);
	connected(&l, r);
	kept(&l, r);
	flat(&l, r);
	filled(&l, r);
	left(&l, r);
	unplaced(name, s, r, format);
	putc('\0', l.t.f);
	cmd_text_close(&l.t);
	return l.t.bytes;
}
