/* samefile.c - whether two names refer to the same file. */
#include <limits.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "cmd.h"
#include "private.h"
#include "samefile.h"

/* The absolute path, without links, of the file that an output to path replaces or makes. */
static char *
resolved_path(const char *path)
{
	char to[PATH_MAX], folder[PATH_MAX + 2], *name, *real, *all;

	output_follow_links(path, to);
	if ((real = realpath(to, NULL)))
		return real;
	name = strrchr(to, '/') ? strrchr(to, '/') + 1 : to;
	snprintf(folder, sizeof folder, "%.*s.", (int)(name - to), to);
	real = realpath(folder, NULL);
	all = cmd_alloc(strlen(real ? real : folder) + strlen(name) + 2, 1);
	sprintf(all, "%s/%s", real ? real : folder, name);
	free(real);
	return all;
}

int
same_file(const char *a, const char *b)
{
	char *p = resolved_path(a), *q = resolved_path(b);
	int same = strcmp(p, q) == 0;

	free(p);
	free(q);
	return same;
}

int
same_as_stream(const char *path, int fd)
{
	struct stat a, b;

	return stat(path, &a) == 0 && fstat(fd, &b) == 0 && S_ISREG(b.st_mode) && a.st_dev == b.st_dev
	    && a.st_ino == b.st_ino;
}
