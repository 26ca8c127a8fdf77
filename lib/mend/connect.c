/* connect.c - from triangles to a surface: vertices at one place are welded, neighbours found, fans
 * parted. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../base/vec3.h"
#include "../mesh/fail.h"
#include "join.h"
#include "step.h"
#include "weld.h"

#define AUTO 1e-6               /* of the diagonal: a few rounding errors of coordinates stored as floats */
#define NEAR 1e-3               /* of the diagonal: the largest distance reported as MendReport.nearest */

/* Sets the bounding box; returns its diagonal. */
static double
measure_box(const Sheet *s, MendReport *r)
{
	double d[3];
	int i, c;

	for (i = 0; i < 3*s->nf; i++)
		for (c = 0; c < 3; c++) {
			const double x = sheet_at(s, s->tri[i])[c];

			r->lo[c] = i ? fmin(r->lo[c], x) : x;
			r->hi[c] = i ? fmax(r->hi[c], x) : x;
		}
	sub3(r->hi, r->lo, d);
	return norm3(d);
}

/* Welds the boundary; sets was to the corners before, or leaves it NULL if nothing was welded. */
static int
weld(Sheet *s, const MendOptions *o, MendReport *r, int **was)
{
	const double diagonal = measure_box(s, r);
	int *to = mesh_alloc(s->err, (size_t)s->nv, sizeof *to), e, i;
	const size_t n = 3*(size_t)s->nf;

	r->within = AUTO*diagonal;
	r->weld = o->weld == MEND_WELD_AUTO ? r->within : o->weld == MEND_WELD_NONE ? 0 : o->weld;
	e = to ? weld_boundary(s, 0, to) : MESH_ENOMEM;
	r->coincident = e;
	if (e >= 0 && (e = weld_boundary(s, r->within, to)) >= 0)
		r->close = e - r->coincident;
	if (e >= 0 && o->check && diagonal > 0 && weld_nearest(s, 0, NEAR*diagonal, &r->nearest))
		e = MESH_ENOMEM;
	if (e >= 0)
		e = weld_boundary(s, r->weld, to);
	if (e > 0 && o->weld != MEND_WELD_NONE) {
		if ((*was = mesh_alloc(s->err, n, sizeof **was)) != NULL)
			memcpy(*was, s->tri, n*sizeof **was);
		else
			e = MESH_ENOMEM;
		for (i = 0; e > 0 && i < 3*s->nf; i++)
			s->tri[i] = to[s->tri[i]];
	}
	free(to);
	return e < 0 ? e : 0;
}

/* Drops the faces that lost a corner by welding. */
static int
drop_collapsed(Sheet *s, int *was, MendReport *r)
{
	unsigned char *keep = mesh_alloc(s->err, (size_t)s->nf, 1);
	int f, n = 0, e = keep ? 0 : MESH_ENOMEM;

	for (f = 0; !e && f < s->nf; f++) {
		const int *t = s->tri + 3*(size_t)f;

		keep[f] = t[0] != t[1] && t[1] != t[2] && t[2] != t[0];
		r->collapsed += !keep[f];
		if (keep[f])
			memmove(was + 3*(size_t)n++, was + 3*(size_t)f, 3*sizeof *was);
	}
	if (!e && n < s->nf)
		e = sheet_keep(s, keep);
	free(keep);
	return e;
}

/* Drops the marked faces.  Returns their number, or MESH_ENOMEM. */
static int
drop_marked(Sheet *s, const unsigned char *flap)
{
	unsigned char *keep = mesh_alloc(s->err, (size_t)s->nf, 1);
	int f, n = 0, e = MESH_ENOMEM;

	if (keep) {
		for (f = 0; f < s->nf; f++)
			n += !(keep[f] = !flap[f]);
		e = sheet_keep(s, keep);
	}
	free(keep);
	return e ? e : n;
}

/* Two fans that share an edge of more than two faces, and both ends of it, cannot be parted.  So drops,
 * at each such edge, the faces beyond the first pair (sheet_join), and parts the fans again. */
static int
drop_flaps(Sheet *s, MendReport *r)
{
	int many = 1, at[2], merged, split, e = 0;

	while (!e && many) {
		unsigned char *flap = mesh_alloc(s->err, (size_t)s->nf, 1);

		e = flap ? sheet_join(s, &many, at, flap) : MESH_ENOMEM;
		if (!e && many && (e = drop_marked(s, flap)) >= 0) {
			r->flaps += e;
			if ((e = sheet_join(s, &many, at, NULL)) == 0 &&
			    (e = sheet_part(s, NULL, &merged, &split)) == 0)
				many = 1;
		}
		free(flap);
	}
	return e;
}

int
mend_connect(Sheet *s, const MendOptions *o, MendReport *r)
{
	int *was = NULL, e;

	if ((e = weld(s, o, r, &was)) == 0 && was)
		e = drop_collapsed(s, was, r);
	if (!e && (e = sheet_join(s, &r->many, r->many_at, NULL)) == 0)
		e = sheet_part(s, was, &r->welded, &r->parted);
	if (!e && r->many)
		e = drop_flaps(s, r);
	free(was);
	return e;
}
