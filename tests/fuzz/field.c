/* field.c - fuzz target: numbers at vertices (FreeSurfer curvature files, GIFTI, PLY). */
#include <math.h>
#include <string.h>

#include "../../lib/mesh/channel.h"
#include "../../lib/meshfile/fieldfile.h"
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	const size_t before = fuzz_live();
	char err[MESH_ERRLEN] = "";
	Channels c;
	int nv = -1, k, i;

	if (fieldfile_parse((const char *)data, n, "name", NULL, &c, &nv, err)) {
		fuzz_need(*err && !strchr(err, '\n'), "a refusal without one line");
		fuzz_need(fuzz_live() == before, "memory is lost");
		return 0;
	}
	fuzz_need(c.n > 0 && nv >= 0, "no numbers");
	for (k = 0; k < c.n; k++)
		for (i = 0; i < nv; i++)
			fuzz_need(isfinite(c.channel[k].f[i]), "a number is not finite");
	channels_free(&c);
	fuzz_need(fuzz_live() == before, "memory is lost");
	return 0;
}
