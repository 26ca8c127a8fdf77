/* field.c - fuzz target: numbers at vertices (FreeSurfer curvature files, GIFTI, PLY). */
#include <math.h>
#include <string.h>

#include "../../lib/meshfile/fieldfile.h"
#include "fuzz.h"

int
LLVMFuzzerTestOneInput(const uint8_t *data, size_t n)
{
	const size_t before = fuzz_live();
	char err[MESH_ERRLEN] = "";
	FieldFile f;
	int k, i;

	if (fieldfile_parse((const char *)data, n, "name", fuzz_beside(), &f, err)) {
		fuzz_need(*err && !strchr(err, '\n'), "a refusal without one line");
		fuzz_need(fuzz_live() == before, "memory is lost");
		return 0;
	}
	fuzz_need(f.c.n > 0 && f.nv >= 0, "no numbers");
	for (k = 0; k < f.c.n; k++)
		for (i = 0; i < f.nv; i++)
			fuzz_need(isfinite(f.c.channel[k].f[i]), "a number is not finite");
	for (i = 0; f.xyz && i < 3*f.nv; i++)
		fuzz_need(isfinite(f.xyz[i]), "a coordinate is not finite");
	fieldfile_free(&f);
	fuzz_need(fuzz_live() == before, "memory is lost");
	return 0;
}
