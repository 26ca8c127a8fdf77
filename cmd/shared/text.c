/* text.c - text in memory, written like a file. */
#define _GNU_SOURCE             /* fopencookie */
#include <stdlib.h>
#include <string.h>
#include <sys/types.h>

#include "cmd.h"

static ssize_t
append(void *cookie, const char *s, size_t n)
{
	CmdText *t = cookie;
	size_t room = t->room;
	char *more;

	while (n > room - t->n)
		room *= 2;
	if (room > t->room) {
		if (!(more = realloc(t->bytes, room)))
			return 0;
		t->bytes = more;
		t->room = room;
	}
	memcpy(t->bytes + t->n, s, n);
	t->n += n;
	return (ssize_t)n;
}

void
cmd_text_open(CmdText *t)
{
	*t = (CmdText){ .bytes = cmd_alloc(1, 4096), .room = 4096 };
	if (!(t->f = fopencookie(t, "w", (cookie_io_functions_t){ .write = append })))
		die("no memory");
}

void
cmd_text_close(CmdText *t)
{
	int bad = fflush(t->f) == EOF || ferror(t->f);

	if (fclose(t->f) == EOF || bad)
		die("no memory: %zu bytes wanted", 2*t->room);
}
