/* start.c - the start on each kind of chart; on the rectangle by the frame method. */
#include <math.h>
#include <stdlib.h>

#include "frame.h"
#include "start.h"

static int
from_frame(Chart finest, double *band, const Level *l)
{
	double *lambda = malloc(level_nodes(l->g)*sizeof *lambda), *H = malloc(level_nodes(l->g)*sizeof *H);
	double *fine[3], *phi[3];
	int c, at, e = SPD_ENOMEM;
	size_t p;

	for (c = 0; c < 3; c++) {
		fine[c] = band + c*level_nodes(finest);
		phi[c] = l->phi + c*level_nodes(l->g);
	}
	for (p = 0; lambda && H && p < level_nodes(l->g); p++) {
		lambda[p] = sqrt(l->lambda2[p]);
		H[p] = l->l2H[p]/l->lambda2[p];
	}
	if (lambda && H)
		e = l->phi == band ? frame_surface(l->g, lambda, H, phi, &at, NULL)
		    : frame_coarse(finest, fine, l->g, lambda, H, phi, &at, NULL);
	free(lambda);
	free(H);
	return e == SPD_ENOMEM ? START_ENOMEM : e ? START_ENONE : 0;
}

static const struct {
	const ChartKind *kind;
	int   rings;
	int (*find)(Chart finest, double *band, const Level *l);
	int   stages;
	int (*between)(const Level *l, double t, double *lambda2, double *l2H);
} known[] = {
	{ &CHART_RECTANGLE, FRAME_BAND, from_frame, 0, NULL },
	{ &CHART_SOCK, 1, start_from_cap, 0, NULL },
	{ &CHART_PILLOW, 0, start_from_sphere, 3, start_between_sphere },
};

static int
index_of(const ChartKind *kind)
{
	int i = 0;

	while (known[i].kind != kind)
		i++;
	return i;
}

int
start_rings(const ChartKind *kind)
{
	return known[index_of(kind)].rings;
}

int
start_find(Chart finest, double *band, const Level *l)
{
	return known[index_of(l->g.kind)].find(finest, band, l);
}

int
start_stages(const ChartKind *kind)
{
	return known[index_of(kind)].stages;
}

int
start_between(const Level *l, double t, double *lambda2, double *l2H)
{
	return known[index_of(l->g.kind)].between(l, t, lambda2, l2H);
}
