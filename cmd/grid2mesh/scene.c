/* scene.c - collects surfaces for a .glb file. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/mesh/polygon.h"
#include "../../lib/meshfile/glb.h"
#include "../../lib/picture/colourscale.h"
#include "scene.h"

int
scene_is(const char *name)
{
	size_t n = name ? strlen(name) : 0;

	return n > 4 && strcasecmp(name + n - 4, ".glb") == 0;
}

/* A value of sRGB, 0..255, as a linear one, 0..65535. */
static unsigned short
linear(unsigned char c)
{
	double x = c/255.0;

	return (unsigned short)lround(65535*(x <= 0.04045 ? x/12.92 : pow((x + 0.055)/1.055, 2.4)));
}

/* The colours of a field: diverging, centred on 0, if it has both signs, between its 1 and 99 percent. */
static unsigned short *
colours(const double *f, int nv)
{
	double *sorted = cmd_alloc(nv, sizeof *sorted);
	unsigned short *to = cmd_alloc(nv, 4*sizeof *to);
	ColourScale scale = { COLOURMAP_VIRIDIS, 0, 0, 1 };
	size_t n = 0;
	int i, below = 0, above = 0;
	Colour c;

	for (i = 0; i < nv; i++)
		if (isfinite(f[i])) {
			sorted[n++] = f[i];
			below |= f[i] < 0;
			above |= f[i] > 0;
		}
	if (below && above)
		scale.map = COLOURMAP_DIVERGING;
	if (n > 0)
		colourscale_fit(&scale, n, sorted, (ColourEnd){ 1, 1 }, (ColourEnd){ 99, 1 });
	for (i = 0; i < nv; i++) {
		c = colourscale_colour(&scale, f[i]);
		to[4*i] = linear(c.r), to[4*i+1] = linear(c.g), to[4*i+2] = linear(c.b), to[4*i+3] = 65535;
	}
	free(sorted);
	return to;
}

static void
begin(Scene *s, const CmdInput *in, const Soup *soup, const Fields *fields)
{
	char err[MESH_ERRLEN];

	s->nv = soup->nv;
	if (soup->first) {
		if (polygon_split(soup, &s->tri, &s->nf, err))
			die("%s: %s", in->name, err);
	} else {
		s->nf = soup->nf;
		s->tri = cmd_alloc((size_t)s->nf, 3*sizeof *s->tri);
		memcpy(s->tri, soup->idx, 3*(size_t)s->nf*sizeof *s->tri);
	}
	if (fields->names && strchr(fields->names, ','))
		misuse("--with: a .glb file has the colours of one channel");
	if (fields->names)
		s->colour = colours(channel_values(&soup->channels, fields->names), s->nv);
}

void
scene_add(Scene *s, const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields)
{
	float *x;
	Soup soup;
	size_t i;

	gridfile_soup(in, g, on, fields, 1, ".glb", &soup);
	if (!s->frames)
		begin(s, in, &soup, fields);
	if (soup.nv != s->nv)
		die("%s: frame %d has %d vertices, the first %d: a .glb file morphs one mesh", in->name, s->frames + 1,
			soup.nv, s->nv);
	s->xyz = realloc(s->xyz, (size_t)(s->frames + 1)*sizeof *s->xyz);
	if (!s->xyz)
		die("%s: no memory for %d frames", in->name, s->frames + 1);
	x = cmd_alloc((size_t)s->nv, 3*sizeof *x);
	for (i = 0; i < 3*(size_t)s->nv; i++)
		x[i] = (float)soup.xyz[i];
	s->xyz[s->frames++] = x;
	gridfile_soup_free(on, &soup);
}

void
scene_bytes(Scene *s, const CmdInput *in, double seconds, char **bytes, size_t *n)
{
	Glb g = { s->nv, s->nf, s->tri, s->frames, s->xyz, s->colour, s->frames > 1 ? seconds/(s->frames - 1) : 0 };
	int k;

	switch (glb_write(&g, bytes, n)) {
	case 0: break;
	case GLB_EVALUE: die("%s: a coordinate is too large for .glb", in->name);
	case GLB_ELARGE: die("%s: %d frames of %d vertices are more than the 4 GiB of a .glb file", in->name,
		s->frames, s->nv);
	default: die("%s: no memory for %d frames of %d vertices", in->name, s->frames, s->nv);
	}
	for (k = 0; k < s->frames; k++)
		free(s->xyz[k]);
	free(s->xyz);
	free(s->tri);
	free(s->colour);
}
