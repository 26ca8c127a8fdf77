/* samefile.c - two names of one file. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "cmd.h"
#include "samefile.h"

/* The path without links; of a file that is not there, its folder's and its name. */
static char *
place(const char *path)
{
	const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
	size_t n = (size_t)(name - path);
	char *real = realpath(path, NULL), *folder, *all;

	if (real)
		return real;
	folder = cmd_alloc(n + 2, 1);
	memcpy(folder, path, n);
	strcpy(folder + n, ".");
	real = realpath(folder, NULL);
	all = cmd_alloc(strlen(real ? real : folder) + strlen(name) + 2, 1);
	sprintf(all, "%s/%s", real ? real : folder, name);
	free(real);
	free(folder);
	return all;
}

int
same_file(const char *a, const char *b)
{
	char *p = place(a), *q = place(b);
	int same = strcmp(p, q) == 0;

	free(p);
	free(q);
	return same;
}
