/* message.c - errors, notes, details and progress on stderr. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "cmd.h"
#include "private.h"

static struct {
	const char *name;
	int         verbose;            /* -1: quiet, 0: notes, 1: details too */
	struct timespec began;
	int         progress;           /* a progress line is on the terminal */
} message;

void
message_begin(const char *name)
{
	message.name = name;
	clock_gettime(CLOCK_MONOTONIC, &message.began);
}

void
message_verbosity(int verbose)
{
	message.verbose = verbose;
}

/* Prints "name: text".  Control characters and bytes that are not UTF-8, which may come from a file
 * or an argument, must not reach the terminal. */
static void
print_safely(const char *fmt, va_list ap)
{
	char text[1024], *s;
	size_t len;

	vsnprintf(text, sizeof text, fmt, ap);
	for (s = text; *s; s += len ? len : 1)
		if (!(len = lhg_utf8(s, strlen(s))))
			*s = '?';
	fprintf(stderr, "%s: %s", message.name, text);
}

/* Prints "name: text tail" on one line. */
static void
print_line(const char *fmt, va_list ap, const char *tail)
{
	cmd_progress_end();
	print_safely(fmt, ap);
	fprintf(stderr, "%s\n", tail);
}

void
die(const char *fmt, ...)
{
	va_list ap;

	cmd_drop_output();
	va_start(ap, fmt);
	print_line(fmt, ap, "");
	va_end(ap);
	exit(1);
}

void
misuse(const char *fmt, ...)
{
	char help[64];
	va_list ap;

	cmd_drop_output();
	snprintf(help, sizeof help, " (see %s --help)", message.name);
	va_start(ap, fmt);
	print_line(fmt, ap, help);
	va_end(ap);
	exit(2);
}

void
note(const char *fmt, ...)
{
	va_list ap;

	va_start(ap, fmt);
	if (message.verbose >= 0)
		print_line(fmt, ap, "");
	va_end(ap);
}

void
detail(const char *fmt, ...)
{
	va_list ap;

	va_start(ap, fmt);
	if (message.verbose > 0)
		print_line(fmt, ap, "");
	va_end(ap);
}

void
cmd_progress(const char *fmt, ...)
{
	struct timespec now;
	va_list ap;

	clock_gettime(CLOCK_MONOTONIC, &now);
	if (message.verbose < 0 || now.tv_sec - message.began.tv_sec < 1 || !isatty(STDERR_FILENO))
		return;
	putc('\r', stderr);
	va_start(ap, fmt);
	print_safely(fmt, ap);
	va_end(ap);
	fputs("\033[K", stderr);
	message.progress = 1;
}

void
cmd_progress_end(void)
{
	if (message.progress)
		fputs("\r\033[K", stderr);
	message.progress = 0;
}
