/* fault.h - lets chosen calls fail in a test that is linked with fault.c and the --wrap options. */
#ifndef FAULT_H
#define FAULT_H

/* Lets the calls from .. to of `call` (see fault.c) fail with errno = error.  They are counted from 1
 * since fault_set. */
void fault_set(const char *call, long from, long to, int error);

long fault_seen(void);          /* calls of `call` since fault_set */
long fault_live(void);          /* blocks allocated by C code and FFTW and not yet freed */

#endif
