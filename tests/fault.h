/* fault.h - calls that fail on demand, in a test linked with fault.c and its --wrap. */
#ifndef FAULT_H
#define FAULT_H

/* Calls number from .. to of call, counted from now and from 1, fail with that errno. */
void fault_set(const char *call, long from, long to, int error);

long fault_seen(void);          /* calls since then */
long fault_live(void);          /* blocks of C's and FFTW's memory that are not freed */

#endif
