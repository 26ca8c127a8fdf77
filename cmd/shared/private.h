/* private.h - between cmd.c, io.c and descriptor.c. */
#ifndef CMD_PRIVATE_H
#define CMD_PRIVATE_H

#include <stdio.h>

const char *cmd_step(void);     /* the history line of this command */
void cmd_close_output(void);    /* finish -o FILE or stdout, or die */
void cmd_drop_output(void);     /* remove what is half written */

/* A stream over fd, which fclose closes; NULL without memory.  Calls that a signal
 * interrupts, that would block or that move a part go on. */
FILE *descriptor_stream(int fd, const char *mode);

/* Put something in the places of stdin, stdout and stderr where they are closed: the first
 * two then fail when they are used, stderr is lost.  Returns 0 or -1. */
int descriptor_fill(void);

#endif
