/* range.h - input limits within which no stage overflows; beyond them the program dies. */
#ifndef CMD_RANGE_H
#define CMD_RANGE_H

#include "cmd.h"

/* Dies if a coordinate of the positions x[c][k*stride], k < n, is beyond 1e60, or if the positions
 * together are less than 1e-60 wide. */
void range_positions(const char *name, size_t n, int stride, const double *const x[3]);

/* The height T of g: 1e-9 .. 1e9, or die. */
void range_height(const CmdInput *in, const Lhg *g);

/* lambda of g: 1e-60 .. 1e60, the largest at most 1e12 times the least, |H| at most 1e12 over
 * lambda, or die. */
void range_lambda_h(const CmdInput *in, const Lhg *g, const double *lambda, const double *H);

/* No two points of the surface lie farther apart than the largest lambda times 1 + T: die if
 * a coordinate spans more than a thousand times that. */
void range_width(const CmdInput *in, const Lhg *g, const char *name);

/* A field on the nodes of g, computed from channels, whose squares are summed: no value beyond
 * 1e100, or die.  what: its name in the message. */
void range_field(const CmdInput *in, const Lhg *g, const char *what, const double *f);

/* A channel of g whose squares are summed: no sample beyond 1e100, or die. */
void range_channel(const CmdInput *in, const Lhg *g, const char *name);

#endif
