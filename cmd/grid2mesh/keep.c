/* keep.c - the user's own file with its vertices moved, for grid2mesh. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/nearpoints.h"
#include "../../lib/meshfile/meshfile.h"
#include "../../lib/meshfile/rewrite.h"
#include "../shared/claim.h"
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

/* The places of the vertices of the file `keep`, whose vertices are o, with s made from it, the file `mesh`; malloc'd. */
static double *
places_in_file(const char *keep, const Soup *o, const char *mesh, const Soup *s, const double *source)
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
		note("%s: %d of %d vertices are not in %s and stay where they are", keep, stay, o->nv, mesh);
	free(k.copies);
	free(k.distance);
	free(k.with);
	return k.to;
}

void
keep_bytes(const CmdInput *in, const Lhg *g, const OnMesh *on, const char *keep, const MeshFormat *format, char **bytes,
	size_t *n)
{
	const Fields none = { NULL, 0 };
	char err[MESH_ERRLEN], *file;
	const double *source;
	double *xyz, *moved = NULL;
	size_t size;
	Soup s, o;
	int nv;

	file = cmd_slurp(keep, &size);
	if ((size > 3 && memcmp(file, "ply", 3) == 0) != (strcmp(format->name, "PLY") == 0))
		die("%s is no %s: the output needs the ending of the file that is kept", keep, format->name);
	if (meshfile_parse_loose(&o, file, size, claim_input()))
		die("%s: %s", keep, o.err);
	gridfile_soup(in, g, on, &none, 0, format->name, &s);
	nv = s.nv;
	xyz = s.xyz;
	if (o.nv != s.nv && (source = channel_source(&s.channels, s.nv, o.nv))) {
		xyz = moved = places_in_file(keep, &o, on->name, &s, source);
		nv = o.nv;
	}
	if (rewrite(file, size, nv, xyz, bytes, n, err))
		die("%s: %s", keep, err);
	gridfile_soup_free(on, &s);
	soup_free(&o);
	free(moved);
	free(file);
}
