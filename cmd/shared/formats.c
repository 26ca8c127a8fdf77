/* formats.c - the mesh formats in usage texts. */
#include <stdio.h>
#include <string.h>

#include "../../lib/meshfile/meshformat.h"
#include "formats.h"

/* Writes the list for the mark "{..}" at s to buf.  Returns the length of the mark, 0 if s begins
 * with none. */
static size_t
list_at(const char *s, char buf[MESHFORMAT_LIST])
{
	static const struct {
		const char *mark;
		unsigned    can;
		int         ends;
	} LIST[] = {
		{ "{formats}",    0,                                   0 },
		{ "{uv formats}", MESHFORMAT_UV,                       0 },
		{ "{ends}",       MESHFORMAT_WRITE,                    1 },
		{ "{uv ends}",    MESHFORMAT_UV | MESHFORMAT_WRITE,    1 }
	};
	size_t i;

	for (i = 0; i < sizeof LIST/sizeof *LIST; i++)
		if (strncmp(s, LIST[i].mark, strlen(LIST[i].mark)) == 0) {
			if (LIST[i].ends)
				meshformat_ends(LIST[i].can, buf);
			else
				meshformat_names(LIST[i].can, "or", buf);
			return strlen(LIST[i].mark);
		}
	if (strncmp(s, "{stdout}", 8) != 0)
		return 0;
	strcpy(buf, meshformat(0)->name);
	return 8;
}

char *
formats_usage(const char *text, char *out, size_t n)
{
	char list[MESHFORMAT_LIST];
	size_t at = 0, mark;

	while (*text && at + 1 < n)
		if ((mark = list_at(text, list)) > 0) {
			at += (size_t)snprintf(out + at, n - at, "%s", list);
			text += mark;
		} else
			out[at++] = *text++;
	out[at < n ? at : n - 1] = '\0';
	return out;
}
