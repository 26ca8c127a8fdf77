/* spectable.h - the option --spectrum of lhfft. */
#ifndef CMD_SPECTABLE_H
#define CMD_SPECTABLE_H

#include "../shared/cmd.h"
#include "scales.h"

/* Exit 2 when FILE cannot be a file of its own. */
void opt_spectable(const char *file);

/* Write the spectra of lambda and H of g, as a table of tabs and lines, to FILE, or die.
 * To be called before cmd_write: one output is open at a time. */
void spectable_write(const char *file, const CmdInput *in, const Lhg *g, const Scales *s);

#endif
