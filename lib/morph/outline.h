/* outline.h - the smoothed shape of a ragged closed curve.
 *
 * The boundary of a scan runs in and out; its extra length would distort arc length along the
 * outline.  So the curve is smoothed first: the Fourier coefficients of points at equal arc length
 * are multiplied by exp(-(k/8)^2).  The outline consists of points at equal arc length of the smooth
 * curve, centred and scaled to root mean square 1.
 */
#ifndef OUTLINE_H
#define OUTLINE_H

enum {
	OUTLINE_ENOMEM = -1,
	OUTLINE_EVALUE = -2             /* the curve is not finite, or has no length */
};

typedef struct Outline {
	int     n;
	double *x;              /* [n][3] */
	double *place;          /* [n+1] place[k]: the place on the outline of the point at place k/n
	                         * on the curve; places are shares of the length of each */
} Outline;

/* The outline, of n points, of the closed polygon x[m][3], with the same starting point.
 * Returns 0, or OUTLINE_ENOMEM or OUTLINE_EVALUE with nothing to free. */
int  outline_init(Outline *o, int n, int m, const double *x);
void outline_free(Outline *o);

/* From a place on the curve to the place on the outline, and back.  Places are shares of the length,
 * 0 .. 1. */
double outline_place(const Outline *o, double place);
double outline_back(const Outline *o, double place);

#endif
