/* replay.c - runs a fuzz target on the inputs named on the command line: files, or folders of files.
 * Prints their number.  Fails if the target aborts or takes a minute, or if there is no input. */
#include <dirent.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "fuzz.h"

static long inputs;

static void
file(const char *path, FILE *f)
{
	static uint8_t bytes[1 << 22];
	size_t n = fread(bytes, 1, sizeof bytes, f);
	uint8_t *exact = malloc(n + !n);        /* a copy: a sanitizer sees an access beyond its end */

	fuzz_need(!ferror(f) && n < sizeof bytes && exact, path);
	memcpy(exact, bytes, n);
	alarm(60);
	LLVMFuzzerTestOneInput(exact, n);
	alarm(0);
	free(exact);
	inputs++;
}

static void
folder(const char *path, DIR *d)
{
	char name[4096];
	struct dirent *e;
	FILE *f;

	while ((e = readdir(d)))
		if (e->d_name[0] != '.') {
			snprintf(name, sizeof name, "%s/%s", path, e->d_name);
			f = fopen(name, "rb");
			fuzz_need(f != NULL, name);
			file(name, f);
			fclose(f);
		}
}

int
main(int argc, char *argv[])
{
	FILE *f;
	DIR *d;
	int i;

	for (i = 1; i < argc; i++)
		if ((d = opendir(argv[i]))) {
			folder(argv[i], d);
			closedir(d);
		} else {
			f = fopen(argv[i], "rb");
			fuzz_need(f != NULL, argv[i]);
			file(argv[i], f);
			fclose(f);
		}
	printf("%ld inputs\n", inputs);
	return inputs == 0;
}
