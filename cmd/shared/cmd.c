/* cmd.c - messages and options, the same for every command. */
#include <errno.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cmd.h"
#include "private.h"

#define VERSION "0.1"

static struct {
	const char *name, *usage;
	const char *output;
	int         verbose;            /* -1 quiet, 0, 1 */
	char        step[4096];         /* the history line */
	struct timespec began;
	int         progress;           /* a progress line stands on the terminal */
} cmd;

void
cmd_begin(const char *name, const char *usage)
{
	cmd.name = name;
	cmd.usage = usage;
	snprintf(cmd.step, sizeof cmd.step, "%s", name);
	clock_gettime(CLOCK_MONOTONIC, &cmd.began);
	if (descriptor_fill())
		_exit(1);
	signal(SIGXFSZ, SIG_IGN);       /* a file too large is an error of write */
}

int
cmd_end(void)
{
	cmd_progress_end();
	cmd_close_output();
	return 0;
}

/* Control bytes of a file or an argument must not reach the terminal. */
static void
say(const char *fmt, va_list ap)
{
	char line[1024], *s;

	cmd_progress_end();
	vsnprintf(line, sizeof line, fmt, ap);
	for (s = line; *s; s++)
		if ((unsigned char)*s < ' ' || *s == 0x7f)
			*s = '?';
	fprintf(stderr, "%s: %s\n", cmd.name, line);
}

void
die(const char *fmt, ...)
{
	va_list ap;

	cmd_drop_output();
	va_start(ap, fmt);
	say(fmt, ap);
	va_end(ap);
	exit(1);
}

void
misuse(const char *fmt, ...)
{
	char line[900];
	va_list ap;

	va_start(ap, fmt);
	vsnprintf(line, sizeof line, fmt, ap);
	va_end(ap);
	cmd_drop_output();
	fprintf(stderr, "%s: %s (see %s --help)\n", cmd.name, line, cmd.name);
	exit(2);
}

void
note(const char *fmt, ...)
{
	va_list ap;

	va_start(ap, fmt);
	if (cmd.verbose >= 0)
		say(fmt, ap);
	va_end(ap);
}

void
detail(const char *fmt, ...)
{
	va_list ap;

	va_start(ap, fmt);
	if (cmd.verbose > 0)
		say(fmt, ap);
	va_end(ap);
}

void
cmd_progress(const char *fmt, ...)
{
	struct timespec now;
	va_list ap;

	clock_gettime(CLOCK_MONOTONIC, &now);
	if (cmd.verbose < 0 || now.tv_sec - cmd.began.tv_sec < 1 || !isatty(STDERR_FILENO))
		return;
	fprintf(stderr, "\r%s: ", cmd.name);
	va_start(ap, fmt);
	vfprintf(stderr, fmt, ap);
	va_end(ap);
	fputs("\033[K", stderr);
	cmd.progress = 1;
}

void
cmd_progress_end(void)
{
	if (cmd.progress)
		fputs("\r\033[K", stderr);
	cmd.progress = 0;
}

const char *
cmd_output(void)
{
	return cmd.output;
}

const char *
cmd_step(void)
{
	return cmd.step;
}

/* Append one word to the history line, quoted as the shell would need it. */
static void
record(const char *dashes, const char *word, const char *equals, const char *value)
{
	static const char plain[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_-+=.,:/%@";
	const char *quote = value[strspn(value, plain)] ? "'" : "";
	size_t n = strlen(cmd.step);

	snprintf(cmd.step + n, sizeof cmd.step - n, " %s%s%s%s%s%s", dashes, word, equals, quote, value, quote);
}

static const char *
longname(const struct option *o, int c)
{
	while (o->name && o->val != c)
		o++;
	return o->name ? o->name : "?";
}

/* c is '?' or ':' from getopt_long. */
static _Noreturn void
wrong_option(char *argv[], const struct option *o, int c)
{
	if (c == ':' && optopt)
		misuse("option --%s needs a value", longname(o, optopt));
	if (c == ':')
		misuse("option %s needs a value", argv[optind - 1]);
	if (optopt && strncmp(argv[optind - 1], "--", 2) != 0)
		misuse("unknown option -%c", optopt);
	misuse("unknown or ambiguous option %s", argv[optind - 1]);
}

/* After --help and --version. */
static _Noreturn void
answered(void)
{
	if (fflush(stdout) == EOF || ferror(stdout))
		die("stdout: %s", strerror(errno));
	exit(0);
}

int
cmd_getopt(int argc, char *argv[], const char *shortopt, const struct option *longopt)
{
	char all[64];
	int c;

	opterr = 0;
	snprintf(all, sizeof all, ":o:qvh%s", shortopt);
	while ((c = getopt_long(argc, argv, all, longopt, NULL)) != -1)
		switch (c) {
		case 'o': cmd.output = strcmp(optarg, "-") == 0 ? NULL : optarg; break;
		case 'q': cmd.verbose = -1; break;
		case 'v': cmd.verbose = 1; break;
		case 'h': fputs(cmd.usage, stdout); answered();
		case 'V': printf("%s (lhgrid) %s\n", cmd.name, VERSION); answered();
		case ':':
		case '?': wrong_option(argv, longopt, c);
		default:
			if (c < CMD_UNRECORDED)
				record("--", longname(longopt, c), optarg ? "=" : "", optarg ? optarg : "");
			return c;
		}
	return -1;
}

int
cmd_operands(int argc, char *argv[], int min, int max)
{
	int i, n = argc - optind;

	if (n < min)
		misuse("%d operand%s missing", min - n, min - n > 1 ? "s" : "");
	if (n > max)
		misuse("operand %s is one too many", argv[optind + max]);
	for (i = optind; i < argc; i++)
		record("", "", "", argv[i]);
	return n;
}

double
opt_double(const char *s, double lo, double hi, const char *option)
{
	char *end;
	double x = strtod(s, &end);

	if (end == s || *end || !(x >= lo && x <= hi))
		misuse("--%s=%s: need a number in [%g,%g]", option, s, lo, hi);
	return x;
}

long
opt_long(const char *s, long lo, long hi, const char *option)
{
	char *end;
	long x;

	errno = 0;
	x = strtol(s, &end, 10);
	if (end == s || *end || errno || x < lo || x > hi)
		misuse("--%s=%s: need a whole number in [%ld,%ld]", option, s, lo, hi);
	return x;
}

int
opt_word(const char *s, const char *words, const char *option)
{
	const char *w;
	int i;

	for (w = words, i = 0; *w; w += strlen(w) + 1, i++)
		if (strcmp(s, w) == 0)
			return i;
	misuse("--%s=%s: not one of its words", option, s);
}

void *
cmd_alloc(size_t n, size_t size)
{
	void *p = n && size > (size_t)-1/n ? NULL : malloc(n*size + 1);

	if (!p)
		die("no memory: %zu x %zu bytes wanted", n, size);
	return p;
}
