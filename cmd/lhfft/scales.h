/* scales.h - the filter options of lhfft, for one scale or several. */
#ifndef CMD_SCALES_H
#define CMD_SCALES_H

#include "../../lib/scales/filter.h"
#include "../shared/cmd.h"

enum { SCALES_MAX = 256 };

typedef struct Scales {
	SpectrumBasis basis;
	const char *option;             /* the option that set the bounds, or NULL */
	FilterRule  rule;
	int         n;                  /* how many scales */
	double      bound[SCALES_MAX];
	double      lambda, H;          /* --K-lambda, --K-H; -1: use the bound of the scale */
	int         raw, log, bending;  /* --raw, --log-lambda, --bending */
} Scales;

/* The defaults: cosines, the logarithm of lambda, lambda H. */
void scales_init(Scales *s);

/* Read the list X or X,X,.. of an option, or exit 2. */
void scales_set(Scales *s, FilterRule rule, const char *option, const char *list);

/* Exit 2 unless exactly one rule is given; to be called once, after all options. */
void scales_check(Scales *s);

/* Dies unless g has lambda > 0 and H.  Returns the smallest lambda. */
double scales_need(const CmdInput *in, const Lhg *g);

/* scales_curvature returns the field that is filtered, lambda H or H, to be freed; scales_name
 * returns its name. */
double *scales_curvature(const Scales *s, const CmdInput *in, const Lhg *g);
const char *scales_name(const Scales *s);

/* The metadatum "waves" of g, which an earlier filter has set; 0 if there is none. */
double scales_waves(const Lhg *g);

/* Filter lambda and H of g by the bound of scale k, or die.  Set the metadatum "waves" if lambda or H
 * changes or if there are several scales.  before: scales_waves of the input. */
void scales_apply(const Scales *s, int k, double before, const CmdInput *in, Lhg *g);

#endif
