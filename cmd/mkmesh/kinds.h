/* kinds.h - the kinds of synthetic surfaces in usage text and operands. */
#ifndef CMD_KINDS_H
#define CMD_KINDS_H

#include "../../lib/synth/synth.h"

/* The usage text: head, then every kind with its parameters and formula; free it. */
char *kinds_manual(const char *head);

/* Write the names, one on each line. */
void kinds_list(void);

/* Set the parameter of an operand NAME=VALUE, or exit 2; arg is cut at its '='. */
void kinds_set(Synth *s, char *arg);

#endif
