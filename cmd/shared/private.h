/* private.h - shared by the files of cmd/shared; not for the commands. */
#ifndef CMD_PRIVATE_H
#define CMD_PRIVATE_H

#include <stdio.h>

#define CMD_VERSION "0.2.0"

/* ---- message.c ---- */

/* Sets the name that begins every message. */
void message_begin(const char *name);

/* -1 silences notes and progress, 1 shows details. */
void message_verbosity(int verbose);
int  message_quiet(void);

/* Replaces control characters, and bytes that are not UTF-8, by '?'. */
void message_make_safe(char *s);

/* ---- progress.c ---- */

/* Sets the name that begins every line, and starts the clock. */
void progress_begin(const char *name);

/* The value of --progress, as an index of PROGRESS_WAYS. */
#define PROGRESS_WAYS "auto\0always\0never\0json\0"
void progress_way(int way);

/* ---- usage.c ---- */

/* Prints a usage text to f in lines of at most 80 columns, with the common options in the place of
 * CMD_USAGE_COMMON. */
void usage_print(FILE *f, const char *text);

/* ---- history.c: the step of this command ---- */

void history_begin(const char *name);

/* Adds a word to the step: dashes, word and equals as they are, then value, quoted for a shell.  An
 * empty value is an operand '' if dashes and word are empty; otherwise nothing is added for it.  A
 * step of more than 3600 bytes ends in " ..." after the last word that fits. */
void history_word(const char *dashes, const char *word, const char *equals, const char *value);

/* For --no-history: results have no history. */
void history_none(void);

/* The history of a result, to be freed: the lines `past`, which may be NULL, and the step of this
 * command; NULL with --no-history.  If it has more than 16384 bytes, the oldest steps are summarised
 * in one line, LHG.md 2.4. */
char *history_with_step(const char *past);

/* ---- output.c ---- */

void cmd_close_output(void);    /* finish -o FILE or stdout, or die */
void cmd_drop_output(void);     /* remove an incomplete file */

/* Sets to[PATH_MAX] to the path of the file that an output to path replaces: symbolic links are
 * followed, dangling ones too.  Dies if the links form a loop. */
void output_follow_links(const char *path, char *to);

/* ---- descriptor.c ---- */

/* A stream over fd, or NULL if memory runs out.  fclose closes fd, too.  Reads and writes that a
 * signal interrupts, that would block, or that move only a part of the bytes are continued. */
FILE *descriptor_stream(int fd, const char *mode);

/* Opens /dev/null in place of stdin, stdout and stderr if they are closed, so that no file opened
 * later gets their numbers.  stdin and stdout then fail when they are used; messages to stderr are
 * lost.  Returns 0 or -1. */
int descriptor_fill(void);

/* Limits OpenMP to four threads for each processor, even if OMP_NUM_THREADS asks for more: every
 * thread takes memory for its stack. */
void threads_limit(void);

/* Limits OpenMP to n threads, for -j. */
void threads_set(long n);

#endif
