/* mend.c - makes a disk, or a closed surface, from the polygons of a file: the steps in their order. */
#include <stdlib.h>
#include <string.h>

#include "../mesh/channel.h"
#include "../mesh/fail.h"
#include "clean.h"
#include "flat.h"
#include "handle.h"
#include "hole.h"
#include "mend.h"
#include "open.h"
#include "piece.h"
#include "step.h"
#include "values.h"

static int
flatten(Sheet *s, MendReport *r)
{
	Flattened sum;
	int e;

	if ((e = flat_mend(s, &sum)) != 0)
		return e;
	r->collapsed += sum.collapsed;
	memcpy(r->short_at, sum.edge, sizeof sum.edge);
	r->flipped = sum.flipped;
	r->dropped = sum.dropped;
	r->flat_left = sum.left;
	r->flat_at = sum.at < 0 ? -1 : s->source[sum.at];
	return s->nf ? 0 : mesh_fail(s->err, MESH_EDISK, "no face has area");
}

/* Counts the handles, closed components and disks of s. */
static int
take_stock(const Sheet *s, MendReport *r)
{
	int *piece = mesh_alloc(s->err, (size_t)s->nf, sizeof *piece), n, i;
	Piece *list = NULL;

	n = piece ? piece_find(s, piece, &list) : MESH_ENOMEM;
	for (r->left = n, r->genus = r->closed = r->disks = 0, i = 0; i < n; i++) {
		r->genus += list[i].genus;
		r->closed += list[i].loops == 0;
		r->disks += list[i].loops == 1 && list[i].genus == 0;
	}
	free(piece);
	free(list);
	return n < 0 ? n : 0;
}

static int
cut_handles(Sheet *s, const MendOptions *o, MendReport *r)
{
	Filled sum = { .left_at = -1, .order = o->fill };
	int e;

	if ((e = take_stock(s, r)) != 0 || r->genus == 0)
		return e;
	if (!o->cut_handles)
		return o->check ? 0 : mesh_fail(s->err, MESH_EDISK, "%d %s: --handles=cut cuts and closes %s",
		    r->genus, r->genus == 1 ? "handle" : "handles", r->genus == 1 ? "it" : "them");
	if ((e = handle_cut(s, o->fill, &r->handles, &r->handle_length, &sum)) != 0)
		return e;
	r->faces += sum.faces;
	r->vertices += sum.vertices;
	return take_stock(s, r);
}

static int
open_closed(Sheet *s, const MendOptions *o, MendReport *r)
{
	int e;

	if (o->open == MEND_CLOSED || r->closed == 0)
		return 0;
	r->opened = r->closed;
	if ((e = open_all(s, o->open == MEND_OPEN_AT ? o->at : NULL, &r->cut)) != 0)
		return e;
	return take_stock(s, r);
}

/* The steps that need neighbours to agree in orientation. */
static int
shape(Sheet *s, const MendOptions *o, MendReport *r)
{
	int e = piece_orient(s);

	if (e == MESH_EORIENT && o->check) {
		r->one_sided = 1;
		return take_stock(s, r);
	}
	if (e < 0)
		return e;
	r->turned = e;
	if ((e = flatten(s, r)) != 0 || (e = mend_fill(s, o, r)) != 0 || (e = cut_handles(s, o, r)) != 0)
		return e;
	return open_closed(s, o, r);
}

/* Makes channel MESH_SOURCE from `source`: numbers of vertices of the input or, if the input has a
 * channel MESH_SOURCE, the values of that channel at these vertices. */
static int
add_source(Soup *out, const int *source)
{
	double *f = channel_values(&out->channels, MESH_SOURCE);
	int v;

	if (f) {
		for (v = 0; v < out->nv; v++)
			if (source[v] < 0)
				f[v] = -1;
		return 0;
	}
	if (!(f = channel_add(&out->channels, MESH_SOURCE, 1, (size_t)out->nv)))
		return mesh_fail(out->err, MESH_ENOMEM, "no memory for the numbers of %d vertices", out->nv);
	for (v = 0; v < out->nv; v++)
		f[v] = source[v];
	return 0;
}

/* Moves the sheet to a soup. */
static int
make_soup(Soup *out, Sheet *s, const Soup *from)
{
	int f, e;

	if (!(out->first = mesh_alloc(out->err, (size_t)s->nf + 1, sizeof *out->first)) ||
	    channels_gather(&out->channels, &from->channels, s->nv, s->source, 0))
		return mesh_fail(out->err, MESH_ENOMEM, "no memory for %d vertices", s->nv);
	out->nv = s->nv, out->nf = s->nf, out->T = from->T;
	for (f = 0; f <= s->nf; f++)
		out->first[f] = 3*f;
	out->xyz = s->xyz, out->idx = s->tri, out->filled = s->filled;
	s->xyz = NULL, s->tri = NULL, s->filled = NULL;
	if ((e = values_made(out, s->source)) != 0)
		return e;
	return add_source(out, s->source);
}

int
mend(Soup *out, const Soup *s, const MendOptions *o, MendReport *r)
{
	Sheet sheet = { .err = out->err };
	int e;

	memset(out, 0, sizeof *out);
	*r = (MendReport){ .missing_at = -1, .infinite_at = -1, .broken_at = -1, .twice_at = -1, .nearest = -1, .flat_at = -1,
		.short_at = { -1, -1 }, .left_at = -1, .order = o->fill };
	e = sheet_clean(&sheet, s, r);
	if (!e && (e = mend_connect(&sheet, o, r)) == 0 && (e = mend_choose(&sheet, o, r)) == 0)
		e = shape(&sheet, o, r);
	if (!e && (e = sheet_compact(&sheet)) >= 0)
		e = make_soup(out, &sheet, s);
	sheet_free(&sheet);
	if (e)
		soup_free(out);
	return e;
}

void
mend_report_free(MendReport *r)
{
	free(r->piece);
	free(r->loop);
	r->piece = NULL;
	r->loop = NULL;
}
