/* diskfile.h - reads a mesh file as a disk, for the programs that only measure (loss_cost.c,
 * plain_cholmod.c). */
#ifndef DISKFILE_H
#define DISKFILE_H

#include <stdio.h>
#include <stdlib.h>

#include "../lib/mesh/disk.h"
#include "../lib/meshfile/meshfile.h"

/* Prints the reason to stderr and exits with 1. */
static void
quit(const char *why)
{
	fprintf(stderr, "%s\n", why);
	exit(1);
}

/* Reads the file as a disk, to be freed by disk_free, or quits. */
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
