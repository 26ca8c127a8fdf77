/* mesh.c - the checks of all fuzz targets of the mesh readers. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/meshfile/meshfile.h"
#include "fuzz.h"

static const size_t MOST = (size_t)1 << 32;      /* largest size that gzip data may unpack to */

size_t
fuzz_meshbound(size_t n)
{
	return 16*n + 1024;
}

/* A refusal needs a message of one printable line. */
static void
refused(const Soup *s)
{
	const char *p;

	fuzz_need(!s->xyz && !s->first && !s->idx && !s->channels.n && !s->facts && !s->left_out,
	    "a refused mesh has something to free");
	fuzz_need(s->err[0] != '\0', "a refusal without a message");
	for (p = s->err; *p; p++)
		fuzz_need(*p >= 0x20 && *p < 0x7f, "a message is not one printable line");
}

static void
valid(const Soup *s, int loose)
{
	const double *uv = channel_values(&s->channels, MESH_UV);
	const double *o = channel_values(&s->channels, MESH_OFFSET);
	const double *source = channel_values(&s->channels, MESH_SOURCE);
	size_t i;
	int f;

	fuzz_need(s->nv >= 0 && s->nf >= 0 && s->xyz && s->first && s->idx, "an array is missing");
	fuzz_need(s->first[0] == 0, "faces do not begin at corner 0");
	for (f = 0; f < s->nf; f++)
		fuzz_need(s->first[f] <= s->first[f+1], "a face has a negative number of corners");
	for (i = 0; i < (size_t)s->first[s->nf] && !loose; i++)
		fuzz_need(s->idx[i] >= 0 && s->idx[i] < s->nv, "a corner is no vertex");
	for (i = 0; i < 3*(size_t)s->nv && !loose; i++)
		fuzz_need(isfinite(s->xyz[i]), "a coordinate is not finite");
	for (i = 0; uv && i < 2*(size_t)s->nv; i++)
		fuzz_need(isfinite(uv[i]), "a (u,v) is not finite");
	for (i = 0; o && i < 4*(size_t)s->nv; i++)
		fuzz_need(isfinite(o[i]) && (i%4 < 3 || o[i] >= 0), "an offset is not finite");
	for (i = 0; source && i < (size_t)s->nv; i++)
		fuzz_need(source[i] >= -1 && source[i] == floor(source[i]), "a source is no number of a vertex");
	for (f = 0; s->filled && f < s->nf; f++)
		fuzz_need(s->filled[f] <= 1, "a face is neither filled nor not");
	fuzz_need(s->T >= 0 && isfinite(s->T), "T is neither 0 nor positive");
}

/* Whether the arrays a and b of `bytes` bytes are equal bit by bit, so that -0 differs from 0.  They
 * may be NULL if `bytes` is 0. */
static int
samebits(const void *a, const void *b, size_t bytes)
{
	return bytes == 0 || memcmp(a, b, bytes) == 0;
}

/* Whether the n numbers of b are those of a, bit by bit, or rounded to floats. */
static int
samenumbers(const double *a, const double *b, size_t n, int single)
{
	size_t i;

	if (!single)
		return samebits(a, b, n*sizeof *a);
	for (i = 0; i < n; i++)
		if (b[i] != (double)(float)a[i])
			return 0;
	return 1;
}

/* x as a file stores it as that type. */
static double
stored(ChannelType type, double x)
{
	return type == CHANNEL_FLOAT ? (double)(float)x : x;
}

/* Checks that b has the channels of a, with their types.  The file is a PLY, and names are those of a PLY. */
static void
samefields(const Soup *a, const Soup *b)
{
	const Channel *c, *d;
	double x;
	int i, k;

	for (k = 0; k < a->channels.n; k++) {
		c = &a->channels.channel[k];
		if (strcmp(c->name, MESH_SOURCE) == 0)
			continue;
		d = channel_find(&b->channels, c->name);
		fuzz_need(d && d->n == c->n && d->type == c->type, "a channel does not come back");
		for (i = 0; i < a->nv; i++) {
			x = stored(c->type, c->f[i]);
			fuzz_need(channel_holds(c->type, x), "a channel has a type that cannot hold its numbers");
			fuzz_need(d->f[i] == x || (isnan(x) && isnan(d->f[i])), "numbers of a channel do not come back");
		}
	}
}

/* Checks that b equals a, after a was written in this format and read again as b.  The (u,v) are compared at
 * the corners of faces only, since OBJ stores none for a vertex that belongs to no face; facts if the format
 * has comments for them. */
static void
same(const Soup *a, const Soup *b, const MeshFormat *format, unsigned what)
{
	const int comments = (format->can & MESHFORMAT_UV) != 0, single = (format->can & MESHFORMAT_SINGLE) != 0;
	const double *u = channel_values(&a->channels, MESH_UV), *v = channel_values(&b->channels, MESH_UV);
	const double *o = channel_values(&a->channels, MESH_OFFSET);
	const double *p = channel_values(&b->channels, MESH_OFFSET);
	size_t nv = (size_t)a->nv, nf = (size_t)a->nf, i;

	fuzz_need(a->nv == b->nv && a->nf == b->nf, "a mesh comes back with other counts");
	fuzz_need(samenumbers(a->xyz, b->xyz, 3*nv, single), "coordinates do not come back");
	fuzz_need(samebits(a->first, b->first, (nf + 1)*sizeof(int)), "numbers of corners do not come back");
	fuzz_need(samebits(a->idx, b->idx, (size_t)a->first[nf]*sizeof(int)), "corners do not come back");
	fuzz_need(!comments || strcmp(a->facts ? a->facts : "", b->facts ? b->facts : "") == 0, "facts do not come back");
	fuzz_need(!u == !v && a->T == b->T, "T does not come back");
	for (i = 0; u && i < (size_t)a->first[nf]; i++)
		fuzz_need(samebits(u + 2*(size_t)a->idx[i], v + 2*(size_t)a->idx[i], 2*sizeof(double)),
		    "(u,v) do not come back");
	fuzz_need(!o == !p && (!o || samebits(o, p, 4*nv*sizeof(double))), "offsets do not come back");
	if (strcmp(format->name, "PLY") == 0 && (what & MESHFILE_FIELDS))
		samefields(a, b);
}

/* Checks that s is the same after it was written in this format and read again. */
static void
comesback(const Soup *s, const MeshFormat *format, unsigned what)
{
	Soup again;
	size_t n;
	char *p;
	int e;

	e = meshfile_write(s, format, &p, &n);
	if ((format->can & MESHFORMAT_SINGLE) && (e == MESH_EVALUE || e == MESH_EFACE))
		return;                 /* beyond the range of a float, or a polygon */
	fuzz_need(e == 0, "an accepted mesh cannot be written");
	e = meshfile_parse_as(&again, p, n, &(MeshParse){ .most = MOST, .what = what });
	free(p);
	fuzz_need(e == 0 || s->nv == 0, "what was written is refused");
	if (e)
		return;                 /* some formats need at least one vertex */
	same(s, &again, format, what);
	soup_free(&again);
}

/* The same for a format without shared vertices (STL): each triangle then has three vertices of its
 * own, rounded to float. */
static void
apart(const Soup *s, const MeshFormat *format)
{
	Soup again;
	size_t i, n;
	char *p;
	int e, c;

	e = meshfile_write(s, format, &p, &n);
	if (e == MESH_EVALUE || e == MESH_EFACE)
		return;                 /* beyond the range of a float, or a polygon */
	fuzz_need(e == 0, "an accepted mesh cannot be written");
	fuzz_need(meshfile_parse(&again, p, n, MOST) == 0, "what was written is refused");
	free(p);
	fuzz_need(again.nf == s->nf && again.nv == 3*s->nf, "triangles come back with other counts");
	for (i = 0; i < (size_t)again.nv; i++)
		for (c = 0; c < 3; c++)
			fuzz_need(again.xyz[3*i + (size_t)c] == (double)(float)s->xyz[3*s->idx[i] + c],
			    "triangles come back with other corners");
	soup_free(&again);
}

/* Checks writing in format i (modulo their number), or in the next one that can be written and, if s
 * has (u,v), stores them. */
static void
written(const Soup *s, size_t i, unsigned what)
{
	const unsigned can = MESHFORMAT_WRITE | (channel_find(&s->channels, MESH_UV) ? MESHFORMAT_UV : 0);
	const MeshFormat *f;
	size_t rows = 0;

	while (meshformat((int)rows))
		rows++;
	while (f = meshformat((int)(i % rows)), (f->can & can) != can)
		i++;
	if (f->can & MESHFORMAT_SHARED)
		comesback(s, f, what);
	else
		apart(s, f);
}

static size_t left_beside;     /* bytes that may still be read of files beside the mesh */

/* Files beside the mesh: 500 bytes, of which numbers of vertices and coordinates can be made. */
static int
beside(const void *arg, const char *name, unsigned long long from, size_t want, char **bytes, size_t *n,
	char err[MESH_ERRLEN])
{
	enum { SIZE = 500 };
	const size_t left = from < SIZE ? SIZE - (size_t)from : 0;
	size_t i;

	(void)arg;
	fuzz_need(*name && *name != '/' && !strstr(name, "/../") && strncmp(name, "../", 3) != 0, "a name leaves the folder");
	if (*name == 'n' || want > left_beside) {
		snprintf(err, MESH_ERRLEN, "not there");
		return MESH_EFORMAT;
	}
	*n = want < left ? want : left;
	left_beside -= *n;
	*bytes = malloc(*n + 1);
	for (i = 0; i < *n; i++)
		(*bytes)[i] = (from + i)%4 ? 0 : (char)((from + i)%28/4);
	return 0;
}

const MeshBeside *
fuzz_beside(void)
{
	static const MeshBeside files = { beside, NULL };

	left_beside = FUZZ_BESIDE;
	return &files;
}

static void
one(unsigned what, const uint8_t *data, size_t n, size_t most)
{
	const size_t before = fuzz_live();
	Soup s;
	int e;

	fuzz_mark();
	most += 16*FUZZ_BESIDE;
	e = meshfile_parse_as(&s, data, n, &(MeshParse){ MOST, what, fuzz_beside() });
	if (fuzz_peak() - before > most)
		fprintf(stderr, "fuzz: %zu bytes for %zu, not %zu\n", fuzz_peak() - before, n, most);
	fuzz_need(fuzz_peak() - before <= most, "too much memory");
	if (e) {
		refused(&s);
	} else {
		valid(&s, what & MESHFILE_LOOSE);
		if (!(what & MESHFILE_LOOSE))
			written(&s, n, what);
		soup_free(&s);
	}
	fuzz_need(fuzz_live() == before, "memory is lost");
}

void
fuzz_mesh(const uint8_t *data, size_t n, size_t most)
{
	static const unsigned what[4] = { 0, MESHFILE_FIELDS, 0, MESHFILE_LOOSE | MESHFILE_FIELDS | MESHFILE_NORMALS };

	one(what[n % 4], data, n, most);
}

void
fuzz_mesh_uv(const uint8_t *data, size_t n, size_t most)
{
	fuzz_mesh(data, n, most);
	one(MESHFILE_UV, data, n, most);
}

void
fuzz_mesh_from(const char *magic, size_t nmagic, const uint8_t *data, size_t n)
{
	uint8_t *p;

	if (n < nmagic)
		return;
	p = malloc(n);
	memcpy(p, data, n);
	memcpy(p, magic, nmagic);
	fuzz_mesh(p, n, fuzz_meshbound(n));
	free(p);
}

void
fuzz_xml(const char *root, const uint8_t *data, size_t n)
{
	const size_t unpacked = 3*(1100*n + 4096);

	if (n > 5 && memcmp(data, "<?xml", 5) == 0)
		fuzz_mesh(data, n, fuzz_meshbound(n + unpacked));
	else
		fuzz_mesh_from(root, strlen(root), data, n);
}
