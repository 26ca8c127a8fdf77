/* fault.h - lets chosen calls fail, in a test linked with fault.c and the --wrap options. */
#ifndef FAULT_H
#define FAULT_H

/* Calls number from .. to of `call` fail with errno = error.  The first call after fault_set has
 * number 1. */
void fault_set(const char *call, long from, long to, int error);

long fault_seen(void);          /* calls of `call` since fault_set */
long fault_live(void);          /* blocks from C and FFTW not yet freed */

#endif
