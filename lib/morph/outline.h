/* outline.h - the smoothed shape of a ragged closed curve.
 *
 * The boundary of a scan is ragged, and the extra length of its zigzags would distort the arc
 * length along it.  So the curve is smoothed first: points are taken at equal arc lengths, and
 * their k-th Fourier coefficients are multiplied by exp(-(k/8)^2).  The outline consists of points
 * at equal arc lengths of the smooth curve, with mean 0 and root mean square 1.
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
	double *place;          /* [n+1] the point at place k/n of the curve is at place[k] of the
	                         * outline; see outline_place for what a place is */
} Outline;

/* Computes the outline, with n points, of the closed polygon x, [m][3].  Point 0 of the outline
 * corresponds to point 0 of the polygon.  Returns 0, or OUTLINE_ENOMEM or OUTLINE_EVALUE with nothing
 * to free. */
int  outline_init(Outline *o, int n, int m, const double *x);
void outline_free(Outline *o);

/* outline_place converts a place on the curve to the corresponding place on the outline;
 * outline_back does the reverse.  A place on a curve is the arc length from point 0 to it divided by
 * the length of the curve, 0 .. 1. */
double outline_place(const Outline *o, double place);
double outline_back(const Outline *o, double place);

#endif
