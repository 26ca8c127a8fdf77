/* uvread.c - reading the (u,v) of a mesh file. */
#include <math.h>

#include "../mesh/channel.h"
#include "meshpriv.h"

int
uv_modulus(Reader *r)
{
	char show[SCAN_SHOW];
	double T;
	Token t;

	if (!scan_word(r, &t) || !scan_is(t, "lhgrid") || !scan_word(r, &t) || !scan_is(t, "T"))
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

int
uv_check(const Reader *r)
{
	size_t i;

	for (i = 0; i < 2*(size_t)r->s->nv; i++)
		if (!isfinite(r->uv[i]))
			return mesh_fail(r->s->err, MESH_EVALUE, "vertex %zu has a (u,v) that is not finite",
			    i/2);
	return 0;
}
