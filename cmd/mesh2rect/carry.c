/* carry.c - numbers of a file to the vertices of a mesh, or of one that was made from it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/spread.h"
#include "../shared/cmd.h"
#include "carry.h"

void
carry_numbers(const Soup *s, const double *source, const double *from, double *to)
{
	unsigned char *known;
	Spread a;
	int p;

	if (!source) {
		memcpy(to, from, (size_t)s->nv*sizeof *to);
		return;
	}
	known = cmd_alloc((size_t)s->nv, 1);
	for (p = 0; p < s->nv; p++) {
		known[p] = source[p] >= 0;
		to[p] = known[p] ? from[(int)source[p]] : 0;
	}
	if (spread_init(&a, s, known))
		die("no memory for numbers at %d vertices", s->nv);
	spread_mean(&a, 1, to);
	spread_free(&a);
	free(known);
}

static double
distance(const double *x, const double *y)
{
	return sqrt((x[0] - y[0])*(x[0] - y[0]) + (x[1] - y[1])*(x[1] - y[1]) + (x[2] - y[2])*(x[2] - y[2]));
}

/* Whether a file of as many numbers as s has vertices, all of `source` below them, is of s itself rather than of the
 * file that mesh2disk made s from: by the places of its vertices, or else the number of its faces.  Where nothing tells
 * them apart it is taken for that file's, which is what people have numbers of, with a note. */
static int
is_own(const char *path, const FieldFile *f, const Soup *s, const double *source)
{
	double own = 0, other = 0;
	int p, moved = 0;

	for (p = 0; p < s->nv; p++)
		if (source[p] >= 0 && source[p] != p) {
			moved = 1;
			if (f->xyz) {
				own += distance(s->xyz + 3*(size_t)p, f->xyz + 3*(size_t)p);
				other += distance(s->xyz + 3*(size_t)p, f->xyz + 3*(size_t)source[p]);
			}
		}
	if (!moved || f->xyz)
		return !moved || own < other;
	if (f->nf > 0)
		return f->nf == s->nf;
	note("%s: %d numbers fit the mesh and what mesh2disk made it of: taken as those of the latter (in a PLY, the vertices "
	    "tell)", path, f->nv);
	return 0;
}

const double *
carry_source(const char *path, const FieldFile *f, const Soup *s)
{
	const double *source = channel_source(&s->channels, s->nv, f->nv);

	if (!source && f->nv != s->nv)
		die("%s: %d numbers, the mesh has %d vertices", path, f->nv, s->nv);
	return source && f->nv == s->nv && is_own(path, f, s, source) ? NULL : source;
}
