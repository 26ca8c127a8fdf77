/* chosen.h - the channels that lh2png draws. */
#ifndef CMD_CHOSEN_H
#define CMD_CHOSEN_H

#include "../shared/cmd.h"
#include "pageopt.h"

/* Sets c to the channels of g that o names, in the order of the option, or dies.  By default lambda and
 * H, or all if g has neither.  Returns how many. */
int chosen(const CmdInput *in, const Lhg *g, const PageOpt *o, const LhgChannel *c[LHG_MAXCHAN]);

/* Whether the channels are named one by one. */
int chosen_by_name(const PageOpt *o);

#endif
