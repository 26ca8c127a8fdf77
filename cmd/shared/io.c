/* io.c - input and output of every command: slurped files, streams of grids, and
 * outputs that are whole or not there. */
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "claim.h"
#include "cmd.h"
#include "private.h"

/* An output under way.  A regular file is written beside its place, under a name of
 * its own, and renamed when whole; temp is that name, "" when there is none. */
typedef struct Out {
	FILE *f;
	int   fd;
	char  path[PATH_MAX], temp[PATH_MAX + 16];
} Out;

static struct {
	Out         out;
	LhgStream   grids;              /* on out.f, once a grid is written */
	FILE       *in;                 /* stdin, once it is read */
} io;

/* ---- output ---------------------------------------------------------- */

/* Signal handler and die: async-signal-safe. */
void
cmd_drop_output(void)
{
	if (io.out.temp[0])
		unlink(io.out.temp);
	io.out.temp[0] = '\0';
}

/* With all signals held back until it returns: then this one ends the process. */
static void
on_signal(int sig)
{
	cmd_drop_output();
	signal(sig, SIG_DFL);
	raise(sig);
}

/* Where path leads: symbolic links are followed, so that the file is replaced and
 * not the link. */
static void
resolve(Out *o, const char *path)
{
	char *real = realpath(path, NULL);

	if (strlen(real ? real : path) >= sizeof o->path) {
		free(real);
		die("%s: %s", path, strerror(ENAMETOOLONG));
	}
	strcpy(o->path, real ? real : path);
	free(real);
}

/* The signals that end a process from outside: those that are not ignored also remove
 * the file. */
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

/* mkstemp, in whose midst no signal comes: it would find half a name. */
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

/* A new file beside o->path with the permissions a plain open would give. */
static void
open_beside(Out *o)
{
	const char *slash = strrchr(o->path, '/');
	int dir = slash ? (int)(slash + 1 - o->path) : 0;
	mode_t mask = umask(0);

	umask(mask);
	snprintf(o->temp, sizeof o->temp, "%.*s.%s.XXXXXX", dir, o->path, o->path + dir);
	if ((o->fd = open_temp(o->temp)) < 0 || fchmod(o->fd, 0666 & ~mask))
		die("%s: %s", o->path, strerror(errno));
}

/* A place that is no regular file (a device, a pipe) is written in place. */
static void
out_open(Out *o, const char *path)
{
	struct stat st;

	o->temp[0] = '\0';
	o->fd = STDOUT_FILENO;
	if (path) {
		resolve(o, path);
		if (stat(o->path, &st) == 0 && S_ISDIR(st.st_mode))
			die("%s: %s", path, strerror(EISDIR));
		if (stat(o->path, &st) != 0 || S_ISREG(st.st_mode))
			open_beside(o);
		else if ((o->fd = open(o->path, O_WRONLY)) < 0)
			die("%s: %s", path, strerror(errno));
	} else
		strcpy(o->path, "stdout");
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
	if (io.out.f)
		out_close(&io.out);
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
	if (!io.out.f) {
		out_open(&io.out, cmd_output());
		lhg_open(&io.grids, io.out.f);
	}
	if (lhg_note(g, cmd_step()))
		die("no memory for the history");
	if (lhg_write(&io.grids, g))
		die("%s: %s", io.out.path, io.grids.err);
}

void
cmd_emit(const char *path, const void *bytes, size_t n)
{
	out_open(&io.out, path ? path : cmd_output());
	if (fwrite(bytes, 1, n, io.out.f) != n)
		die("%s: %s", io.out.path, strerror(errno));
	out_close(&io.out);
}

/* ---- input ----------------------------------------------------------- */

const char *
cmd_name_of(const char *path)
{
	return path && strcmp(path, "-") != 0 ? path : "stdin";
}

static FILE *
in_open(const char *path)
{
	int file = cmd_name_of(path) == path, fd = file ? open(path, O_RDONLY) : STDIN_FILENO;
	FILE *f = !file && io.in ? io.in : fd < 0 ? NULL : descriptor_stream(fd, "rb");

	if (!f)
		die("%s: %s", cmd_name_of(path), strerror(errno));
	if (!file)
		io.in = f;
	return f;
}

/* stdin stays open for whoever asks again. */
static void
in_close(FILE *f)
{
	if (f != io.in)
		fclose(f);
}

/* All of f behind the *n bytes at head, which were read before; closes f.  look, if not NULL, is
 * given the first 64 KiB of a longer input. */
static char *
slurp(FILE *f, const char *name, CmdLook *look, const char *head, size_t *n)
{
	const size_t first = 1 << 16, most = claim_input();
	size_t room = first;
	char *s = cmd_alloc(room, 1), *more;

	memcpy(s, head, *n);
	while ((*n += fread(s + *n, 1, room - *n, f)) == room) {
		if (room == first && look)
			look(name, s, room);
		if (room > most)
			die("%s: more than %zu bytes: the most that is read is half of the memory, up to 4 GiB",
			    name, most);
		room = room <= most/2 ? 2*room : most + 1;
		if (!(more = realloc(s, room)))
			die("%s: no memory: %zu bytes wanted", name, room);
		s = more;
	}
	if (ferror(f))
		die("%s: %s", name, strerror(errno));
	in_close(f);
	return s;
}

char *
cmd_slurp(const char *path, size_t *n)
{
	return cmd_slurp_if(path, NULL, n);
}

char *
cmd_slurp_if(const char *path, CmdLook *look, size_t *n)
{
	*n = 0;
	return slurp(in_open(path), cmd_name_of(path), look, "", n);
}

int
cmd_open_or_slurp(CmdInput *in, const char *path, CmdLook *look, char **bytes, size_t *n)
{
	char head[sizeof LHG_MAGIC - 1];
	FILE *f = in_open(path);

	in->name = cmd_name_of(path);
	*n = fread(head, 1, sizeof head, f);
	if (*n == sizeof head && memcmp(head, LHG_MAGIC, sizeof head) == 0) {
		lhg_open_behind_magic(&in->s, f);
		return 1;
	}
	*bytes = slurp(f, in->name, look, head, n);
	return 0;
}

void
cmd_open(CmdInput *in, const char *path)
{
	in->name = cmd_name_of(path);
	lhg_open(&in->s, in_open(path));
}

int
cmd_read(CmdInput *in, Lhg *g)
{
	int got = lhg_read(&in->s, g);

	if (got < 0)
		die("%s: %s", in->name, in->s.err);
	if (!got)
		in_close(in->s.f);
	return got;
}

void
cmd_read_one(CmdInput *in, Lhg *g)
{
	Lhg more;

	cmd_read(in, g);
	if (g->frames > 1 || cmd_read(in, &more))
		die("%s: holds several grids, need one", in->name);
}

double *
cmd_need(const CmdInput *in, const Lhg *g, const char *name, int support)
{
	static const char *const word[] = { "grid", "border", "lattice" };
	LhgChannel *c = lhg_find(g, name);

	if (!c)
		die("%s: no channel %s", in->name, name);
	if (c->support != support)
		die("%s: channel %s has support %s, need %s", in->name, name, word[c->support], word[support]);
	return c->f;
}

double *
cmd_add(Lhg *g, const char *name, const char *unit, int support, int step)
{
	double *f = lhg_add(g, name, unit, support, step);

	if (!f)
		die("no memory or no room for channel %s", name);
	return f;
}

void
cmd_meta(Lhg *g, const char *key, const char *fmt, ...)
{
	char value[256];
	va_list ap;

	va_start(ap, fmt);
	vsnprintf(value, sizeof value, fmt, ap);
	va_end(ap);
	if (lhg_setmeta(g, key, value))
		die("no memory for the metadata");
}
