/* kinds.h - the kinds of synthetic surfaces as a person sees them. */
#ifndef CMD_KINDS_H
#define CMD_KINDS_H

#include "../../lib/synth/synth.h"

/* head, then every kind with its parameters and formula; free it. */
char *kinds_manual(const char *head);

/* Write the names, one a line. */
void kinds_list(void);

/* Set what an operand NAME=VALUE says, or exit 2; arg is cut at its '='. */
void kinds_set(Synth *s, char *arg);

#endif
