/* stlwrite.c - a mesh as the bytes of a binary STL file. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "writepriv.h"

static void
floats(Text *t, const double x[3])
{
	uint32_t w;
	float y;
	int c;

	for (c = 0; c < 3; c++) {
		y = (float)x[c];
		memcpy(&w, &y, 4);
		text_bytes(t, w, 4);
	}
}

/* Unit normal of triangle v; 0 if the cross product of its edges is 0 or overflows. */
static void
normal(const double *xyz, const int *v, double n[3])
{
	const double *a = xyz + 3*(size_t)v[0], *b = xyz + 3*(size_t)v[1];
	const double *e = xyz + 3*(size_t)v[2];
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

int
stl_write(Text *t, const Soup *s)
{
	const int *v;
	double n[3];
	size_t i;
	int c, f;

	for (i = 0; i < 3*(size_t)s->nv; i++)
		if (!(fabs(s->xyz[i]) <= (double)FLT_MAX))
			return MESH_EVALUE;
	if (!text_room(t))
		return MESH_ENOMEM;
	t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "%-80s", "lhgrid: binary STL");
	text_bytes(t, (uint64_t)s->nf, 4);
	for (f = 0; f < s->nf; f++) {
		if (text_corners(s, f, &v) != 3)
			return MESH_EFACE;
		if (!text_room(t))
			return MESH_ENOMEM;
		normal(s->xyz, v, n);
		floats(t, n);
		for (c = 0; c < 3; c++)
			floats(t, s->xyz + 3*(size_t)v[c]);
		text_bytes(t, 0, 2);
	}
	return 0;
}
