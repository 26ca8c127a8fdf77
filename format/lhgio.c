/* lhgio.c - shared by reading and writing: messages, the order of grids, fixed bytes.
 * Section numbers: LHG.md. */
#include <errno.h>
#include <stdarg.h>
#include <string.h>

#include "lhgpriv.h"

const char lhg_end[LHG_ALIGN] = {
	'\n', 'l', 'h', 'g', ' ', 'e', 'n', 'd', '\x89', '\r', '\n', '\x1a', '\n', [LHG_ALIGN-1] = '\n'
};

void
lhg_open(LhgStream *s, FILE *f)
{
	memset(s, 0, sizeof *s);
	s->f = f;
}

int
lhg_magic(const char *line)
{
	int version = line[4] - '0';

	return memcmp(line, "lhg ", 4) == 0 && line[5] == '\n' && (version == 1 || version == 2) ? version : 0;
}

int
lhg_version(const Lhg *g)
{
	return g->chart == LHG_RECTANGLE ? 1 : 2;
}

void
lhg_open_behind_magic(LhgStream *s, FILE *f, int version)
{
	lhg_open(s, f);
	s->ahead = version;
}

/* Writes to `to` where an error is: the frame that must come next, else the frame in g, else the
 * number of the grid.  Returns the length; 0 in the first grid. */
static size_t
place(const LhgStream *s, const Lhg *g, char *to, size_t n)
{
	int len = 0;

	if (s->frame < s->frames)
		len = snprintf(to, n, "frame %d of %d: ", s->frame + 1, s->frames);
	else if (g->frames > 1 && g->frames <= LHG_MAXFRAMES)
		len = snprintf(to, n, "frame %d of %d: ", g->frame, g->frames);
	else if (s->grids > 0)
		len = snprintf(to, n, "grid %ld: ", s->grids + 1);
	return (size_t)len;
}

int
lhg_fail(LhgStream *s, const Lhg *g, int code, const char *fmt, ...)
{
	size_t n = place(s, g, s->err, sizeof s->err);
	va_list ap;

	va_start(ap, fmt);
	vsnprintf(s->err + n, sizeof s->err - n, fmt, ap);
	va_end(ap);
	return code;
}

int
lhg_failio(LhgStream *s, const Lhg *g, const char *what)
{
	return lhg_fail(s, g, LHG_EIO, "%s: %s", what, errno ? strerror(errno) : "unknown error");
}

int
lhg_checkorder(LhgStream *s, const Lhg *g)
{
	if (s->frame < s->frames && (g->frame != s->frame + 1 || g->frames != s->frames))
		return lhg_fail(s, g, LHG_EORDER, "frame %d of %d comes in its place", g->frame, g->frames);
	if (s->frame == s->frames && g->frame != 1)
		return lhg_fail(s, g, LHG_EORDER, "the frames before it are missing");
	return 0;
}

uint32_t
lhg_lastcrc(const LhgStream *s)
{
	return s->frame < s->frames ? s->crc : 0;
}

void
lhg_passed(LhgStream *s, const Lhg *g, uint32_t crc)
{
	s->frame = g->frame;
	s->frames = g->frames;
	s->crc = crc;
	s->grids++;
}

size_t
lhg_taillen(size_t n)
{
	return LHG_ALIGN - n % (LHG_ALIGN/8) * 8;
}
