/* output.c - the outputs of every command.  A file appears under its name when it is complete, or
 * not at all. */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "cmd.h"
#include "private.h"

/* An output under way.  A regular file is written in the same folder under a temporary name, and
 * renamed when it is complete; temp is that name, "" if there is none. */
typedef struct Out {
	FILE *f;
	int   fd;
	char  path[PATH_MAX], temp[PATH_MAX + 16];
} Out;

static struct {
	Out         out;
	LhgStream   grids;              /* the stream of grids on out.f, from the first grid on */
} output;

/* Called by the signal handler, too, so it calls only async-signal-safe functions. */
void
cmd_drop_output(void)
{
	if (output.out.temp[0])
		unlink(output.out.temp);
	output.out.temp[0] = '\0';
}

/* Runs with all signals blocked, so the signal that it raises ends the process when it returns. */
static void
on_signal(int sig)
{
	cmd_drop_output();
	signal(sig, SIG_DFL);
	raise(sig);
}

/* Makes the signals that end a process from outside remove the temporary file first, unless they
 * are ignored. */
static void
catch_signals(void)
{
	static const int sig[] = { SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU };
	struct sigaction act = { .sa_handler = on_signal }, was;
	size_t i;

	sigfillset(&act.sa_mask);
	for (i = 0; i < sizeof sig/sizeof *sig; i++)
		if (!sigaction(sig[i], NULL, &was) && was.sa_handler != SIG_IGN)
			sigaction(sig[i], &act, NULL);
}

/* mkstemp with signals blocked: otherwise a signal handler could find an incomplete name. */
static int
open_temp(char *name)
{
	sigset_t all, was;
	int fd;

	sigfillset(&all);
	sigprocmask(SIG_SETMASK, &all, &was);
	fd = mkstemp(name);
	if (fd < 0)
		name[0] = '\0';
	else
		catch_signals();
	sigprocmask(SIG_SETMASK, &was, NULL);
	return fd;
}

/* Copies the n bytes at rest, and a NUL, to offset dir of `to`; dies with path in the message if
 * there is no room. */
static void
put_path(const char *path, char to[PATH_MAX], size_t dir, const char *rest, size_t n)
{
	if (dir + n >= PATH_MAX)
		die("%s: %s", path, strerror(ENAMETOOLONG));
	memcpy(to + dir, rest, n);
	to[dir + n] = '\0';
}

/* The path that symbolic links lead to, so that the file is replaced and not the link.  A dangling
 * link leads to the file that will be made. */
void
output_follow_links(const char *path, char *to)
{
	char link[PATH_MAX], *slash;
	int left = 40;                          /* more links are a loop, as for Linux */
	ssize_t n;

	put_path(path, to, 0, path, strlen(path));
	while ((n = readlink(to, link, sizeof link)) >= 0) {
		if (left-- == 0)
			die("%s: %s", path, strerror(ELOOP));
		slash = link[0] == '/' ? NULL : strrchr(to, '/');
		put_path(path, to, slash ? (size_t)(slash + 1 - to) : 0, link, (size_t)n);
	}
}

/* A template for mkstemp in the folder of path.  It holds the name of the file where the file
 * system allows names that long. */
static void
temp_name(const char *path, char temp[PATH_MAX + 16])
{
	const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
	size_t dir = (size_t)(name - path);
	long most;

	memcpy(temp, path, dir);
	strcpy(temp + dir, ".");
	most = pathconf(temp, _PC_NAME_MAX);
	if (strlen(name) + strlen("..XXXXXX") <= (size_t)(most > 0 ? most : NAME_MAX))
		strcat(strcat(temp, name), ".");
	strcat(temp, "XXXXXX");
}

/* Gives fd the mode and, where this process may, the owner and group of the file that it
 * replaces.  If it may not set the group, the group's permissions are cut to those of others. */
static int
keep_access(int fd, const struct stat *was)
{
	mode_t mode = was->st_mode & 0777;
	struct stat st;

	if (fchown(fd, was->st_uid, was->st_gid) && fchown(fd, (uid_t)-1, was->st_gid)
	    && (fstat(fd, &st) || st.st_gid != was->st_gid))
		mode &= ~070u | (mode & 07) << 3;
	return fchmod(fd, mode);
}

/* Opens a new file in the folder of o->path, with the permissions of the file it replaces (was),
 * or if was is NULL those of any new file. */
static void
open_beside(Out *o, const struct stat *was)
{
	mode_t mask = umask(0);

	umask(mask);
	temp_name(o->path, o->temp);
	if ((o->fd = open_temp(o->temp)) < 0 || (was ? keep_access(o->fd, was) : fchmod(o->fd, 0666 & ~mask)))
		die("%s: %s", o->path, strerror(errno));
}

static void
out_open(Out *o, const char *path)
{
	struct stat st;
	int there = path && stat(path, &st) == 0;

	o->temp[0] = '\0';
	o->fd = STDOUT_FILENO;
	snprintf(o->path, sizeof o->path, "%s", path && strlen(path) < sizeof o->path ? path : "stdout");
	if (there && S_ISDIR(st.st_mode))
		die("%s: %s", path, strerror(EISDIR));
	if (there && !S_ISREG(st.st_mode)) {            /* a device or a pipe is written in place */
		if ((o->fd = open(path, O_WRONLY)) < 0)
			die("%s: %s", path, strerror(errno));
	} else if (path) {
		output_follow_links(path, o->path);
		open_beside(o, there ? &st : NULL);
	}
	if (!(o->f = descriptor_stream(o->fd, "wb")))
		die("%s: %s", o->path, strerror(errno));
}

static void
out_close(Out *o)
{
	int bad = fflush(o->f) == EOF || ferror(o->f);

	if (!bad && o->temp[0])
		bad = fsync(o->fd) != 0;
	bad |= fclose(o->f) == EOF;
	o->f = NULL;
	if (bad || (o->temp[0] && rename(o->temp, o->path)))
		die("%s: %s", o->path, strerror(errno));
	o->temp[0] = '\0';
}

void
cmd_close_output(void)
{
	if (output.out.f)
		out_close(&output.out);
}

void
cmd_binary_output(void)
{
	if (!cmd_output() && isatty(STDOUT_FILENO))
		misuse("stdout is a terminal: binary data goes to a pipe, a file or -o FILE");
}

void
cmd_write(Lhg *g)
{
	char *past = g->hist;
	int e;

	if (!output.out.f) {
		out_open(&output.out, cmd_output());
		lhg_open(&output.grids, output.out.f);
	}
	g->hist = history_with_step(past);
	e = lhg_write(&output.grids, g);
	free(g->hist);
	g->hist = past;
	if (e)
		die("%s: %s", output.out.path, output.grids.err);
	cmd_progress_share(g->frame, g->frames);
}

void
cmd_pass_ahead(const CmdInput *in, Lhg *g, const Lhg *next)
{
	int version = next ? lhg_version(next) : in->s.ahead;

	cmd_write(g);
	if (g->frame == g->frames && version > 0 && lhg_begin_next(&output.grids, version))
		die("%s: %s", output.out.path, output.grids.err);
}

void
cmd_pass(const CmdInput *in, Lhg *g)
{
	cmd_pass_ahead(in, g, NULL);
}

void
cmd_write_bytes(const char *path, const void *bytes, size_t n)
{
	out_open(&output.out, path ? path : cmd_output());
	if (fwrite(bytes, 1, n, output.out.f) != n)
		die("%s: %s", output.out.path, strerror(errno));
	out_close(&output.out);
}
