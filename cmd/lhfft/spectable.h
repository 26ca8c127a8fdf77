/* spectable.h - the table of coefficients that lhfft --spectrum writes. */
#ifndef CMD_SPECTABLE_H
#define CMD_SPECTABLE_H

#include "../shared/cmd.h"
#include "scales.h"

/* Exit 2 if the grid is written to FILE, too. */
void opt_spectable(const char *file);

/* Write the spectra of lambda and H of g, as a tab-separated table, to FILE, or die.
 * To be called before cmd_write: one output is open at a time. */
void spectable_write(const char *file, const CmdInput *in, const Lhg *g, const Scales *s);

#endif
