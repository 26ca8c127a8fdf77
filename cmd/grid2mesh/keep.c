/* keep.c - the user's own file with its vertices moved, for grid2mesh. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/nearpoints.h"
#include "../../lib/meshfile/meshfile.h"
#include "../../lib/meshfile/rewrite.h"
#include "../shared/claim.h"
#include "../shared/load.h"
#include "keep.h"

static const double WELDED = 1e-6;      /* mesh2disk --weld=auto, in diagonals of the bounding box */

/* The vertices of the kept file. */
typedef struct Kept {
	int           nv;
	const double *old;              /* [nv][3] */
	double       *to;               /* [nv][3] where each goes */
	int          *copies;           /* [nv] vertices of the mesh that each has become */
	double       *distance;         /* [nv] and index of the vertex with which one without copies moves */
	int          *with;             /* [nv] -1: none */
} Kept;

/* Sums up the copies of each vertex. */
static void
add_copies(Kept *k, const Soup *s, const double *source)
{
	int p, c, v;

	for (p = 0; p < s->nv; p++) {
		if ((v = (int)source[p]) < 0)
			continue;
		for (c = 0; c < 3 && !k->copies[v]; c++)
			k->to[3*(size_t)v+c] = 0;
		for (c = 0; c < 3; c++)
			k->to[3*(size_t)v+c] += s->xyz[3*(size_t)p+c];
		k->copies[v]++;
	}
	for (v = 0; v < k->nv; v++)
		for (c = 0; c < 3 && k->copies[v]; c++)
			k->to[3*(size_t)v+c] /= k->copies[v];
}

static void
join(Kept *k, int v, int w, double distance)
{
	if (k->copies[v] || !k->copies[w] || distance > k->distance[v] ||
	    (distance == k->distance[v] && k->with[v] >= 0 && w > k->with[v]))
		return;
	k->distance[v] = distance;
	k->with[v] = w;
}

static void
meet(int v, int w, double distance, void *kept)
{
	join(kept, v, w, distance);
	join(kept, w, v, distance);
}

static double
diagonal(int nv, const double *xyz)
{
	double lo, hi, sum = 0;
	int c, p;

	for (c = 0; c < 3; c++) {
		for (lo = INFINITY, hi = -INFINITY, p = 0; p < nv; p++) {
			lo = fmin(lo, xyz[3*(size_t)p+c]);
			hi = fmax(hi, xyz[3*(size_t)p+c]);
		}
		sum += (hi - lo)*(hi - lo);
	}
	return sqrt(sum);
}

/* Moves the vertices without copies as the nearest that has some, if it is near enough to have been welded.  Returns
 * how many stay. */
static int
move_welded(Kept *k)
{
	int *list = cmd_alloc((size_t)k->nv, sizeof *list), v, c, stay = 0;

	for (v = 0; v < k->nv; v++)
		list[v] = v;
	if (nearpoints(k->old, list, k->nv, WELDED*diagonal(k->nv, k->old), meet, k))
		die("no memory to compare %d vertices", k->nv);
	for (v = 0; v < k->nv; v++) {
		for (c = 0; c < 3 && k->with[v] >= 0; c++)
			k->to[3*(size_t)v+c] += k->to[3*(size_t)k->with[v]+c] - k->old[3*(size_t)k->with[v]+c];
		stay += !k->copies[v] && k->with[v] < 0;
	}
	free(list);
	return stay;
}

/* The numbers in the file with vertices o that the vertices of s had, by MESH_SOURCE; NULL if they are the same vertices:
 * s has no such channel, or o is that file of mesh2disk itself. */
static const double *
source_in(const Soup *o, const Soup *s)
{
	return o->nv == s->nv && channel_find(&o->channels, MESH_SOURCE) ? NULL :
	    channel_source(&s->channels, s->nv, o->nv);
}

/* The vertices o of the file `keep`, and where they go with s, the file `mesh` that was made from it.  what: the others do
 * this. */
static Kept
match(const char *keep, const Soup *o, const char *mesh, const Soup *s, const double *source, const char *what)
{
	const size_t nv = (size_t)o->nv;
	Kept k = { o->nv, o->xyz, cmd_alloc(nv, 3*sizeof(double)), cmd_alloc(nv, sizeof(int)), cmd_alloc(nv, sizeof(double)),
		cmd_alloc(nv, sizeof(int)) };
	int v, stay;

	memcpy(k.to, o->xyz, 3*nv*sizeof *k.to);
	for (v = 0; v < o->nv; v++) {
		k.copies[v] = 0;
		k.distance[v] = INFINITY;
		k.with[v] = -1;
	}
	add_copies(&k, s, source);
	stay = move_welded(&k);
	if (stay)
		note("%s: %d of %d vertices are not in %s and %s", keep, stay, o->nv, mesh, what);
	return k;
}

static void
kept_free(Kept *k)
{
	free(k->to);
	free(k->copies);
	free(k->distance);
	free(k->with);
}

/* Sets `to` to the numbers `from` at nv vertices of the mesh: the mean of copies, NaN where there is none. */
static void
numbers(const Kept *k, int nv, const double *source, const double *from, double *to)
{
	int p, v;

	memset(to, 0, (size_t)k->nv*sizeof *to);
	for (p = 0; p < nv; p++)
		if (source[p] >= 0)
			to[(int)source[p]] += from[p];
	for (v = 0; v < k->nv; v++)
		to[v] = k->copies[v] ? to[v]/k->copies[v] : NAN;
	for (v = 0; v < k->nv; v++)
		if (!k->copies[v] && k->with[v] >= 0)
			to[v] = to[k->with[v]];
}

void
keep_field_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const char *keep, const Fields *fields,
	const FieldFormat *format, char **bytes, size_t *n)
{
	const double *source;
	Channels c = { 0 }, to = { 0 };
	double *f;
	Soup o;
	Kept k;
	int i;

	load_soup(keep, MESHFILE_LOOSE, &o);
	source = source_in(&o, &on->s);
	if (!source && o.nv != on->s.nv)
		die("%s: %d vertices, %s has %d, and no numbers of them (source)", keep, o.nv, on->name, on->s.nv);
	if (!source) {
		gridfile_field_bytes(in, g, on, fields, format, bytes, n);
		soup_free(&o);
		return;
	}
	gridfile_fields(in, g, on, fields, format, &c);
	k = match(keep, &o, on->name, &on->s, source, "get NaN");
	for (i = 0; i < c.n; i++) {
		if (!(f = channel_add(&to, c.channel[i].name, 1, (size_t)o.nv)))
			die("%s: no memory for the numbers of %d vertices", keep, o.nv);
		numbers(&k, on->s.nv, source, c.channel[i].f, f);
	}
	if (fieldfile_write(&to, o.nv, o.nf, format, bytes, n))
		die("%s: no memory for %d vertices", keep, o.nv);
	channels_free(&c);
	channels_free(&to);
	kept_free(&k);
	soup_free(&o);
}

void
keep_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const char *keep, const MeshFormat *format, char **bytes,
	size_t *n)
{
	const Fields none = { NULL, 0 };
	char err[MESH_ERRLEN], *file;
	const double *source;
	double *xyz;
	Kept k = { 0 };
	size_t size;
	Soup s, o;
	int nv;

	file = cmd_slurp(keep, &size);
	if ((size > 3 && memcmp(file, "ply", 3) == 0) != (strcmp(format->name, "PLY") == 0))
		die("%s is no %s: the output needs the ending of the file that is kept", keep, format->name);
	load_bytes(keep, file, size, MESHFILE_LOOSE, &o);
	gridfile_soup(in, g, on, &none, 0, format->name, &s);
	nv = s.nv;
	xyz = s.xyz;
	if ((source = source_in(&o, &s))) {
		k = match(keep, &o, on->name, &s, source, "stay where they are");
		xyz = k.to;
		nv = o.nv;
	}
	if (rewrite(file, size, nv, xyz, bytes, n, err))
		die("%s: %s", keep, err);
	gridfile_soup_free(on, &s);
	soup_free(&o);
	kept_free(&k);
	free(file);
}
