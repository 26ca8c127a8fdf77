/* plyfield.c - numbers at the vertices of a PLY file, beside their places, as channels. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/channel.h"
#include "plypriv.h"

enum { LEFT_OUT = 200 };                /* characters of Soup.left_out, at most */

static int
has_offset(const Ply *p, const PlyElem *vertex)
{
	int i;

	for (i = vertex->p0; i < vertex->p1; i++)
		if (ply_uv_use(p->prop[i].name) >= PLY_OFFSET)
			return 1;
	return 0;
}

static int
is_normal(Token name)
{
	return scan_is(name, "nx") || scan_is(name, "ny") || scan_is(name, "nz");
}

/* Whether a property of vertices, a number, has a meaning of its own and is not asked for: a place, a number in another
 * file, (u,v) of a map; a normal or a texture coordinate. */
static int
is_known(const Ply *p, const PlyElem *vertex, const PlyProp *q)
{
	const int use = ply_uv_use(q->name);

	if (q->count)
		return 0;
	if (q->use != PLY_SKIP || use >= PLY_OFFSET)
		return 1;
	return p->r->normals ? use != PLY_SKIP && has_offset(p, vertex) : use != PLY_SKIP || is_normal(q->name);
}

/* Whether it is printable ASCII. */
static int
is_plain(Token name)
{
	size_t i;

	for (i = 0; i < name.n; i++)
		if (name.s[i] <= ' ' || name.s[i] > '~')
			return 0;
	return 1;
}

/* Whether a property of vertices can be a channel: a number, with a name that fits and is not that of another kind of
 * channel. */
static int
is_field(const PlyProp *q)
{
	return !q->count && is_plain(q->name) && q->name.n < CHANNEL_NAME && !scan_is(q->name, MESH_UV) && !scan_is(q->name, MESH_OFFSET) &&
	    !scan_is(q->name, MESH_SOURCE);
}

/* Appends to s->left_out.  Returns 0 or MESH_ENOMEM. */
static int
leave_out(Soup *s, const char *kind, Token name, const char *at)
{
	char show[SCAN_SHOW], item[LEFT_OUT/2];
	size_t n;

	if (!s->left_out && !(s->left_out = calloc(LEFT_OUT, 1)))
		return mesh_fail(s->err, MESH_ENOMEM, "no memory for a list of properties");
	n = strlen(s->left_out);
	snprintf(item, sizeof item, "%s%s%s%s", n ? ", " : "", kind, scan_show(name, show), at);
	if (n + strlen(item) + sizeof ", .." <= LEFT_OUT)
		strcpy(s->left_out + n, item);
	else if (strcmp(s->left_out + n - 2, "..") != 0)
		strcpy(s->left_out + n, ", ..");
	return 0;
}

/* Lists what is at faces and other elements. */
static int
elsewhere(Ply *p)
{
	const PlyElem *x;
	int e, i;

	for (x = p->elem; x < p->elem + p->ne; x++) {
		if (x->kind == PLY_VERTEX || x->n == 0)
			continue;
		if (x->kind == PLY_OTHER && x->p0 < x->p1 && (e = leave_out(p->r->s, "element ", x->name, "")) != 0)
			return e;
		for (i = x->p0; i < x->p1 && x->kind != PLY_OTHER; i++)
			if (p->prop[i].use == PLY_SKIP &&
			    (e = leave_out(p->r->s, p->prop[i].count ? "list " : "", p->prop[i].name, " at faces")) != 0)
				return e;
	}
	return 0;
}

int
ply_fields(Ply *p, const PlyElem *vertex)
{
	Soup *s = p->r->s;
	char name[CHANNEL_NAME] = "";
	int e, i, twice;

	for (i = vertex->p0; i < vertex->p1; i++) {
		PlyProp *q = &p->prop[i];

		if (is_known(p, vertex, q))
			continue;
		if (q->name.n < CHANNEL_NAME)
			snprintf(name, sizeof name, "%.*s", (int)q->name.n, q->name.s);
		twice = is_field(q) && channel_find(&s->channels, name);
		if (twice && !p->r->loose)
			return mesh_fail(s->err, MESH_EFORMAT, "vertices have two properties %s", name);
		if (twice || !is_field(q)) {
			if ((e = leave_out(s, q->count ? "list " : "", q->name, " at vertices")) != 0)
				return e;
			continue;
		}
		if (!(q->field = channel_add(&s->channels, name, 1, (size_t)vertex->n)))
			return mesh_fail(s->err, MESH_ENOMEM, "no memory for %s at %lld vertices", name, vertex->n);
		channel_find(&s->channels, name)->type = ply_channel_type(q->type);
	}
	return elsewhere(p);
}

void
ply_field_types(const Ply *p, const PlyElem *vertex)
{
	Channels *c = &p->r->s->channels;
	long long i;
	int k;

	for (k = 0; k < c->n && p->format == PLY_ASCII; k++)
		for (i = 0; i < vertex->n; i++)
			if (!channel_holds(c->channel[k].type, c->channel[k].f[i])) {
				c->channel[k].type = CHANNEL_DOUBLE;
				break;
			}
}
