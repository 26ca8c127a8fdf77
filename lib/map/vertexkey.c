/* vertexkey.c - sums of sines of distances to the corners. */
#include <math.h>
#include <stdlib.h>

#include "vertexkey.h"
#include "../base/vec3.h"

static const double WAVES = 1e4;        /* waves in a distance of 2 pi sqrt(area); rounding errors
                                         * of positions times this are still far below 1 */
static const double EQUAL = 1e-9;       /* relative difference of two sums that differ by rounding
                                         * only */

/* The sum of the distances of all vertices from vertex i. */
static double
sum_of_distances(const Mesh *m, int i)
{
	double sum = 0, x[3];
	int j;

	for (j = 0; j < m->nv; j++) {
		sub3(&m->xyz[3*(size_t)j], &m->xyz[3*(size_t)i], x);
		sum += norm3(x);
	}
	return sum;
}

/* The index of the first corner, and the step to the next in an order that depends on the surface
 * alone.  The first corner is the one with the largest sum of distances from all vertices; the next is
 * the one of its two neighbours for which this sum is larger.  (The positions of the four corners
 * alone would not do: if they form a rectangle, they look alike.) */
static int
first_corner(const Mesh *m, const int vertex[4], int *step)
{
	double far[4];
	int k, first = 0;

	for (k = 0; k < 4; k++)
		far[k] = sum_of_distances(m, vertex[k]);
	for (k = 1; k < 4; k++)
		if (far[k] > far[first]*(1 + EQUAL))
			first = k;
	*step = far[(first+3)%4] > far[(first+1)%4]*(1 + EQUAL) ? 3 : 1;
	return first;
}

int
vertex_first(const Mesh *m, const int vertex[4])
{
	int step;

	return first_corner(m, vertex, &step);
}

double *
vertex_keys(const Mesh *m, const int vertex[4])
{
	static const double share[4] = { 1, 1.0103, 1.0237, 1.0391 };
	double *key = malloc(m->nv*sizeof *key), wave = WAVES/sqrt(mesh_area(m)), x[3];
	int i, k, step, first = first_corner(m, vertex, &step), corner[4];

	for (k = 0; k < 4; k++)
		corner[k] = vertex[(first + step*k)%4];
	for (i = 0; key && i < m->nv; i++)
		for (key[i] = 0, k = 0; k < 4; k++) {
			sub3(&m->xyz[3*(size_t)i], &m->xyz[3*(size_t)corner[k]], x);
			key[i] += share[k]*sin(wave*norm3(x));
		}
	return key;
}
