/* meshwrite.c - a mesh as the bytes of a file. */
#include <float.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "meshpriv.h"

typedef struct Text {
	char  *p;
	size_t n, cap;
} Text;

enum { MAXTEXT = 400 };         /* more than any piece put at once */

/* Room for one more piece; 0 when there is no memory. */
static int
room(Text *t)
{
	char *p;

	if (t->cap - t->n > MAXTEXT)
		return 1;
	if (t->cap > SIZE_MAX / 4 || !(p = realloc(t->p, 2*t->cap + 4096)))
		return 0;
	t->p = p;
	t->cap = 2*t->cap + 4096;
	return 1;
}

/* x with the fewest of 15, 16 or 17 digits that read back as x. */
static void
number(Text *t, double x, char after)
{
	char *s = t->p + t->n;
	int digits = 15;

	do
		snprintf(s, 32, "%.*g", digits, x);
	while (strtod(s, NULL) != x && ++digits <= 17);
	t->n += strlen(s);
	t->p[t->n++] = after;
}

static void
words(Text *t, const char *s)
{
	size_t n = strlen(s);

	memcpy(t->p + t->n, s, n);
	t->n += n;
}

static int
vertices(Text *t, const Mesh *m, const char *before)
{
	size_t i;
	int c;

	for (i = 0; i < (size_t)m->nv; i++) {
		if (!room(t))
			return MESH_ENOMEM;
		words(t, before);
		for (c = 0; c < 3; c++)
			number(t, m->xyz[3*i + (size_t)c], c < 2 ? ' ' : '\n');
	}
	return 0;
}

static int
faces(Text *t, const Mesh *m, const char *before, int base)
{
	size_t f;

	for (f = 0; f < (size_t)m->nf; f++) {
		const int *v = m->tri + 3*f;

		if (!room(t))
			return MESH_ENOMEM;
		t->n += (size_t)snprintf(t->p + t->n, MAXTEXT, "%s %d %d %d\n", before,
		    v[0] + base, v[1] + base, v[2] + base);
	}
	return 0;
}

static int
off(Text *t, const Mesh *m)
{
	if (!room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, MAXTEXT, "OFF\n%d %d 0\n", m->nv, m->nf);
	return vertices(t, m, "") ? MESH_ENOMEM : faces(t, m, "3", 0);
}

static int
obj(Text *t, const Mesh *m)
{
	return !room(t) || vertices(t, m, "v ") ? MESH_ENOMEM : faces(t, m, "f", 1);
}

/* The n low bytes of w, least significant first. */
static void
bytes(Text *t, uint64_t w, int n)
{
	for (; n > 0; n--, w >>= 8)
		t->p[t->n++] = (char)(w & 0xff);
}

static int
ply(Text *t, const Mesh *m)
{
	uint64_t w;
	size_t i;
	int c;

	if (!room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, MAXTEXT, "ply\nformat binary_little_endian 1.0\n"
	    "element vertex %d\nproperty double x\nproperty double y\nproperty double z\n"
	    "element face %d\nproperty list uchar int vertex_indices\nend_header\n", m->nv, m->nf);
	for (i = 0; i < 3*(size_t)m->nv; i++) {
		if (!room(t))
			return MESH_ENOMEM;
		memcpy(&w, &m->xyz[i], 8);
		bytes(t, w, 8);
	}
	for (i = 0; i < (size_t)m->nf; i++) {
		if (!room(t))
			return MESH_ENOMEM;
		bytes(t, 3, 1);
		for (c = 0; c < 3; c++)
			bytes(t, (uint64_t)m->tri[3*i + (size_t)c], 4);
	}
	return 0;
}

static void
floats(Text *t, const double x[3])
{
	uint32_t w;
	float y;
	int c;

	for (c = 0; c < 3; c++) {
		y = (float)x[c];
		memcpy(&w, &y, 4);
		bytes(t, w, 4);
	}
}

/* Unit normal of triangle v, or 0 where numbers cannot say it. */
static void
normal(const Mesh *m, const int *v, double n[3])
{
	const double *a = m->xyz + 3*(size_t)v[0], *b = m->xyz + 3*(size_t)v[1];
	const double *e = m->xyz + 3*(size_t)v[2];
	double p[3], q[3], len;
	int c;

	for (c = 0; c < 3; c++)
		p[c] = b[c] - a[c], q[c] = e[c] - a[c];
	for (c = 0; c < 3; c++)
		n[c] = p[(c+1)%3]*q[(c+2)%3] - p[(c+2)%3]*q[(c+1)%3];
	len = sqrt(n[0]*n[0] + n[1]*n[1] + n[2]*n[2]);
	for (c = 0; c < 3; c++)
		n[c] = len > 0 && len <= DBL_MAX ? n[c] / len : 0;
}

static int
stl(Text *t, const Mesh *m)
{
	double n[3];
	size_t i;
	int c;

	for (i = 0; i < 3*(size_t)m->nv; i++)
		if (!(fabs(m->xyz[i]) <= (double)FLT_MAX))
			return MESH_EVALUE;
	if (!room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, MAXTEXT, "%-80s", "lhgrid: binary STL");
	bytes(t, (uint64_t)m->nf, 4);
	for (i = 0; i < (size_t)m->nf; i++) {
		const int *v = m->tri + 3*i;

		if (!room(t))
			return MESH_ENOMEM;
		normal(m, v, n);
		floats(t, n);
		for (c = 0; c < 3; c++)
			floats(t, m->xyz + 3*(size_t)v[c]);
		bytes(t, 0, 2);
	}
	return 0;
}

int
meshfile_format(const Mesh *m, int kind, char **out, size_t *n)
{
	Text t = { NULL, 0, 0 };
	int e;

	e = kind == MESHFILE_OFF ? off(&t, m) : kind == MESHFILE_OBJ ? obj(&t, m) :
	    kind == MESHFILE_PLY ? ply(&t, m) : stl(&t, m);
	if (e) {
		free(t.p);
		return e;
	}
	*out = t.p;
	*n = t.n;
	return 0;
}
