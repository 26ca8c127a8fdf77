/* diskfile.h - a mesh file as a disk, for programs that only measure. */
#ifndef DISKFILE_H
#define DISKFILE_H

#include <stdio.h>
#include <stdlib.h>

#include "../lib/mesh/disk.h"
#include "../lib/meshfile/meshfile.h"

/* Reports the reason, and exits with 1. */
static void
quit(const char *why)
{
	fprintf(stderr, "%s\n", why);
	exit(1);
}

/* Reads the disk in the file, or quits. */
static void
load(const char *path, Disk *d)
{
	FILE *f = fopen(path, "rb");
	char *bytes;
	long n = -1;
	Soup s;

	if (f && fseek(f, 0, SEEK_END) == 0)
		n = ftell(f);
	if (n < 0 || fseek(f, 0, SEEK_SET))
		quit("cannot read the file");
	if (!(bytes = malloc(n + 1)) || fread(bytes, 1, n, f) != (size_t)n)
		quit("cannot read the file");
	fclose(f);
	if (meshfile_parse(&s, bytes, n, (size_t)1 << 32))
		quit(s.err);
	free(bytes);
	if (disk_from_soup(d, &s))
		quit(d->err);
	soup_free(&s);
}

#endif
