/* range.h - input limits within which no stage overflows; beyond them the program dies. */
#ifndef CMD_RANGE_H
#define CMD_RANGE_H

#include "cmd.h"

/* Dies if a coordinate of the positions x[c][k*stride], k < n, is beyond 1e60, or if the positions
 * together are less than 1e-60 wide. */
void range_positions(const char *name, size_t n, int stride, const double *const x[3]);

/* Dies unless the height T of g is in 1e-9 .. 1e9. */
void range_height(const CmdInput *in, const Lhg *g);

/* Dies unless lambda is in 1e-60 .. 1e60, its largest value at most 1e12 times its least, and |H|
 * at most 1e12/lambda. */
void range_lambda_h(const CmdInput *in, const Lhg *g, const double *lambda, const double *H);

/* No two points of the surface lie farther apart than the largest lambda times 1 + T: die if
 * a coordinate spans more than a thousand times that. */
void range_width(const CmdInput *in, const Lhg *g, const char *name);

/* A field on the nodes of g, computed from channels, whose squares are summed: no value beyond
 * 1e100, or die.  what: its name in the message. */
void range_field(const CmdInput *in, const Lhg *g, const char *what, const double *f);

/* Dies if a sample of this channel of g, whose squares are summed, is beyond 1e100. */
void range_channel(const CmdInput *in, const Lhg *g, const char *name);

#endif
