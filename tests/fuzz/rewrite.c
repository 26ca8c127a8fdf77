/* rewrite.c - fuzz target: OBJ and PLY files copied with other coordinates. */
#include <stdlib.h>
#include <string.h>

#include "../../lib/meshfile/meshfile.h"
#include "../../lib/meshfile/rewrite.h"
#include "fuzz.h"

/* Copies a mesh of nv vertices with them at `to`, and reads the copy. */
static void
copied(const char *p, size_t n, const Soup *s, const double *to)
{
	char err[MESH_ERRLEN] = "", *out;
	size_t nout;
	Soup again;

	if (rewrite(p, n, s->nv, to, &out, &nout, err)) {
		fuzz_need(*err && !strchr(err, '\n'), "a refusal without one line");
		return;
	}
	fuzz_need(meshfile_parse(&again, out, nout, MESHFILE_MOST) == 0, "the copy is refused");
	fuzz_need(again.nv == s->nv && again.nf == s->nf, "the copy has other counts");
	fuzz_need(s->nf == 0 || memcmp(again.idx, s->idx, (size_t)s->first[s->nf]*sizeof(int)) == 0, "the copy has other faces");
	soup_free(&again);
	free(out);
}

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	const size_t before = fuzz_live();
	double *to;
	Soup s;
	int k;

	if (meshfile_parse(&s, data, n, MESHFILE_MOST))
		return 0;
	to = malloc(3*(size_t)s.nv*sizeof *to + 1);
	for (k = 0; k < 3*s.nv; k++)
		to[k] = s.xyz[k]/3 + k%4;
	copied((const char *)data, n, &s, to);
	soup_free(&s);
	free(to);
	fuzz_need(fuzz_live() == before, "memory is lost");
	return 0;
}
