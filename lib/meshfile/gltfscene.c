/* gltfscene.c - the nodes of a glTF scene, and the triangles of its meshes. */
#include <string.h>

#include "gltfpriv.h"

/* x -> A x + t. */
typedef struct Place {
	double A[3][3], t[3];
	int moved;              /* it is not the identity */
} Place;

enum { DEEPEST = 200 };         /* nodes inside each other */

/* The n numbers of an array; leaves x as it is if there are fewer.  Whether they were read. */
static int
numbers(const Json *j, long long v, int n, double *x)
{
	double y[16];
	long long k;
	int i = 0;

	for (k = json_first(j, v); k >= 0 && i < n; k = json_next(j, v, k))
		y[i++] = json_number(j, k, 0);
	if (i < n)
		return 0;
	memcpy(x, y, (size_t)n*sizeof *x);
	return 1;
}

/* A = R S, from the unit quaternion q = (x, y, z, w) and the scales s. */
static void
rotate_scale(const double q[4], const double s[3], double A[3][3])
{
	const double x = q[0], y = q[1], z = q[2], w = q[3];
	const double R[3][3] = {
		{ 1 - 2*(y*y + z*z), 2*(x*y - z*w), 2*(x*z + y*w) },
		{ 2*(x*y + z*w), 1 - 2*(x*x + z*z), 2*(y*z - x*w) },
		{ 2*(x*z - y*w), 2*(y*z + x*w), 1 - 2*(x*x + y*y) }
	};
	int i, k;

	for (i = 0; i < 3; i++)
		for (k = 0; k < 3; k++)
			A[i][k] = R[i][k]*s[k];
}

/* The transform of a node: a matrix, by columns, or T R S. */
static Place
local(const Json *j, long long node)
{
	Place p = { .moved = 0 };
	double m[16], q[4] = { 0, 0, 0, 1 }, s[3] = { 1, 1, 1 };
	int i, k;

	if (numbers(j, json_get(j, node, "matrix"), 16, m)) {
		for (i = 0; i < 3; i++)
			for (p.t[i] = m[12 + i], k = 0; k < 3; k++)
				p.A[i][k] = m[4*k + i];
		p.moved = 1;
		return p;
	}
	p.moved = numbers(j, json_get(j, node, "rotation"), 4, q) + numbers(j, json_get(j, node, "scale"), 3, s) +
	    numbers(j, json_get(j, node, "translation"), 3, p.t) > 0;
	rotate_scale(q, s, p.A);
	return p;
}

/* First q, then p. */
static Place
after(const Place *p, const Place *q)
{
	Place r = { .moved = p->moved || q->moved };
	int i, k, c;

	if (!p->moved)
		return *q;
	for (i = 0; i < 3; i++) {
		for (r.t[i] = p->t[i], c = 0; c < 3; c++)
			r.t[i] += p->A[i][c]*q->t[c];
		for (k = 0; k < 3; k++)
			for (c = 0; c < 3; c++)
				r.A[i][k] += p->A[i][c]*q->A[c][k];
	}
	return r;
}

/* Whether the transform is a reflection: then the triangles turn round. */
static int
reflects(const Place *p)
{
	const double (*A)[3] = p->A;

	return p->moved && A[0][0]*(A[1][1]*A[2][2] - A[1][2]*A[2][1]) - A[0][1]*(A[1][0]*A[2][2] - A[1][2]*A[2][0]) +
	    A[0][2]*(A[1][0]*A[2][1] - A[1][1]*A[2][0]) < 0;
}

static int
vertices(Gltf *g, const GltfArray *a, const Place *p)
{
	double x[3], y[3];
	size_t i;
	int c, e;

	for (i = 0; i < a->count; i++) {
		for (c = 0; c < 3; c++)
			x[c] = gltf_component(a, i, c);
		for (c = 0; c < 3; c++)
			y[c] = p->moved ? p->A[c][0]*x[0] + p->A[c][1]*x[1] + p->A[c][2]*x[2] + p->t[c] : x[c];
		if ((e = soup_vertex(g->r, y)) != 0)
			return e;
	}
	return 0;
}

/* Corner k of the primitive, without indices its vertices in order. */
static long long
corner(const GltfArray *index, size_t k)
{
	return index->p ? (long long)gltf_component(index, k, 0) : (long long)k;
}

enum { TRIANGLES = 4, STRIP, FAN };

/* Adds the triangle with these corners, numbers of the primitive's vertices. */
static int
triangle(Gltf *g, const long long i[3], int turn, long long base, long long nv)
{
	int c, e;

	for (c = 0; c < 3; c++) {
		const long long v = i[turn && c ? 3 - c : c];

		if (v >= nv)
			return mesh_fail(g->r->s->err, MESH_EINDEX, "face %d refers to vertex %lld of a primitive that has %lld",
			    g->r->s->nf, v, nv);
		if ((e = soup_corner(g->r, base + v)) != 0)
			return e;
	}
	return soup_face(g->r);
}

/* n corners make these triangles: three each; or, in a strip or fan, two that were there and the next, where
 * triangles in which a vertex occurs twice only join parts and are left out. */
static int
triangles(Gltf *g, long long mode, const GltfArray *index, size_t n, int turn, long long base, long long nv)
{
	const size_t step = mode == TRIANGLES ? 3 : 1;
	long long i[3];
	size_t k;
	int e;

	for (k = 0; k + 2 < n; k += step) {
		const size_t odd = mode == STRIP && k % 2;

		i[0] = corner(index, mode == FAN ? 0 : k);
		i[1] = corner(index, k + 1 + odd);
		i[2] = corner(index, k + 2 - odd);
		if (mode != TRIANGLES && (i[0] == i[1] || i[1] == i[2] || i[2] == i[0]))
			continue;
		if ((e = triangle(g, i, turn, base, nv)) != 0)
			return e;
	}
	return 0;
}

static int
draco(const Json *j, long long primitive)
{
	return json_get(j, json_get(j, primitive, "extensions"), "KHR_draco_mesh_compression") >= 0;
}

/* A primitive of a mesh.  Points and lines are skipped. */
static int
primitive(Gltf *g, long long v, const Place *p)
{
	const Json *j = &g->j;
	const long long mode = json_int(j, json_get(j, v, "mode"), TRIANGLES), indices = json_get(j, v, "indices");
	const long long base = g->r->s->nv, position = json_get(j, json_get(j, v, "attributes"), "POSITION");
	GltfArray a = { .p = NULL }, index = { .p = NULL };
	size_t n, nf;
	int e;

	if (mode >= 0 && mode < TRIANGLES)
		return 0;
	if (mode < 0 || mode > FAN)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "a primitive of mode %lld is not read", mode);
	if (draco(j, v))
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "DRACO compressed meshes are not read");
	if (position < 0)
		return 0;
	if ((e = gltf_accessor(g, json_int(j, position, -1), 3, &a)) != 0)
		return e;
	if (indices >= 0 && (e = gltf_accessor(g, json_int(j, indices, -1), 1, &index)) != 0)
		return e;
	if (index.p && index.kind != 'u')
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "the indices of a primitive are not of an unsigned type");
	n = index.p ? index.count : a.count;
	nf = mode == TRIANGLES ? n/3 : n > 2 ? n - 2 : 0;
	if (g->counting) {
		g->nv += a.count;
		g->nf += nf;
		g->ni += 3*nf;
		return 0;
	}
	if ((e = vertices(g, &a, p)) != 0)
		return e;
	return triangles(g, mode, &index, n, reflects(p), base, (long long)a.count);
}

/* Whether what was counted takes at most 8 bytes for each byte of the file, so that a mesh that many nodes use
 * cannot fill the memory. */
static int
too_much(Gltf *g)
{
	if (++g->visits <= g->size && g->nv <= g->size && g->ni <= g->size && 24*g->nv + 4*(g->nf + g->ni) <= 8*g->size)
		return 0;
	return mesh_fail(g->r->s->err, MESH_EFORMAT, "meshes used many times: more than %zu vertices or %zu triangles "
	    "in a file of %zu bytes", g->size/3, g->size/2, g->size);
}

static int
mesh(Gltf *g, long long i, const Place *p)
{
	const long long v = gltf_item(g, GLTF_MESHES, i), list = json_get(&g->j, v, "primitives");
	long long k;
	int e;

	if (v < 0)
		return MESH_EFORMAT;
	for (k = json_first(&g->j, list); k >= 0; k = json_next(&g->j, list, k))
		if ((g->counting && (e = too_much(g)) != 0) || (e = primitive(g, k, p)) != 0)
			return e;
	return g->counting ? too_much(g) : 0;
}

/* Node i and those below it.  A mesh with a skin is taken as it is stored, before bones move it, without the
 * transform of its node, which glTF says to ignore. */
static int
node(Gltf *g, long long i, const Place *parent, int depth)
{
	static const Place here = { .moved = 0 };
	const Json *j = &g->j;
	const long long v = gltf_item(g, GLTF_NODES, i), child = json_get(j, v, "children"), m = json_get(j, v, "mesh");
	Place p, own;
	long long k;
	int e;

	if (v < 0)
		return MESH_EFORMAT;
	if (g->seen[i] || depth > DEEPEST)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "node %lld is reached twice, or is more than %d nodes deep", i, DEEPEST);
	g->seen[i] = 1;
	own = local(j, v);
	p = after(parent, &own);
	if (m >= 0 && (e = mesh(g, json_int(j, m, -1), json_get(j, v, "skin") >= 0 ? &here : &p)) != 0)
		return e;
	for (k = json_first(j, child); k >= 0; k = json_next(j, child, k))
		if ((e = node(g, json_int(j, k, -1), &p, depth + 1)) != 0)
			return e;
	return 0;
}

int
gltf_scene(Gltf *g)
{
	static const Place here = { .moved = 0 };
	const Json *j = &g->j;
	const long long which = json_int(j, json_get(j, 0, "scene"), 0);
	long long scene, list, k;
	int e;

	if (!g->list[GLTF_SCENES].n)
		return mesh_fail(g->r->s->err, MESH_EFORMAT, "no scene");
	if ((scene = gltf_item(g, GLTF_SCENES, which)) < 0)
		return MESH_EFORMAT;
	memset(g->seen, 0, g->list[GLTF_NODES].n);
	list = json_get(j, scene, "nodes");
	for (k = json_first(j, list); k >= 0; k = json_next(j, list, k))
		if ((e = node(g, json_int(j, k, -1), &here, 0)) != 0)
			return e;
	return 0;
}
