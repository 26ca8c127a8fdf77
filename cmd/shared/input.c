/* input.c - the inputs of every command: all bytes of a file, or a stream of grids. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "claim.h"
#include "cmd.h"
#include "private.h"

static FILE *standard_input;            /* a stream over stdin; NULL until stdin is read */

const char *
cmd_name_of(const char *path)
{
	return path && strcmp(path, "-") != 0 ? path : "stdin";
}

static FILE *
in_open(const char *path)
{
	int file = cmd_name_of(path) == path, fd = file ? open(path, O_RDONLY) : STDIN_FILENO;
	FILE *f = !file && standard_input ? standard_input : fd < 0 ? NULL : descriptor_stream(fd, "rb");

	if (!f)
		die("%s: %s", cmd_name_of(path), strerror(errno));
	if (!file)
		standard_input = f;
	return f;
}

/* Closes f unless it is stdin, which may be read again. */
static void
in_close(FILE *f)
{
	if (f != standard_input)
		fclose(f);
}

/* Reads the rest of f and closes it.  Returns all bytes, beginning with the *n bytes at head,
 * which were read before; *n is their number.  look, if not NULL, is called with the first 64 KiB
 * of a longer input. */
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
	char head[LHG_MAGICLEN];
	FILE *f = in_open(path);

	in->name = cmd_name_of(path);
	*n = fread(head, 1, sizeof head, f);
	if (*n == sizeof head && lhg_magic(head)) {
		lhg_open_behind_magic(&in->s, f, lhg_magic(head));
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

	if (got == LHG_EFOREIGN)
		die("%s: %s: of a mesh, run mesh2rect first", in->name, in->s.err);
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
