/* cmd.h - what every command shares: messages, options, input and output.
 * Only cmd/ may include this: it talks to a person and ends the process.
 *
 * Exit codes: 0 the output is complete; 1 this input cannot be done, or reading,
 * writing or memory failed; 2 the command line is wrong.
 */
#ifndef CMD_H
#define CMD_H

#include <getopt.h>
#include <stddef.h>

#include "../../format/lhg.h"

/* Every command begins with cmd_begin(name, usage text) and ends with
 * return cmd_end(). */
void cmd_begin(const char *name, const char *usage);
int  cmd_end(void);             /* closes what is open; 0, or dies */

/* "name: message" on stderr; die exits 1, misuse exits 2 and points to --help.
 * note is silent under -q, detail speaks only under -v. */
_Noreturn void die(const char *fmt, ...);
_Noreturn void misuse(const char *fmt, ...);
void note(const char *fmt, ...);
void detail(const char *fmt, ...);

/* Options.  cmd_getopt is getopt_long that deals with the options all commands have
 * (-o -q -v -h --version) and with mistakes by itself and returns only the command's
 * own.  End the array of long options with CMD_LONGOPT.  The history line of the
 * command is kept along the way: own options in their long form, then operands, so
 * that two ways to say the same thing leave the same bytes. */
#define CMD_LONGOPT \
	{ "output",  required_argument, NULL, 'o' }, \
	{ "quiet",   no_argument,       NULL, 'q' }, \
	{ "verbose", no_argument,       NULL, 'v' }, \
	{ "help",    no_argument,       NULL, 'h' }, \
	{ "version", no_argument,       NULL, 'V' }, \
	{ NULL, 0, NULL, 0 }
#define CMD_USAGE \
"  -o, --output=FILE  write FILE instead of stdout; it is whole or it is not there\n" \
"  -q, --quiet        no notes on stderr\n" \
"  -v, --verbose      more words on stderr\n" \
"  -h, --help         print this text\n" \
"      --version      print the version\n"
enum { CMD_UNRECORDED = 1000 };         /* options with such values or above change no byte of
                                         * the result and stay out of the history */
int cmd_getopt(int argc, char *argv[], const char *shortopt, const struct option *longopt);

/* The operands left after the options, at least min and at most max of them; records
 * them in the history line.  Operand 0 is argv[optind]. */
int cmd_operands(int argc, char *argv[], int min, int max);

/* A number that is nothing but a number in [lo,hi], or exit 2. */
double opt_double(const char *s, double lo, double hi, const char *option);
long   opt_long(const char *s, long lo, long hi, const char *option);

/* The number of s among words that each end in NUL, the last one in two, or exit 2. */
int    opt_word(const char *s, const char *words, const char *option);

/* What -o said, or NULL for stdout. */
const char *cmd_output(void);

/* The name of an input in messages: path, or "stdin" for "-" and NULL. */
const char *cmd_name_of(const char *path);

/* All bytes of a file ("-" or NULL: stdin); free them.  Dies of an input above claim_input().
 * cmd_slurp_if gives the first 64 KiB of a longer input to look, which dies if nothing good
 * can follow: an endless pipe is refused at once. */
typedef void CmdLook(const char *name, const char *head, size_t n);
char *cmd_slurp(const char *path, size_t *n);
char *cmd_slurp_if(const char *path, CmdLook *look, size_t *n);

/* Exit 2 now rather than write binary data to a terminal later. */
void cmd_binary_output(void);

/* Streams of grids.  cmd_open reads path ("-" or NULL: stdin).  cmd_read gives the
 * next grid and 1, or 0 at the end; anything else dies with the name of the input and
 * the reason; cmd_read_one dies unless the input is one grid.  cmd_write adds
 * the history line and writes to -o or stdout. */
typedef struct CmdInput {
	const char *name;       /* for messages: the path, or "stdin" */
	LhgStream   s;
} CmdInput;
void cmd_open(CmdInput *in, const char *path);
int  cmd_read(CmdInput *in, Lhg *g);
void cmd_read_one(CmdInput *in, Lhg *g);

/* Open path as cmd_open does and return 1, if its first bytes are those of a stream of
 * grids; else return 0 and all its bytes, to be freed, as cmd_slurp_if. */
int  cmd_open_or_slurp(CmdInput *in, const char *path, CmdLook *look, char **bytes, size_t *n);

void cmd_write(Lhg *g);

/* Write bytes (not a grid) to path, or to -o or stdout when path is NULL. */
void cmd_emit(const char *path, const void *bytes, size_t n);

/* A channel that must be there with that support, or die. */
double *cmd_need(const CmdInput *in, const Lhg *g, const char *name, int support);
double *cmd_add(Lhg *g, const char *name, const char *unit, int support, int step);

/* Set a datum of the metadata, as printf would write it. */
void cmd_meta(Lhg *g, const char *key, const char *fmt, ...);

/* Text written to f, which is bytes[0..n-1] once it is closed; free them.  Both die without
 * memory: open_memstream forgets what it had no memory for. */
typedef struct CmdText {
	FILE  *f;
	char  *bytes;
	size_t n, room;
} CmdText;
void cmd_text_open(CmdText *t);
void cmd_text_close(CmdText *t);

/* malloc or die, saying how much was wanted. */
void *cmd_alloc(size_t n, size_t size);

/* A line on stderr that replaces itself, shown only on a terminal, without -q, and when
 * the work has taken longer than a second.  cmd_done_progress wipes it. */
void cmd_progress(const char *fmt, ...);
void cmd_progress_end(void);

#endif
