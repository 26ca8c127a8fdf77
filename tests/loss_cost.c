/* loss_cost.c - the cost of measuring the loss of a grid, relative to the cost of making the grid.
 *
 * usage: loss_cost MESH
 * prints the processor seconds of reading, mapping and sampling MESH on 257 x 257 nodes, the
 * processor seconds of gridloss, and the second number in percent of the first.  The program only
 * measures; it tests nothing. */
#include <time.h>

#include "../lib/grid/gridloss.h"
#include "../lib/map/conformal.h"
#include "../lib/map/corners.h"
#include "diskfile.h"

static double
now(void)
{
	struct timespec t;

	clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
	return t.tv_sec + 1e-9*t.tv_nsec;
}

int
main(int argc, char *argv[])
{
	const ConformalOptions options = { .map = { 1e-3, 1, 300000 }, .surface = SAMPLER_SMOOTH,
		.polish = 12 };
	const Chart g = { 257, 257, 1, &CHART_RECTANGLE };
	double begin, mapped, measured;
	SpdReport report;
	int corner[4];
	GridLoss loss;
	Conformal c;
	Disk d;

	if (argc != 2)
		quit("need a mesh");
	begin = now();
	load(argv[1], &d);
	if (corners_auto(&d, corner) < 0 || conformal_grid(&d, corner, g, &options, &c, &report))
		quit("the map failed");
	mapped = now();
	if (gridloss(&d.m, c.u, c.v, c.grid.g, c.grid.phi, &loss))
		quit("no memory");
	measured = now();
	printf("%.3f %.4f %.1f\n", mapped - begin, measured - mapped, 100*(measured - mapped)/(mapped - begin));
	conformal_free(&c);
	disk_free(&d);
	return 0;
}
