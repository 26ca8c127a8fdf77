/* uvread.c - reading the (u,v) and the offsets of a mesh file. */
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "../base/chart.h"
#include "../mesh/channel.h"
#include "meshpriv.h"

int
offset_append(Reader *r, const double x[4])
{
	const size_t cap = 2*(r->noffset + 8);
	void *p;

	if (r->noffset == r->capoffset) {
		p = cap <= SIZE_MAX/4/sizeof *r->offset ? realloc(r->offset, cap*sizeof *r->offset) : NULL;
		if (!p)
			return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %zu offsets", cap);
		r->offset = p;
		r->capoffset = cap;
	}
	memcpy(r->offset[r->noffset++], x, sizeof *r->offset);
	return 0;
}

/* Reads the four numbers of an offset from the rest of the line. */
static int
offset(Reader *r)
{
	char show[SCAN_SHOW];
	Token t = { "", 0 };
	double x[4];
	int c;

	for (c = 0; c < 4; c++)
		if (!scan_word(r, &t) || !scan_number(t, &x[c]))
			return mesh_fail(r->s->err, MESH_EFORMAT,
			    "line %ld: offset %zu ends in '%s', need four numbers", r->line, r->noffset, scan_show(t, show));
	return offset_append(r, x);
}

/* Reads the chart of the (u,v) from the rest of the line. */
static int
chart(Reader *r)
{
	char name[SCAN_SHOW];
	Token t = { "", 0 };

	scan_word(r, &t);
	r->s->chart = chart_kind(scan_show(t, name));
	if (!r->s->chart)
		return mesh_fail(r->s->err, MESH_EVALUE, "line %ld: no chart is called '%s'", r->line, name);
	return 0;
}

int
uv_comment(Reader *r)
{
	char show[SCAN_SHOW];
	double T;
	Token t;

	if (!scan_word(r, &t) || !scan_is(t, "lhgrid") || !scan_word(r, &t))
		return 0;
	if (scan_is(t, "fact"))
		return fact_comment(r);
	if (!r->read_uv)
		return 0;
	if (scan_is(t, "offset"))
		return offset(r);
	if (scan_is(t, "chart"))
		return chart(r);
	if (!scan_is(t, "T"))
		return 0;
	scan_word(r, &t);
	if (!scan_number(t, &T) || !(T > 0 && T < HUGE_VAL))
		return mesh_fail(r->s->err, MESH_EVALUE, "line %ld: T '%s' is not a positive number",
		    r->line, scan_show(t, show));
	r->s->T = T;
	return 0;
}

int
uv_start(Reader *r, size_t nv)
{
	Soup *s = r->s;
	size_t i;

	nv = nv > (size_t)s->nv ? nv : (size_t)s->nv;
	r->uv = channel_add(&s->channels, MESH_UV, 2, nv);
	if (!r->uv)
		return mesh_fail(s->err, MESH_ENOMEM, "no memory for the (u,v) of %zu vertices", nv);
	for (i = 0; i < 2*nv; i++)
		r->uv[i] = -1;
	return 0;
}

static int
check_values(const Reader *r)
{
	const size_t nv = (size_t)r->s->nv;
	size_t i;
	int c;

	for (i = 0; i < 2*nv; i++)
		if (!isfinite(r->uv[i]))
			return mesh_fail(r->s->err, MESH_EVALUE, "vertex %zu has a (u,v) that is not finite",
			    i/2);
	if (r->noffset > 0 && r->noffset != nv)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%zu offsets for %zu vertices", r->noffset, nv);
	for (i = 0; i < r->noffset; i++)
		for (c = 0; c < 4; c++)
			if (!isfinite(r->offset[i][c]) || r->offset[i][3] < 0)
				return mesh_fail(r->s->err, MESH_EVALUE,
				    "vertex %zu has an offset that is not finite, or of negative extent", i);
	return 0;
}

int
uv_check(Reader *r)
{
	double *f;
	int e = check_values(r);

	if (!r->s->chart && r->s->T > 0)
		r->s->chart = &CHART_RECTANGLE;
	if (!e && r->noffset > 0) {
		if ((f = channel_add(&r->s->channels, MESH_OFFSET, 4, r->noffset)))
			memcpy(f, r->offset, r->noffset*sizeof *r->offset);
		else
			e = mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %zu offsets", r->noffset);
	}
	return e;
}
