/* message.c - errors, notes and details on stderr. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd.h"
#include "private.h"

static struct {
	const char *name;
	int         verbose;            /* -1: quiet, 0: notes, 1: details too */
} message;

void
message_begin(const char *name)
{
	message.name = name;
	progress_begin(name);
}

void
message_verbosity(int verbose)
{
	message.verbose = verbose;
}

int
message_quiet(void)
{
	return message.verbose < 0;
}

void
message_make_safe(char *s)
{
	size_t len;

	for (; *s; s += len ? len : 1)
		if (!(len = lhg_utf8(s, strlen(s))))
			*s = '?';
}

/* Prints "name: text tail" on one line. */
static void
print_line(const char *fmt, va_list ap, const char *tail)
{
	char text[1024];

	cmd_progress_end();
	vsnprintf(text, sizeof text, fmt, ap);
	message_make_safe(text);
	fprintf(stderr, "%s: %s%s\n", message.name, text, tail);
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
