/* gltf.c - glTF 2: .gltf (JSON with its data inside or in files beside it) and .glb.  The triangles of all meshes of the scene.
 *
 * The JSON and the geometry are read here, not by a library such as tinygltf: that is C++, opens files of its
 * own accord, decodes images, and takes memory by the counts that a file announces. */
#include <stdlib.h>
#include <string.h>

#include "gltfpriv.h"

static int
is_glb(const char *p, size_t n)
{
	return n >= 4 && memcmp(p, "glTF", 4) == 0;
}

int
gltf_recognise(const MeshStart *m)
{
	if (is_glb(m->p, m->n))
		return MESHSTART_SURE;
	return m->word.n > 0 && *m->word.s == '{' ? MESHSTART_MAYBE : MESHSTART_NO;
}

/* Finds the chunks of a .glb: the JSON text, then perhaps the binary one. */
static int
chunks(Gltf *g, const char **json, const char **end)
{
	enum { HEAD = 12, CHUNK = 8, JSON = 0x4e4f534a, BIN = 0x004e4942 };
	const char *p = g->r->p;
	const size_t n = g->size;
	unsigned long long size;

	if (n < HEAD + CHUNK)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "file ends in the header");
	if (scan_bytes(p + 4, 4, 0) != 2)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "glTF of version %llu is not read, only 2", scan_bytes(p + 4, 4, 0));
	if (scan_bytes(p + 8, 4, 0) != n)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "header announces %llu bytes, file has %zu", scan_bytes(p + 8, 4, 0), n);
	size = scan_bytes(p + HEAD, 4, 0);
	if (scan_bytes(p + HEAD + 4, 4, 0) != JSON || size > n - HEAD - CHUNK)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "the first chunk is no JSON, or file ends in it");
	*json = p + HEAD + CHUNK;
	*end = p = *json + size;
	if (g->r->end - p < CHUNK || scan_bytes(p + 4, 4, 0) != BIN)
		return 0;
	size = scan_bytes(p, 4, 0);
	if (size > (size_t)(g->r->end - p) - CHUNK)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "file ends in the binary chunk of %llu bytes", size);
	g->bin = p + CHUNK;
	g->nbin = (size_t)size;
	return 0;
}

/* Lists the items of the arrays in the root. */
static int
lists(Gltf *g)
{
	static const char *const name[GLTF_LISTS] = { "buffers", "bufferViews", "accessors", "meshes", "nodes", "scenes" };
	const Json *j = &g->j;
	long long array, v;
	GltfList *l;
	int k;

	for (k = 0; k < GLTF_LISTS; k++) {
		l = &g->list[k];
		l->name = name[k];
		array = json_get(j, 0, name[k]);
		for (v = json_first(j, array); v >= 0; v = json_next(j, array, v))
			l->n++;
		if (!(l->item = mesh_alloc(g->r->s->err, l->n, sizeof *l->item)))
			return MESH_ENOMEM;
		l->n = 0;
		for (v = json_first(j, array); v >= 0; v = json_next(j, array, v))
			l->item[l->n++] = (uint32_t)v;
	}
	if (!(g->seen = mesh_alloc(g->r->s->err, g->list[GLTF_NODES].n, 1)) ||
	    !(g->buffer = mesh_alloc(g->r->s->err, g->list[GLTF_BUFFERS].n, sizeof *g->buffer)))
		return MESH_ENOMEM;
	if (g->list[GLTF_BUFFERS].n)
		memset(g->buffer, 0, g->list[GLTF_BUFFERS].n*sizeof *g->buffer);
	return 0;
}

/* Refuses other versions, and required extensions that hide the geometry. */
static int
check(Gltf *g)
{
	static const struct { const char *name, *what; } HIDES[] = {
		{ "KHR_draco_mesh_compression", "DRACO compressed" }, { "EXT_meshopt_compression", "meshopt compressed" },
		{ "EXT_mesh_gpu_instancing", "GPU-instanced" }
	};
	const Token version = json_text(&g->j, json_get(&g->j, json_get(&g->j, 0, "asset"), "version"));
	const long long list = json_get(&g->j, 0, "extensionsRequired");
	char show[SCAN_SHOW];
	long long v;
	size_t k;

	if (version.n < 1)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "JSON without an asset with a version: no glTF");
	if (*version.s != '2')
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "glTF of version %s is not read, only 2", scan_show(version, show));
	for (v = json_first(&g->j, list); v >= 0; v = json_next(&g->j, list, v))
		for (k = 0; k < sizeof HIDES/sizeof *HIDES; k++)
			if (scan_is(json_text(&g->j, v), HIDES[k].name))
				return mesh_fail(g->r->s->err, MESH_EFORMAT, "%s meshes are not read", HIDES[k].what);
	return 0;
}

static int
geometry(Gltf *g)
{
	int e;

	g->counting = 1;
	if ((e = check(g)) != 0 || (e = lists(g)) != 0 || (e = gltf_scene(g)) != 0)
		return e;
	g->counting = 0;
	if ((e = soup_reserve(g->r, g->nv, g->nf, g->ni)) != 0 || (e = gltf_scene(g)) != 0)
		return e;
	soup_trim(g->r);
	if ((e = fact_add(g->r, "source", (Token){ "glTF", 4 })) != 0)
		return e;
	return fact_add(g->r, "unit", (Token){ "m", 1 });
}

int
gltf_read(Reader *r)
{
	Gltf g = { .r = r, .size = scan_left(r) };
	const char *json = r->p, *end = r->end;
	uint32_t k;
	int e;

	if (is_glb(r->p, g.size) && (e = chunks(&g, &json, &end)) != 0)
		return e;
	if ((e = json_read(&g.j, r, json, end)) != 0)
		return e;
	e = geometry(&g);
	for (k = 0; g.buffer && k < g.list[GLTF_BUFFERS].n; k++)
		free(g.buffer[k].own);
	for (k = 0; k < GLTF_LISTS; k++)
		free(g.list[k].item);
	free(g.buffer);
	free(g.seen);
	free(g.j.value);
	return e;
}
