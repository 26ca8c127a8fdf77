/* near.c - offsets that are exact, and numbers there and back. */
#include <math.h>
#include <stdlib.h>

#include "near.h"
#include "vertexkey.h"

/* The offset that, subtracted from the coordinates, brings a mesh far from the origin near it.  The
 * subtraction is exact: along each axis the offset is a multiple of a power of two that is not less
 * than the extent of the mesh, and lies between 0 and the middle of the mesh. */
static void
find_offset(const Mesh *m, double offset[3])
{
	double low[3] = { HUGE_VAL, HUGE_VAL, HUGE_VAL }, high[3] = { -HUGE_VAL, -HUGE_VAL, -HUGE_VAL };
	double extent = 0;
	int i, c;

	for (i = 0; i < m->nv; i++)
		for (c = 0; c < 3; c++) {
			low[c] = fmin(low[c], m->xyz[3*(size_t)i + c]);
			high[c] = fmax(high[c], m->xyz[3*(size_t)i + c]);
		}
	for (c = 0; c < 3; c++)
		extent = fmax(extent, high[c] - low[c]);
	extent = exp2(ceil(log2(extent)));
	for (c = 0; c < 3; c++)
		offset[c] = extent*trunc((low[c]/2 + high[c]/2)/extent);
}

int
near_init(Near *n, const Disk *d, const int corner[4])
{
	int vertex[4], k, start;
	size_t i;

	for (k = 0; k < 4; k++)
		vertex[k] = d->loop[corner[k]];
	start = corner[vertex_first(&d->m, vertex)];
	if (traversal_init(&n->t, d, start))
		return NEAR_ENOMEM;
	for (k = 0; k < 4; k++)
		n->corner[k] = (corner[k] - start + d->nb)%d->nb;
	find_offset(&d->m, n->offset);
	for (i = 0; i < 3*(size_t)d->m.nv; i++)
		n->t.d.m.xyz[i] -= n->offset[i%3];
	return 0;
}

void
near_free(Near *n)
{
	traversal_free(&n->t);
}

int
near_restore(const Near *n, double **x)
{
	double *given = malloc(n->t.d.m.nv*sizeof *given);
	int i;

	if (!given)
		return NEAR_ENOMEM;
	for (i = 0; i < n->t.d.m.nv; i++)
		given[i] = (*x)[n->t.number[i]];
	free(*x);
	*x = given;
	return 0;
}

double **
near_fields(const Near *n, int fields, const double *const *f)
{
	size_t nv = n->t.d.m.nv, m = fields, k, i;
	double **field = malloc((m + 1)*sizeof *field + m*nv*sizeof(double)), *to;

	if (!field)
		return NULL;
	for (to = (double *)(field + m + 1), k = 0; k < m; k++, to += nv) {
		field[k] = to;
		for (i = 0; i < nv; i++)
			to[n->t.number[i]] = f[k][i];
	}
	return field;
}

int
near_given(const Near *n, int number)
{
	int i = n->t.d.m.nv - 1;

	while (i >= 0 && n->t.number[i] != number)
		i--;
	return i;
}
