/* spectable.h - the table of coefficients that lhfft --spectrum writes. */
#ifndef CMD_SPECTABLE_H
#define CMD_SPECTABLE_H

#include "../shared/cmd.h"
#include "scales.h"

/* Exits with 2 if file is also the output of the grid. */
void opt_spectable(const char *file);

/* Writes the spectra of lambda and H of g, as a tab-separated table, to file, or dies.
 * To be called before cmd_write: one output is open at a time. */
void spectable_write(const char *file, const CmdInput *in, const Lhg *g, const Scales *s);

#endif
