/* fault.h - calls that fail on demand, in a test linked with fault.c and its --wrap. */
#ifndef FAULT_H
#define FAULT_H

/* From now on, counted from 1, calls number from .. to of `call` fail with that errno. */
void fault_set(const char *call, long from, long to, int error);

long fault_seen(void);          /* calls since fault_set */
long fault_live(void);          /* blocks allocated by C and FFTW and not yet freed */

#endif
