/* claim.h - reports too little memory before the work begins. */
#ifndef CMD_CLAIM_H
#define CMD_CLAIM_H

#include <stddef.h>

/* Dies if n*bytes, about the most memory that a computation needs, is more than the machine has or
 * the process may use.  what: the computation, where: its input, both for the message. */
void claim(const char *where, const char *what, double n, double bytes);

/* Prints a note if n*bytes, the most that a computation may need, is more than that. */
void claim_possible(const char *where, const char *what, double n, double bytes);

/* Bytes of the largest input that is read into memory: half of the memory that the machine has
 * and the process may use, since its mesh needs as much again; and at most 4 GiB, more than any
 * mesh that can be mapped. */
size_t claim_input(void);

#endif
