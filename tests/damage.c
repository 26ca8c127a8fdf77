/* damage.c - runs a command on many damaged versions of a file and requires that it refuses each
 * of them: exit 1, nothing on stdout, one line on stderr.
 *
 *   damage cut    STEP FILE COMMAND...     the file is cut to 0, STEP, 2 STEP .. bytes
 *   damage change STEP FILE COMMAND...     the lowest bit of byte 0, STEP, 2 STEP .. is flipped
 *
 * The damaged file is the stdin of COMMAND.  Exits with 0, or prints the first damage that was not
 * refused and exits with 1.
 */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>

static void
need(int ok, const char *what)
{
	if (!ok) {
		perror(what);
		exit(2);
	}
}

static FILE *
file_of(const char *bytes, size_t n)
{
	FILE *f = tmpfile();

	need(f && fwrite(bytes, 1, n, f) == n && fflush(f) == 0, "tmpfile");
	rewind(f);
	return f;
}

static int
one_line(FILE *f)
{
	int c, lines = 0, last = 0;

	rewind(f);
	while ((c = getc(f)) != EOF) {
		lines += c == '\n';
		last = c;
	}
	return lines == 1 && last == '\n';
}

static int
empty(FILE *f)
{
	rewind(f);
	return getc(f) == EOF;
}

static int
refused(const char *bytes, size_t n, char *const command[])
{
	FILE *in = file_of(bytes, n), *out = file_of("", 0), *err = file_of("", 0);
	pid_t pid = fork();
	int status, ok;

	need(pid >= 0, "fork");
	if (pid == 0) {
		dup2(fileno(in), 0);
		dup2(fileno(out), 1);
		dup2(fileno(err), 2);
		execvp(command[0], command);
		_exit(127);
	}
	need(waitpid(pid, &status, 0) == pid, "waitpid");
	ok = WIFEXITED(status) && WEXITSTATUS(status) == 1 && empty(out) && one_line(err);
	fclose(in);
	fclose(out);
	fclose(err);
	return ok;
}

int
main(int argc, char *argv[])
{
	static char bytes[1 << 20];
	size_t n, p, step;
	int cut, ok;
	FILE *f;

	if (argc < 5)
		return 2;
	cut = strcmp(argv[1], "cut") == 0;
	step = strtoul(argv[2], NULL, 10);
	f = fopen(argv[3], "rb");
	need(f != NULL, argv[3]);
	n = fread(bytes, 1, sizeof bytes, f);
	fclose(f);
	for (p = 0; p < n; p += step) {
		bytes[p] ^= !cut;
		ok = refused(bytes, cut ? p : n, argv + 4);
		bytes[p] ^= !cut;
		if (!ok) {
			printf("%s: byte %zu of %s: not refused\n", argv[1], p, argv[3]);
			return 1;
		}
	}
	return n == 0;
}
