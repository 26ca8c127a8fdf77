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

#include "cmd.h"
#include "private.h"

/* An output under way.  A regular file is written beside its place, under a name of
 * its own, and renamed when whole; temp is that name, "" when there is none. */
typedef struct Out {
	FILE *f;
	char  path[PATH_MAX], temp[PATH_MAX + 16];
} Out;

static struct {
	Out         out;
	LhgStream   grids;              /* on out.f, once a grid is written */
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

/* A new file beside o->path with the permissions a plain open would give. */
static void
open_beside(Out *o)
{
	const char *slash = strrchr(o->path, '/');
	int dir = slash ? (int)(slash + 1 - o->path) : 0, fd;
	mode_t mask = umask(0);

	umask(mask);
	snprintf(o->temp, sizeof o->temp, "%.*s.%s.XXXXXX", dir, o->path, o->path + dir);
	fd = mkstemp(o->temp);
	if (fd < 0) {
		o->temp[0] = '\0';
		die("%s: %s", o->path, strerror(errno));
	}
	signal(SIGINT, on_signal);
	signal(SIGTERM, on_signal);
	signal(SIGHUP, on_signal);
	if (fchmod(fd, 0666 & ~mask) || !(o->f = fdopen(fd, "wb")))
		die("%s: %s", o->path, strerror(errno));
}

/* A place that is no regular file (a device, a pipe) is written in place. */
static void
out_open(Out *o, const char *path)
{
	struct stat st;

	o->temp[0] = '\0';
	if (!path) {
		strcpy(o->path, "stdout");
		o->f = stdout;
		return;
	}
	resolve(o, path);
	if (stat(o->path, &st) == 0 && S_ISDIR(st.st_mode))
		die("%s: %s", path, strerror(EISDIR));
	if (stat(o->path, &st) == 0 && !S_ISREG(st.st_mode)) {
		if (!(o->f = fopen(o->path, "wb")))
			die("%s: %s", path, strerror(errno));
	} else
		open_beside(o);
}

static void
out_close(Out *o)
{
	int bad = fflush(o->f) == EOF || ferror(o->f);

	if (!bad && o->temp[0])
		bad = fsync(fileno(o->f)) != 0;
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
	FILE *f = cmd_name_of(path) == path ? fopen(path, "rb") : stdin;

	if (!f)
		die("%s: %s", path, strerror(errno));
	return f;
}

/* All of f behind the *n bytes at head, which are taken already; closes f. */
static char *
slurp(FILE *f, const char *name, const char *head, size_t *n)
{
	size_t room = 1 << 16;
	char *s = cmd_alloc(room, 1), *more;

	memcpy(s, head, *n);
	while ((*n += fread(s + *n, 1, room - *n, f)) == room) {
		if (room > (size_t)-1/2 || !(more = realloc(s, 2*room)))
			die("%s: no memory: %zu bytes wanted", name, 2*room);
		s = more;
		room *= 2;
	}
	if (ferror(f))
		die("%s: %s", name, strerror(errno));
	if (f != stdin)
		fclose(f);
	return s;
}

char *
cmd_slurp(const char *path, size_t *n)
{
	*n = 0;
	return slurp(in_open(path), cmd_name_of(path), "", n);
}

int
cmd_open_or_slurp(CmdInput *in, const char *path, char **bytes, size_t *n)
{
	char head[sizeof LHG_MAGIC - 1];
	FILE *f = in_open(path);

	in->name = cmd_name_of(path);
	*n = fread(head, 1, sizeof head, f);
	if (*n == sizeof head && memcmp(head, LHG_MAGIC, sizeof head) == 0) {
		lhg_open_behind_magic(&in->s, f);
		return 1;
	}
	*bytes = slurp(f, in->name, head, n);
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
	if (!got && in->s.f != stdin)
		fclose(in->s.f);
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
