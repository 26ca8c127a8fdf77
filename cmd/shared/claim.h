/* claim.h - memory that is not there is said so before the work begins. */
#ifndef CMD_CLAIM_H
#define CMD_CLAIM_H

#include <stddef.h>

/* n things of so many bytes each, at most and about, are what `what` will need: die unless
 * the machine has them and the process may.  where: the input, for the message. */
void claim(const char *where, const char *what, double n, double bytes);

/* Bytes of the largest input that is read into memory before it is looked at: half of what the
 * machine has and the process may use, since what is made of it needs as much again, and at
 * most 4 GiB, more than any mesh that can be solved for. */
size_t claim_input(void);

#endif
