/* fieldfile.c - the table of field formats. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "fieldfile.h"
#include "writepriv.h"

static const FieldFormat table[] = {
	{ "GIFTI shape", ".shape.gii .func.gii", 0, giftifields_write },
	{ "FreeSurfer curvature", ".curv .sulc .thickness", 1, fscurv_write },
};

enum { ROWS = sizeof table / sizeof *table };

const FieldFormat *
fieldformat_of(const char *file)
{
	const size_t all = strlen(file);
	const char *end;
	size_t n;
	int i;

	for (i = 0; i < ROWS; i++)
		for (end = table[i].ends; (n = strcspn(end, " ")) > 0; end += n + (end[n] == ' '))
			if (all > n && strncasecmp(file + all - n, end, n) == 0)
				return &table[i];
	return NULL;
}

char *
fieldformat_ends(char buf[FIELDFORMAT_LIST])
{
	snprintf(buf, FIELDFORMAT_LIST, "%s %s", table[0].ends, table[1].ends);
	return buf;
}

int
fieldfile_write(const Channels *c, int nv, int nf, const FieldFormat *format, char **bytes, size_t *n)
{
	Text t = { NULL, 0, 0 };
	int e = format->write(&t, c, nv, nf);

	if (e) {
		free(t.p);
		return e;
	}
	*bytes = t.p;
	*n = t.n;
	return 0;
}
