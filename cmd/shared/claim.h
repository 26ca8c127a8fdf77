/* claim.h - memory that is not there is said so before the work begins. */
#ifndef CMD_CLAIM_H
#define CMD_CLAIM_H

#include <stddef.h>

/* n things of so many bytes each, at most and about, are what `what` will need: die unless
 * the machine has them and the process may.  where: the input, for the message. */
void claim(const char *where, const char *what, double n, double bytes);

#endif
