/* meshdump.c - prints the mesh of a file as it is read: a line "NV NF NC"; then, in the byte order of the machine,
 * NV x 3 doubles, NF + 1 ints (where each face begins), NC ints (the corners).  For tests/readers.py. */
#include <stdio.h>
#include <stdlib.h>

#include "../lib/meshfile/meshfile.h"

int
main(int argc, char *argv[])
{
	const size_t most = (size_t)1 << 28;
	FILE *f = argc == 2 ? fopen(argv[1], "rb") : NULL;
	char *bytes = malloc(most);
	size_t n, nc;
	Soup s;

	if (!f || !bytes)
		return 2;
	n = fread(bytes, 1, most, f);
	fclose(f);
	if (meshfile_parse(&s, bytes, n, most)) {
		fprintf(stderr, "%s\n", s.err);
		return 1;
	}
	free(bytes);
	nc = (size_t)s.first[s.nf];
	printf("%d %d %zu\n", s.nv, s.nf, nc);
	fwrite(s.xyz, sizeof *s.xyz, 3*(size_t)s.nv, stdout);
	fwrite(s.first, sizeof *s.first, (size_t)s.nf + 1, stdout);
	fwrite(s.idx, sizeof *s.idx, nc, stdout);
	soup_free(&s);
	return 0;
}
