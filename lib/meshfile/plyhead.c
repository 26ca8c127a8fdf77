/* plyhead.c - the header of a PLY file. */
#include <string.h>

#include "plypriv.h"

static const PlyType TYPE[] = {         /* in the order of ChannelType */
	{ "char",   "int8",    1, 'i' }, { "uchar",  "uint8",   1, 'u' },
	{ "short",  "int16",   2, 'i' }, { "ushort", "uint16",  2, 'u' },
	{ "int",    "int32",   4, 'i' }, { "uint",   "uint32",  4, 'u' },
	{ "float",  "float32", 4, 'f' }, { "double", "float64", 8, 'f' }
};

static int
bad(Ply *p, const char *what, Token t)
{
	char show[SCAN_SHOW];

	return mesh_fail(p->r->s->err, MESH_EFORMAT, "header line %ld: '%s' is not %s",
	    p->r->line, scan_show(t, show), what);
}

static const PlyType *
typenamed(Token t)
{
	size_t i;

	for (i = 0; i < sizeof TYPE / sizeof *TYPE; i++)
		if (scan_is(t, TYPE[i].name) || scan_is(t, TYPE[i].alias))
			return &TYPE[i];
	return NULL;
}

ChannelType
ply_channel_type(const PlyType *t)
{
	return (ChannelType)(CHANNEL_INT8 + (t - TYPE));
}

const PlyType *
ply_type(ChannelType type)
{
	return &TYPE[type - CHANNEL_INT8];
}

/* "format ascii 1.0" */
static int
format(Ply *p)
{
	static const char *const name[] = { "ascii", "binary_little_endian", "binary_big_endian" };
	Token t;

	scan_word(p->r, &t);
	for (p->format = 0; p->format < 3; p->format++)
		if (scan_is(t, name[p->format]))
			return 0;
	return bad(p, "a PLY format", t);
}

static int
element_kind(Token name)
{
	if (scan_is(name, "vertex"))
		return PLY_VERTEX;
	if (scan_is(name, "face"))
		return PLY_FACE;
	return scan_is(name, "tristrips") ? PLY_STRIP : PLY_OTHER;
}

/* "element face 12" */
static int
element(Ply *p)
{
	PlyElem *e = p->elem + p->ne;
	Token t;

	if (p->ne == PLY_MAXELEM)
		return mesh_fail(p->r->s->err, MESH_EFORMAT, "header has more than %d elements",
		    PLY_MAXELEM);
	if (!scan_word(p->r, &e->name))
		return bad(p, "an element", e->name);
	e->kind = element_kind(e->name);
	if (!scan_word(p->r, &t) || !scan_int(t, &e->n) || e->n < 0)
		return bad(p, "a number of records", t);
	e->p0 = e->p1 = p->np;
	p->ne++;
	return 0;
}

int
ply_uv_use(Token name)
{
	static const char *const known[] = { "s", "t", "u", "v", "texture_u", "texture_v",
	    "offset_u", "offset_v", "offset_n", "offset_r" };
	int i;

	for (i = 0; i < PLY_SOURCE - PLY_UV; i++)
		if (scan_is(name, known[i]))
			return PLY_UV + i;
	return PLY_SKIP;
}

static int
property_use(int kind, int list, Token name, int read_uv)
{
	if (kind == PLY_VERTEX && !list && name.n == 1 && *name.s >= 'x' && *name.s <= 'z')
		return *name.s - 'x';
	if ((kind == PLY_FACE || kind == PLY_STRIP) && list &&
	    (scan_is(name, "vertex_indices") || scan_is(name, "vertex_index")))
		return PLY_CORNERS;
	if (kind == PLY_VERTEX && !list && scan_is(name, MESH_SOURCE))
		return PLY_SOURCE;
	if (kind == PLY_FACE && !list && scan_is(name, "filled"))
		return PLY_FILLED;
	return kind == PLY_VERTEX && !list && read_uv ? ply_uv_use(name) : PLY_SKIP;
}

/* "property float x" or "property list uchar int vertex_indices" */
static int
property(Ply *p)
{
	PlyElem *e = p->elem + p->ne - 1;
	PlyProp *q = p->prop + p->np;
	Token t;
	int i;

	if (p->ne == 0 || p->np == PLY_MAXPROP)
		return mesh_fail(p->r->s->err, MESH_EFORMAT, p->ne ? "header has too many properties" :
		    "header has a property before the first element");
	scan_word(p->r, &t);
	q->count = NULL;
	if (scan_is(t, "list")) {
		scan_word(p->r, &t);
		q->count = typenamed(t);
		if (!q->count || q->count->kind == 'f')
			return bad(p, "a type to count with", t);
		scan_word(p->r, &t);
	}
	q->type = typenamed(t);
	if (!q->type)
		return bad(p, "a type", t);
	if (!scan_word(p->r, &t))
		return bad(p, "a name", t);
	q->name = t;
	q->field = NULL;
	q->use = property_use(e->kind, q->count != NULL, t, p->r->read_uv);
	for (i = e->p0; i < p->np; i++)
		if (q->use != PLY_SKIP && p->prop[i].use == q->use)
			return bad(p, "a new name", t);
	e->p1 = ++p->np;
	return 0;
}

/* Sets p->uv to the first pair of (u,v) properties that the vertices have. */
static int
find_uv_pair(Ply *p, const PlyElem *vertex)
{
	int i, pair, has;

	for (pair = PLY_UV; pair < PLY_OFFSET; pair += 2) {
		for (has = 0, i = vertex->p0; i < vertex->p1; i++)
			has += p->prop[i].use == pair || p->prop[i].use == pair + 1;
		if (has == 2) {
			p->uv = pair;
			return 0;
		}
	}
	return mesh_fail(p->r->s->err, MESH_EFORMAT,
	    "vertices lack (u,v): properties s t, u v or texture_u texture_v");
}

/* Sets p->offset if the vertices have offsets.  A file with only some of the four properties of an
 * offset is refused. */
static int
find_offset(Ply *p, const PlyElem *vertex)
{
	int i, has = 0;

	for (i = vertex->p0; i < vertex->p1; i++)
		has += p->prop[i].use >= PLY_OFFSET && p->prop[i].use < PLY_SOURCE;
	p->offset = has == 4;
	return has == 0 || has == 4 ? 0 : mesh_fail(p->r->s->err, MESH_EFORMAT,
	    "vertices have %d of the properties offset_u offset_v offset_n offset_r", has);
}

/* Checks that vertices, faces and strips occur at most once each and have the properties they
 * need. */
static int
check_elements(Ply *p)
{
	int e, i, seen[4] = { 0 }, has, err;

	for (e = 0; e < p->ne; e++) {
		const PlyElem *x = &p->elem[e];

		if (x->kind != PLY_OTHER && seen[x->kind]++)
			return bad(p, "a new element", x->name);
		for (has = 0, i = x->p0; i < x->p1; i++)
			has += p->prop[i].use != PLY_SKIP && p->prop[i].use < PLY_UV;
		if (x->kind == PLY_VERTEX && has < 3)
			return mesh_fail(p->r->s->err, MESH_EFORMAT, "vertices lack x, y or z");
		if (x->kind == PLY_VERTEX && p->r->read_uv && (err = find_uv_pair(p, x)) != 0)
			return err;
		if (x->kind == PLY_VERTEX && p->r->read_uv && (err = find_offset(p, x)) != 0)
			return err;
		if (x->kind > PLY_VERTEX && has < 1)
			return mesh_fail(p->r->s->err, MESH_EFORMAT,
			    "faces lack a list vertex_indices");
	}
	if (!seen[PLY_VERTEX])
		return mesh_fail(p->r->s->err, MESH_EFORMAT, "header has no element vertex");
	return 0;
}

static int
header_line(Ply *p, Token t)
{
	if (scan_is(t, "format"))
		return format(p);
	if (scan_is(t, "element"))
		return element(p);
	if (scan_is(t, "property"))
		return property(p);
	if (scan_is(t, "comment"))
		return uv_comment(p->r);
	if (scan_is(t, "obj_info"))
		return 0;
	return bad(p, "a header keyword", t);
}

size_t
ply_least(const Ply *p, const PlyElem *e)
{
	size_t n = 0;
	int i;

	for (i = e->p0; i < e->p1; i++) {
		const PlyType *t = p->prop[i].count ? p->prop[i].count : p->prop[i].type;

		n += p->format == PLY_ASCII ? 2 : (size_t)t->size;
	}
	return n;
}

int
ply_header(Ply *p)
{
	Reader *r = p->r;
	int e, bare;
	Token t;

	p->format = -1;
	scan_token(r, &t);                              /* "ply" */
	bare = scan_left(r) > 1 && r->p[0] == '\r' && r->p[1] != '\n';
	for (;;) {
		if (!scan_token(r, &t))
			return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the header");
		if (scan_is(t, "end_header"))
			break;
		if ((e = header_line(p, t)) != 0)
			return e;
		scan_skipline(r);
	}
	if (p->format < 0)
		return mesh_fail(r->s->err, MESH_EFORMAT, "header has no format line");
	/* Skip one line end, of the same kind as the first: the data may begin with a \n. */
	scan_skipline(r);
	if (r->p < r->end && *r->p == '\r')
		r->p++;
	if (!bare && r->p < r->end && *r->p == '\n')
		r->p++, r->line++;
	return check_elements(p);
}
