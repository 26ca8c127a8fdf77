/* range.h - input limits within which no stage overflows; beyond them the program dies. */
#ifndef CMD_RANGE_H
#define CMD_RANGE_H

#include "cmd.h"

/* Dies if a coordinate of the positions x[c][k*stride], k < n, is beyond 1e60, or if the largest of
 * their extents along the three axes is below 1e-60, but not 0. */
void range_positions(const char *name, size_t n, int stride, const double *const x[3]);

/* Dies unless the height T of g is one that its chart can have (chart.h). */
void range_height(const CmdInput *in, const Lhg *g);

/* Dies unless lambda is in 1e-60 .. 1e60, its largest value at most 1e12 times its least, and |H|
 * at most 1e12/lambda. */
void range_lambda_h(const CmdInput *in, const Lhg *g, const double *lambda, const double *H);

/* Dies if the coordinate in channel `name` spans more than a thousand times the largest lambda times
 * 1 + T: no two points of the surface are farther apart than that product. */
void range_width(const CmdInput *in, const Lhg *g, const char *name);

/* Dies if a value of f, a field on the nodes of g whose squares are summed, is beyond 1e100.  what:
 * the name of the field in the message. */
void range_field(const CmdInput *in, const Lhg *g, const char *what, const double *f);

/* Dies if a sample of this channel of g is beyond 1e100: the squares of samples are summed. */
void range_channel(const CmdInput *in, const Lhg *g, const char *name);

#endif
