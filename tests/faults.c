/* faults.c - runs a command that is linked with fault.c again and again.  In each run another call
 * fails, and the outcome must be as required.
 *
 *   faults refused CALL ERROR SHARE COMMAND...     exit 1, one line on stderr; stdout empty,
 *                                                  or incomplete if CALL is write
 *   faults ignored CALL ERROR SHARE COMMAND...     exit 0, the same stdout as without a fault
 *
 * After the run in which call N fails comes one in which call N + 1 + N/SHARE fails.  For
 * `refused`, runs in which only this call fails alternate with runs in which it and all later
 * calls fail; for `ignored`, only this call fails.  If SOAK is set, each of the first 2000 calls
 * fails, for `refused` in both ways, and SHARE is 100 for later calls.  ERROR is a value of errno,
 * or short (fault.c).  Exits with 0, or prints the first fault with another outcome and exits with 1.
 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct Run {
	int   status;
	FILE *out, *err;
} Run;

static void
need(int ok, const char *what)
{
	if (!ok) {
		perror(what);
		exit(2);
	}
}

static Run
run(char *const command[], const char *fault)
{
	Run r = { 0, tmpfile(), tmpfile() };
	pid_t pid;

	need(r.out && r.err, "tmpfile");
	need(setenv("FAULT", fault, 1) == 0, "setenv");
	need((pid = fork()) >= 0, "fork");
	if (pid == 0) {
		lseek(0, 0, SEEK_SET);
		dup2(fileno(r.out), 1);
		dup2(fileno(r.err), 2);
		execvp(command[0], command);
		_exit(127);
	}
	need(waitpid(pid, &r.status, 0) == pid, "waitpid");
	rewind(r.out);
	rewind(r.err);
	return r;
}

static void
done(Run *r)
{
	fclose(r->out);
	fclose(r->err);
}

/* Whether f is one line that begins with the name of the command. */
static int
one_line(FILE *f, const char *command)
{
	const char *s = strrchr(command, '/') ? strrchr(command, '/') + 1 : command;
	int c, lines = 0, last = 0;

	for (; *s; s++)
		if (getc(f) != *s)
			return 0;
	while ((c = getc(f)) != EOF) {
		lines += c == '\n';
		last = c;
	}
	return lines == 1 && last == '\n';
}

static int
equal(FILE *a, FILE *b)
{
	int c;

	rewind(b);
	while ((c = getc(a)) == getc(b))
		if (c == EOF)
			return 1;
	return 0;
}

static int
empty(FILE *f)
{
	return getc(f) == EOF;
}

/* Reads the number of calls from the file that FAULT_COUNT named. */
static long
count(const char *name)
{
	FILE *f = fopen(name, "r");
	long n = 0;

	need(f && fscanf(f, "%ld", &n) == 1, name);
	fclose(f);
	return n;
}

static int
good(int refused, int partly, const char *command, Run *r, FILE *whole)
{
	if (!WIFEXITED(r->status))
		return 0;
	if (!refused)
		return WEXITSTATUS(r->status) == 0 && equal(r->out, whole);
	return WEXITSTATUS(r->status) == 1 && one_line(r->err, command) &&
	    (partly ? !equal(r->out, whole) : empty(r->out));
}

static int
fault(char *argv[], long n, const char *more, FILE *whole)
{
	int refused = strcmp(argv[1], "refused") == 0, partly = strcmp(argv[2], "write") == 0, ok;
	char what[80];
	Run r;

	snprintf(what, sizeof what, "%s %ld%s %s", argv[2], n, more, argv[3]);
	r = run(argv + 5, what);
	ok = good(refused, partly, argv[5], &r, whole);
	if (!ok) {
		printf("%s: FAULT='%s': not %s, status %x:\n", argv[5], what, argv[1], r.status);
		rewind(r.err);
		for (n = 0; n < 1000 && (ok = getc(r.err)) != EOF; n++)
			putchar(ok);
		ok = 0;
	}
	done(&r);
	return ok;
}

int
main(int argc, char *argv[])
{
	int soak = getenv("SOAK") != NULL, ok = 1, tries = 0, lasting;
	char name[] = "/tmp/faults.XXXXXX", what[80];
	long n, all, share;
	Run whole;

	if (argc < 6)
		return 2;
	share = soak ? 100 : atol(argv[4]);
	need(close(mkstemp(name)) == 0 && setenv("FAULT_COUNT", name, 1) == 0, name);
	snprintf(what, sizeof what, "%s 0 1", argv[2]);
	whole = run(argv + 5, what);
	all = count(name);
	unlink(name);
	unsetenv("FAULT_COUNT");
	if (whole.status != 0 || all == 0) {
		printf("%s: status %x, %ld calls of %s without a fault\n", argv[5], whole.status, all, argv[2]);
		return 1;
	}
	lasting = strcmp(argv[1], "refused") == 0;
	for (n = 1; ok && n <= all; n += soak && n < 2000 ? 1 : 1 + n/share, tries++) {
		if (soak || !lasting || tries%2 == 0)
			ok = fault(argv, n, "", whole.out);
		if (ok && lasting && (soak || tries%2 == 1))
			ok = fault(argv, n, "+", whole.out);
	}
	done(&whole);
	return !ok;
}
