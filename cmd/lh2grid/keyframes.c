/* keyframes.c - frames between two key frames: the interpolated detail of both is added to the start
 * on the finest grid. */
#include <stdlib.h>

#include "../shared/claim.h"
#include "keyframes.h"

/* The detail of a key frame; detail is NULL before the first key frame. */
typedef struct Key {
	int     nu, nv, chart;
	double *detail;         /* [3][nv][nu] */
} Key;

static size_t
detail_length(const Lhg *g)
{
	return 3*(size_t)g->nu*g->nv;
}

static int
same_grid(const Key *k, const Lhg *g)
{
	return k->detail && k->nu == g->nu && k->nv == g->nv && k->chart == g->chart;
}

static Key
convert_key(const CmdInput *in, Lhg *g, int every, SurfaceFit o, KeyframesConvert *convert)
{
	Key k = { g->nu, g->nv, g->chart, NULL };

	claim(in->name, "the detail of key frames", (double)g->nu*g->nv, 8*(40 + 2.0*every));
	o.detail = k.detail = cmd_alloc(detail_length(g), sizeof *k.detail);
	convert(in, g, &o);
	return k;
}

/* Converts the grid g at parameter t, 0 to 1, between the key frames a and b. */
static void
convert_between(const CmdInput *in, Lhg *g, const Key *a, const Key *b, double t, SurfaceFit o,
	KeyframesConvert *convert)
{
	size_t n = detail_length(g), p;

	if (same_grid(a, g) && same_grid(b, g)) {
		o.forecast = cmd_alloc(n, sizeof *o.forecast);
		for (p = 0; p < n; p++)
			o.forecast[p] = (1 - t)*a->detail[p] + t*b->detail[p];
	}
	convert(in, g, &o);
	free(o.forecast);
}

/* Reads up to `room` grids.  Returns their number, which is less than room at the end of the
 * stream. */
static int
read_grids(CmdInput *in, Lhg *g, int room)
{
	int n;

	for (n = 0; n < room && cmd_read(in, &g[n]); n++)
		;
	return n;
}

void
keyframes(CmdInput *in, int every, const SurfaceFit *o, KeyframesConvert *convert)
{
	Lhg *g = cmd_alloc(every, sizeof *g);
	Key last = { 0 }, next;
	int i, n, room = 1;             /* the first frame of all is a key frame */

	for (; (n = read_grids(in, g, room)) > 0; room = every) {
		next = convert_key(in, &g[n-1], every, *o, convert);
		for (i = 0; i < n; i++) {
			if (i < n - 1)
				convert_between(in, &g[i], &last, &next, (i + 1.0)/n, *o, convert);
			cmd_pass_ahead(in, &g[i], i + 1 < n ? &g[i+1] : NULL);
			lhg_free(&g[i]);
		}
		free(last.detail);
		last = next;
		if (n < room)
			break;          /* the stream has ended */
	}
	free(last.detail);
	free(g);
}
