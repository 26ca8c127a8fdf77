/* points.c - makes faces on points that have none. */
#include <math.h>
#include <stdlib.h>

#include "../../lib/base/vec3.h"
#include "../../lib/mend/pointface.h"
#include "../shared/claim.h"
#include "../shared/cmd.h"
#include "../shared/range.h"
#include "points.h"

/* Memory in bytes for each point, a little more than was measured. */
enum { PER_POINT = 3000 };

/* The radius of the circle through the corners of a triangle: the product of its sides over four times
 * its area. */
static double
radius(const double *xyz, const int t[3])
{
	double u[3], v[3], w[3], n[3];

	sub3(xyz + 3*(size_t)t[1], xyz + 3*(size_t)t[0], u);
	sub3(xyz + 3*(size_t)t[2], xyz + 3*(size_t)t[0], v);
	sub3(v, u, w);
	cross3(u, v, n);
	return norm3(n) > 0 ? norm3(u)*norm3(v)*norm3(w)/(2*norm3(n)) : 0;
}

/* Gives s the triangles as its faces. */
static void
take_faces(Soup *s, int *tri, int nf)
{
	int f;

	free(s->first);
	free(s->idx);
	s->first = cmd_alloc((size_t)nf + 1, sizeof *s->first);
	for (f = 0; f <= nf; f++)
		s->first[f] = 3*f;
	s->idx = tri;
	s->nf = nf;
}

void
points_to_faces(const char *name, int wanted, Soup *s)
{
	double most = 0;
	int *tri, nf, f;

	if (s->nf > 0) {
		if (wanted)
			note("%s: has faces: --points does nothing", name);
		return;
	}
	if (!wanted)
		die("%s: %d points without faces: --points makes faces of them", name, s->nv);
	range_positions(name, (size_t)s->nv, 3, (const double *[]){ s->xyz, s->xyz + 1, s->xyz + 2 });
	claim(name, "the faces of points", s->nv, PER_POINT);
	cmd_progress("joining %d points", s->nv);
	switch (pointface(s->nv, s->xyz, &tri, &nf)) {
	case 0: break;
	case POINTFACE_ENOMEM: die("%s: no memory to join %d points", name, s->nv);
	default: die("%s: the points cannot be joined to a surface", name);
	}
	if (nf == 0)
		die("%s: the points cannot be joined to a surface", name);
	for (f = 0; f < nf; f++)
		most = larger(most, radius(s->xyz, tri + 3*(size_t)f));
	take_faces(s, tri, nf);
	note("%s: %d points joined by %d faces, of radius %.3g or less", name, s->nv, nf, most);
}
