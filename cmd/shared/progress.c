/* progress.c - what is being done, and for how long still, on stderr. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "cmd.h"
#include "json.h"
#include "private.h"

enum { AUTO, ALWAYS, NEVER, JSON };     /* PROGRESS_WAYS */

static const double LEFT_AFTER = 5;     /* seconds of work from which on the rest can be told */

static struct {
	const char *name;
	int    way;
	int    shown;                   /* a line is on the terminal */
	struct timespec began;
	double last;                    /* seconds at the last line of ALWAYS and JSON; -1: none yet */
	long   done, total;             /* parts of the work; total 0: unknown */
} progress = { .last = -1 };

void
progress_begin(const char *name)
{
	progress.name = name;
	clock_gettime(CLOCK_MONOTONIC, &progress.began);
}

void
progress_way(int way)
{
	progress.way = way;
}

static double
seconds(void)
{
	struct timespec now;

	clock_gettime(CLOCK_MONOTONIC, &now);
	return (double)(now.tv_sec - progress.began.tv_sec) + 1e-9*(double)(now.tv_nsec - progress.began.tv_nsec);
}

/* Seconds until the end after s seconds, if what is left is as fast; -1: unknown. */
static double
left_after(double s)
{
	if (s < LEFT_AFTER || progress.done < 1)
		return -1;
	return s*(double)(progress.total - progress.done)/(double)progress.done;
}

static int
due(double s)
{
	if (progress.way == AUTO)
		return s >= 1 && isatty(STDERR_FILENO);
	if (progress.way == NEVER || (progress.last >= 0 && s - progress.last < 1))
		return 0;
	progress.last = s;
	return 1;
}

static void
print_object(double s, const char *text)
{
	const double left = left_after(s);

	fputs("{ \"program\": ", stderr);
	json_string(stderr, progress.name);
	fputs(", \"doing\": ", stderr);
	json_string(stderr, text);
	fprintf(stderr, ", \"seconds\": %.1f, \"left\": ", s);
	fprintf(stderr, left < 0 ? "null }\n" : "%.1f }\n", left);
}

static void
print_text(double s, const char *text)
{
	const int terminal = isatty(STDERR_FILENO);
	const double left = left_after(s);

	fprintf(stderr, "%s%s: %s", terminal ? "\r" : "", progress.name, text);
	if (left >= 0)
		fprintf(stderr, ", %.0f s left", left);
	fputs(terminal ? "\033[K" : "\n", stderr);
	progress.shown = terminal;
}

void
cmd_progress(const char *fmt, ...)
{
	const double s = seconds();
	char text[1024];
	va_list ap;

	if (message_quiet() || !due(s))
		return;
	va_start(ap, fmt);
	vsnprintf(text, sizeof text, fmt, ap);
	va_end(ap);
	message_make_safe(text);
	(progress.way == JSON ? print_object : print_text)(s, text);
}

void
cmd_progress_share(long done, long total)
{
	progress.done = done;
	progress.total = total;
}

void
cmd_progress_end(void)
{
	if (progress.shown)
		fputs("\r\033[K", stderr);
	progress.shown = 0;
}
