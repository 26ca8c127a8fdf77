/* cmd.c - beginning, end, options and operands, the same for every command. */
#include <errno.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cmd.h"
#include "private.h"

static struct {
	const char *name, *usage, *output;
} cmd;

void
cmd_begin(const char *name, const char *usage)
{
	cmd.name = name;
	cmd.usage = usage;
	message_begin(name);
	history_begin(name);
	if (descriptor_fill())
		_exit(1);
	signal(SIGXFSZ, SIG_IGN);       /* a file that grows too large makes write() fail */
	threads_limit();
}

int
cmd_end(void)
{
	cmd_progress_end();
	cmd_close_output();
	return 0;
}

const char *
cmd_output(void)
{
	return cmd.output;
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
	if (c == ':' && optopt == 'j')
		misuse("option --threads needs a value");
	if (c == ':' && optopt)
		misuse("option --%s needs a value", longname(o, optopt));
	if (c == ':')
		misuse("option %s needs a value", argv[optind - 1]);
	if (optopt && strncmp(argv[optind - 1], "--", 2) != 0)
		misuse("unknown option -%c", optopt);
	misuse("unknown or ambiguous option %s", argv[optind - 1]);
}

/* Ends the program after --help or --version. */
static _Noreturn void
exit_answered(void)
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
	snprintf(all, sizeof all, ":o:j:qvh%s", shortopt);
	while ((c = getopt_long(argc, argv, all, longopt, NULL)) != -1)
		switch (c) {
		case 'o': cmd.output = strcmp(optarg, "-") == 0 ? NULL : optarg; break;
		case 'q': message_verbosity(-1); break;
		case 'v': message_verbosity(1); break;
		case 'j':
		case CMD_THREADS: threads_set(opt_long(optarg, 1, 65536, "threads")); break;
		case CMD_PROGRESS: progress_way(opt_word(optarg, PROGRESS_WAYS, "progress")); break;
		case 'h': usage_print(stdout, cmd.usage); exit_answered();
		case 'V': printf("%s (lhgrid) %s\n", cmd.name, CMD_VERSION); exit_answered();
		case CMD_NO_HISTORY: history_none(); break;
		case ':':
		case '?': wrong_option(argv, longopt, c);
		default:
			if (c < CMD_UNRECORDED)
				history_word("--", longname(longopt, c), optarg ? "=" : "", optarg ? optarg : "");
			return c;
		}
	return -1;
}

int
cmd_operands(int argc, char *argv[], int min, int max)
{
	int i, n = argc - optind, dashed = 0;

	if (n < min)
		misuse("%d operand%s missing", min - n, min - n > 1 ? "s" : "");
	if (n > max)
		misuse("operand %s is one too many", argv[optind + max]);
	for (i = optind; i < argc; i++)
		dashed |= argv[i][0] == '-' && argv[i][1];
	if (dashed)                     /* without --, such operands would be read as options */
		history_word("--", "", "", "");
	for (i = optind; i < argc; i++)
		history_word("", "", "", argv[i]);
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
	char list[128] = "";
	const char *w, *next;
	int i;

	for (w = words, i = 0; *w; w += strlen(w) + 1, i++)
		if (strcmp(s, w) == 0)
			return i;
	for (w = words; *w; w = next) {
		next = w + strlen(w) + 1;
		snprintf(list + strlen(list), sizeof list - strlen(list), "%s%s",
		    w == words ? "" : *next ? ", " : " or ", w);
	}
	misuse("--%s=%s: need %s", option, s, list);
}

void *
cmd_alloc(size_t n, size_t size)
{
	void *p = n && size > (size_t)-1/n ? NULL : malloc(n*size + 1);

	if (!p)
		die("no memory: %zu x %zu bytes wanted", n, size);
	return p;
}
