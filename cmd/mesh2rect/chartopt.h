/* chartopt.h - the options --chart and --cells of mesh2rect. */
#ifndef CMD_CHARTOPT_H
#define CMD_CHARTOPT_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

enum { CHARTOPT_AUTO = LHG_PILLOW + 1, CHARTOPT_UNSET };       /* of --chart, after the charts of lhg.h */

typedef struct ChartOptions {
	int         kind;       /* of --chart */
	const char *corners, *cones, *like;     /* NULL: not given */
	int         reversed;
} ChartOptions;

/* Reads "auto", "N" or "NxM".  Sets the numbers of nodes of g, one more than those of cells; or, for
 * "auto", o->keep, the fraction of the area to be kept, which is 0 otherwise. */
void opt_cells(char *s, Chart *g, ConformalOptions *o);

/* The chart g, of opt_cells, with the kind and the numbers of nodes of --chart, or dies if options contradict each other.
 * Without --chart the kind depends on the mesh: then g is returned. */
Chart chartopt_before(const ChartOptions *given, Chart g, ConformalOptions *o);

/* The chart for d, after chartopt_before, or dies if that of --chart is not for d. */
Chart chartopt_of(const char *name, const Disk *d, const ChartOptions *given, Chart g, ConformalOptions *o);

#endif
