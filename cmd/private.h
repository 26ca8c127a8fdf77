/* private.h - between cmd.c and io.c. */
#ifndef CMD_PRIVATE_H
#define CMD_PRIVATE_H

const char *cmd_step(void);     /* the history line of this command */
void cmd_close_output(void);    /* finish -o FILE or stdout, or die */
void cmd_drop_output(void);     /* remove what is half written */

#endif
