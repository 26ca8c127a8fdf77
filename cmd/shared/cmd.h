/* cmd.h - messages, options, input and output of every command.  Only cmd/ may include this: its
 * functions print messages and end the process.
 *
 * Exit codes: 0 the output is complete; 1 the input cannot be processed, or reading, writing or
 * memory failed; 2 the command line is wrong.
 */
#ifndef CMD_H
#define CMD_H

#include <getopt.h>
#include <stddef.h>

#include "../../format/lhg.h"

/* A command begins with cmd_begin(name, usage text) and ends with return cmd_end(). */
void cmd_begin(const char *name, const char *usage);
int  cmd_end(void);             /* closes the output; returns 0, or dies */

/* "name: message" on one line of stderr, with '?' for each byte of control characters and each
 * byte that is not UTF-8.  die exits 1; misuse exits 2 and refers to --help.  note prints nothing
 * under -q, detail only under -v. */
_Noreturn void die(const char *fmt, ...);
_Noreturn void misuse(const char *fmt, ...);
void note(const char *fmt, ...);
void detail(const char *fmt, ...);

/* Options.  cmd_getopt is like getopt_long, but returns only the command's own options.  It handles
 * mistakes and the options that all commands have (-o -j -q -v -h --progress --version --no-history) itself.  The
 * array of long options ends with CMD_LONGOPT.  cmd_getopt also records the command's own options
 * for the history, in their long form, so that a short and a long option give the same bytes. */
#define CMD_LONGOPT \
	{ "output",  required_argument, NULL, 'o' }, \
	{ "no-history", no_argument,    NULL, CMD_NO_HISTORY }, \
	{ "threads", required_argument, NULL, CMD_THREADS }, \
	{ "progress", required_argument, NULL, CMD_PROGRESS }, \
	{ "quiet",   no_argument,       NULL, 'q' }, \
	{ "verbose", no_argument,       NULL, 'v' }, \
	{ "help",    no_argument,       NULL, 'h' }, \
	{ "version", no_argument,       NULL, 'V' }, \
	{ NULL, 0, NULL, 0 }
/* In a usage text: what --help says of these options.  {common}: all but -o and --no-history. */
#define CMD_USAGE_COMMON "{common}\n"
#define CMD_USAGE \
"  -o, --output=FILE  write FILE instead of stdout, complete or not at all\n" \
"      --no-history   write no history: neither this step nor the earlier ones\n" \
CMD_USAGE_COMMON
enum {
	CMD_THREADS = 997,
	CMD_PROGRESS,
	CMD_NO_HISTORY,
	CMD_UNRECORDED          /* options of this value and above change no byte of the result and are
	                         * not recorded in the history */
};
int cmd_getopt(int argc, char *argv[], const char *shortopt, const struct option *longopt);

/* Returns the number of operands after the options; exits 2 unless it is min .. max.  Records the
 * operands for the history.  Operand 0 is argv[optind]. */
int cmd_operands(int argc, char *argv[], int min, int max);

/* The value of s.  Exit 2 unless s is a number in [lo,hi] and nothing else.  option: its name in the
 * message. */
double opt_double(const char *s, double lo, double hi, const char *option);
long   opt_long(const char *s, long lo, long hi, const char *option);

/* The index of s in `words`, where each word ends with a NUL, and the list with one more.  If s is no
 * word of the list, exits 2 with the list in the message. */
int    opt_word(const char *s, const char *words, const char *option);

/* The mark in front of each step of input k of a merge in the history of the result: "A: ", .., "Z: ", "AA: ",
 * .., for k < 26*27. */
enum { CMD_MARKLEN = 5, CMD_MOST_MARKS = 26*27 };
void cmd_mark(int k, char mark[CMD_MARKLEN]);

/* The FILE of the option -o; NULL for stdout. */
const char *cmd_output(void);

/* The name of an input in messages: path, or "stdin" for "-" and NULL. */
const char *cmd_name_of(const char *path);

/* All *n bytes of a file ("-" or NULL: stdin), to be freed.  Dies if there are more than
 * claim_input().  cmd_slurp_if calls look with the first 64 KiB of a longer input.  look dies if no
 * input of the right kind begins with them, so that an endless pipe is refused at once. */
typedef void CmdLook(const char *name, const char *head, size_t n);
char *cmd_slurp(const char *path, size_t *n);
char *cmd_slurp_if(const char *path, CmdLook *look, size_t *n);

/* Exit 2 if the output would go to a terminal: binary data does not belong there. */
void cmd_binary_output(void);

/* Streams of grids.  cmd_open opens path ("-" or NULL: stdin).  cmd_read returns 1 and the next
 * grid, or 0 at the end; or dies with the name of the input and the reason.  cmd_read_one dies
 * unless the input is one grid. */
typedef struct CmdInput {
	const char *name;       /* for messages: the path, or "stdin" */
	LhgStream   s;
} CmdInput;
void cmd_open(CmdInput *in, const char *path);
int  cmd_read(CmdInput *in, Lhg *g);
void cmd_read_one(CmdInput *in, Lhg *g);

/* If path begins like a stream of grids, open it as cmd_open does and return 1.  Otherwise return 0,
 * with all its bytes as from cmd_slurp_if. */
int  cmd_open_or_slurp(CmdInput *in, const char *path, CmdLook *look, char **bytes, size_t *n);

/* Write g to -o or stdout, with the step of this command in its history.  cmd_pass is for a stage
 * that writes one grid for each grid of in: after the last frame of a set, if in has more, it also
 * begins the next header, so that the output is incomplete if this stage then fails or is
 * killed.  cmd_pass_ahead is for one that reads ahead: `next` is the grid after g, or NULL if in has not
 * been read beyond g. */
void cmd_write(Lhg *g);
void cmd_pass(const CmdInput *in, Lhg *g);
void cmd_pass_ahead(const CmdInput *in, Lhg *g, const Lhg *next);

/* Write bytes (not a grid) to path, or to -o or stdout if path is NULL.  One output is open at a
 * time. */
void cmd_write_bytes(const char *path, const void *bytes, size_t n);

/* cmd_need returns the samples of a channel.  It dies if the channel has another support or is
 * missing; the message then names the command that makes it.  cmd_add appends a channel of zeros, or
 * dies. */
double *cmd_need(const CmdInput *in, const Lhg *g, const char *name, int support);
double *cmd_add(Lhg *g, const char *name, const char *unit, int support, int step);

/* Set the value of key in the metadata; fmt as printf's. */
void cmd_meta(Lhg *g, const char *key, const char *fmt, ...);

/* A text in memory, written to the stream f.  After cmd_text_close it is bytes[0..n-1], to be
 * freed.  Both functions die if memory runs out; open_memstream would lose bytes instead. */
typedef struct CmdText {
	FILE  *f;
	char  *bytes;
	size_t n, room;
} CmdText;
void cmd_text_open(CmdText *t);
void cmd_text_close(CmdText *t);

/* malloc, or die with the size. */
void *cmd_alloc(size_t n, size_t size);

/* Says on stderr what is being done, as --progress asks: auto, a line that replaces the previous one,
 * on a terminal, without -q, and after the command has run for a second; always, the same line
 * elsewhere, once a second; json, once a second an object.  cmd_progress_share says that done of
 * total equal parts of the work are done: after five seconds lines then end in the time left, if
 * the rest is as fast.  cmd_write does so for each frame of a set.  cmd_progress_end erases the line. */
void cmd_progress(const char *fmt, ...);
void cmd_progress_share(long done, long total);
void cmd_progress_end(void);

#endif
