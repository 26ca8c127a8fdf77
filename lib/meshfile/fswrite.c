/* fswrite.c - FreeSurfer's binary files: surfaces of triangles (.pial, .white) and curvature files (.curv), big-endian. */
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "facts.h"
#include "fieldfile.h"
#include "writepriv.h"

enum { SURF_GEOM = 20 };        /* the tag of the volume geometry */

static void
big(Text *t, uint32_t w)
{
	int k;

	for (k = 3; k >= 0; k--)
		text_bytes(t, w >> 8*k & 0xff, 1);
}

static void
big_float(Text *t, double x)
{
	float y = (float)x;
	uint32_t w;

	memcpy(&w, &y, 4);
	big(t, w);
}

/* Appends "key = value" for the fact of that name, if it is there.  Returns whether it is. */
static int
geometry_line(Text *t, const Soup *s, const char *fact, const char *key, int dry)
{
	char name[FACT_KEY], value[FACT_VALUE];
	const char *facts = s->facts;

	while ((facts = fact_next(facts, name, value)))
		if (strcmp(name, fact) == 0) {
			if (!dry)
				t->n += (size_t)snprintf(t->p + t->n, TEXT_MAX, "%s = %s\n", key, value);
			return 1;
		}
	return 0;
}

/* The volume geometry, if the facts have all of it. */
static int
geometry(Text *t, const Soup *s)
{
	static const char *const line[8][2] = { { "fs.valid", "valid" }, { "fs.filename", "filename" },
	    { "fs.volume", "volume" }, { "fs.voxelsize", "voxelsize" }, { "fs.xras", "xras  " },
	    { "fs.yras", "yras  " }, { "fs.zras", "zras  " }, { "c_ras", "cras  " } };
	int i;

	for (i = 0; i < 8; i++)
		if (!geometry_line(t, s, line[i][0], line[i][1], 1))
			return 0;
	if (!text_room(t))
		return MESH_ENOMEM;
	big(t, SURF_GEOM);
	for (i = 0; i < 8; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		geometry_line(t, s, line[i][0], line[i][1], 0);
	}
	return 0;
}

int
fsbinary_write(Text *t, const Soup *s)
{
	const int *v;
	size_t i;
	int f, c;

	for (i = 0; i < 3*(size_t)s->nv; i++)
		if (!(fabs(s->xyz[i]) <= (double)FLT_MAX))
			return MESH_EVALUE;
	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, "\xff\xff\xfe" "created by lhgrid\n\n");
	big(t, (uint32_t)s->nv);
	big(t, (uint32_t)s->nf);
	for (i = 0; i < 3*(size_t)s->nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		big_float(t, s->xyz[i]);
	}
	for (f = 0; f < s->nf; f++) {
		if (text_corners(s, f, &v) != 3)
			return MESH_EFACE;
		if (!text_room(t))
			return MESH_ENOMEM;
		for (c = 0; c < 3; c++)
			big(t, (uint32_t)v[c]);
	}
	return geometry(t, s);
}

/* ff ff ff, the numbers of vertices and faces and of values at a vertex, the values. */
int
fscurv_write(Text *t, const Channels *c, int nv, int nf)
{
	int i;

	if (!text_room(t))
		return MESH_ENOMEM;
	text_words(t, "\xff\xff\xff");
	big(t, (uint32_t)nv);
	big(t, (uint32_t)nf);
	big(t, 1);
	for (i = 0; i < nv; i++) {
		if (!text_room(t))
			return MESH_ENOMEM;
		big_float(t, c->channel[0].f[i]);
	}
	return 0;
}
