/* scales.h - the filter options of lhfft, for one scale or several. */
#ifndef CMD_SCALES_H
#define CMD_SCALES_H

#include "../../lib/scales/filter.h"
#include "../shared/cmd.h"

enum { SCALES_MAX = 256 };

/* What a filter does: drops coefficients, or acts in the metric of the surface (ownmetric.h). */
typedef enum ScalesWay { SCALES_COEFFICIENTS, SCALES_LENGTH, SCALES_RELIEF } ScalesWay;

typedef struct Scales {
	SpectrumBasis basis;
	const char *option;             /* the option that set the bounds, or NULL */
	ScalesWay   way;
	FilterRule  rule;               /* for coefficients */
	int         n;                  /* how many scales */
	double      bound[SCALES_MAX];
	int         percent[SCALES_MAX];        /* bound is a length in percent of sqrt(area) */
	double      lambda, H;          /* --K-lambda, --K-H; -1: use the bound of the scale */
	int         raw, log, bending;  /* --raw, --log-lambda, --bending */
} Scales;

/* The defaults: cosines, the logarithm of lambda, lambda H. */
void scales_init(Scales *s);

/* Read the list X or X,X,.. of an option, or exit 2.  The numbers of scales_set_lengths are lengths and
 * may end in %. */
void scales_set(Scales *s, FilterRule rule, const char *option, const char *list);
void scales_set_lengths(Scales *s, ScalesWay way, const char *option, const char *list);

/* The paper's filter, for --paper. */
void scales_paper(Scales *s);

/* Exit 2 unless exactly one rule is given; to be called once, after all options. */
void scales_check(Scales *s);

/* Dies unless g has lambda > 0 and H.  Returns the smallest lambda. */
double scales_need(const CmdInput *in, const Lhg *g);

/* scales_curvature returns the field that is filtered, lambda H or H, to be freed; scales_name
 * returns its name. */
double *scales_curvature(const Scales *s, const CmdInput *in, const Lhg *g);
const char *scales_name(const Scales *s);

/* The metadata "waves" and "scale" of g that earlier filters have set; 0 where there is none. */
typedef struct ScalesBefore {
	double waves, scale;
} ScalesBefore;
ScalesBefore scales_before(const Lhg *g);

/* Set the metadatum "waves", in cycles per width.  If an earlier filter has set a smaller value, that
 * stays. */
void scales_set_waves(Lhg *g, ScalesBefore before, double waves);

/* Filters lambda and H of g by the bound of scale k, or dies.  --scale and --relief filter the place,
 * too; other filters remove it if lambda or H changes.  Sets the metadatum "waves" if lambda or H changes
 * or if there are several scales.  before: the metadata of the input. */
void scales_apply(const Scales *s, int k, ScalesBefore before, const CmdInput *in, Lhg *g);

/* lambda over the conformal factor of a round surface on the chart, to be freed; on the rectangle lambda.
 * This is what is filtered: at the cones of a sock lambda goes to 0, the ratio does not. */
double *scales_ratio(const CmdInput *in, const Lhg *g);

/* Dies if the chart of g has no waves of the basis of s. */
void scales_need_basis(const Scales *s, const CmdInput *in, const Lhg *g);

#endif
