/* test_gridmesh.c - the mesh of a sock is closed across its seam and its fold; gridmesh_part removes
 * faces without area from the mesh of a grid whose nodes coincide or are collinear. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/grid/gridmesh.h"
#include "../lib/base/vec3.h"
#include "../lib/grid/gridtree.h"
#include "../lib/mesh/polygon.h"
#include "sockcap.h"

enum { NU = 9, NV = 7, N = NU*NV };

static const Chart CHART = { NU, NV, 1, &CHART_RECTANGLE };
static double phi[3][N];
#define POSITIONS ((const double *[]){ phi[0], phi[1], phi[2] })

/* A curved surface about 2 wide, translated by `offset` in x, y and z. */
static void
sheet(double offset)
{
	int p;

	for (p = 0; p < N; p++) {
		phi[0][p] = offset + .25*(p % NU);
		phi[1][p] = offset + .3*(p / NU);
		phi[2][p] = offset + sin(phi[0][p] - offset)*cos(phi[1][p] - offset);
	}
}

static void
put(int i, int j, int from_i, int from_j)
{
	int c;

	for (c = 0; c < 3; c++)
		phi[c][j*NU + i] = phi[c][from_j*NU + from_i];
}

static int
flat_faces(const Mesh *m)
{
	int f, k, n = 0;
	const double *x[3];

	for (f = 0; f < m->nf; f++) {
		for (k = 0; k < 3; k++)
			x[k] = m->xyz + 3*(size_t)m->tri[3*f + k];
		n += !polygon_has_area(x[0], x[1], x[2]);
	}
	return n;
}

/* Calls gridmesh_part.  Returns the number of faces without area that are left; *before gets their
 * number before the call, *moved the largest change of a coordinate. */
static int
part(int single, int *before, double *moved)
{
	double d;
	int p, c, left = -1;
	Mesh m;

	assert_int_equal(mesh_from_grid(&m, CHART, POSITIONS), 0);
	*before = flat_faces(&m);
	assert_int_equal(gridmesh_part(&m, CHART, single, &left), 0);
	assert_int_equal(m.nf, 2*(NU-1)*(NV-1));
	for (*moved = 0, p = 0; p < N; p++)
		for (c = 0; c < 3; c++) {
			d = fabs(m.xyz[3*p + c] - phi[c][p]);
			*moved = d > *moved ? d : *moved;
			assert_true(!single || m.xyz[3*p + c] == (double)(float)m.xyz[3*p + c]);
		}
	assert_true(left > 0 || flat_faces(&m) == 0);
	mesh_free(&m);
	return left;
}

static void
sound_grids_stay(void **state)
{
	double moved;
	int before;

	(void)state;
	sheet(0);
	assert_int_equal(part(0, &before, &moved), 0);
	assert_int_equal(before, 0);
	assert_true(moved == 0);
}

/* If three nodes of a cell are collinear, cutting it along the other diagonal avoids a face without
 * area, and no node moves. */
static void
the_other_diagonal_helps(void **state)
{
	double moved;
	int before, c;

	(void)state;
	sheet(0);
	for (c = 0; c < 3; c++) {       /* node (3,2) halfway between (3,3) and (4,2), node (4,3) far */
		phi[c][2*NU + 3] = (phi[c][3*NU + 3] + phi[c][2*NU + 4])/2;
		phi[c][3*NU + 4] += 2*(phi[c][3*NU + 4] - phi[c][2*NU + 3]);
	}
	assert_int_equal(part(0, &before, &moved), 0);
	assert_int_equal(before, 0);
	assert_true(moved == 0);
}

/* Nodes that coincide are moved apart, and only by a small part of the width of a cell: pairs of nodes
 * at a corner, on a side and inside, and a block of 4 x 4 nodes. */
static void
coinciding_nodes_are_parted(void **state)
{
	double moved;
	int before, i, j;

	(void)state;
	sheet(0);
	put(NU-1, 1, NU-1, 0);
	put(3, NV-1, 4, NV-1);
	put(3, 3, 3, 2);
	assert_int_equal(part(0, &before, &moved), 0);
	assert_true(before >= 4);
	assert_true(moved > 0 && moved < .5/1024);
	for (j = 1; j < 5; j++)
		for (i = 2; i < 6; i++)
			put(i, j, 2, 1);
	assert_int_equal(part(0, &before, &moved), 0);
	assert_true(before >= 18);
	assert_true(moved < .01);
}

/* Nodes that differ as doubles but coincide as floats are moved apart if the mesh is written in
 * single precision: two neighbours, and two nodes far from each other in the grid. */
static void
floats_are_parted(void **state)
{
	double moved;
	int before, c;

	(void)state;
	sheet(1);
	put(NU-1, 1, NU-1, 0);
	phi[0][2*NU - 1] += 1e-9;
	for (c = 0; c < 3; c++)
		phi[c][3*NU + 1] = phi[c][3*NU + 6] + 1e-9;
	assert_int_equal(part(0, &before, &moved), 0);
	assert_int_equal(before, 0);
	assert_true(moved == 0);
	assert_int_equal(part(1, &before, &moved), 0);
	assert_true(moved > 1e-9 && moved < 1e-2);
}

static void
what_has_no_area_is_told(void **state)
{
	double moved;
	int before;

	(void)state;
	sheet(0);
	memset(phi[0], 0, sizeof phi[0]);
	memset(phi[2], 0, sizeof phi[2]);
	assert_int_equal(part(0, &before, &moved), 2*(NU-1)*(NV-1));
	sheet(1e12);                            /* cells smaller than the rounding of floats */
	assert_true(part(1, &before, &moved) > 0);
}

enum { MU = 24, MV = 11, M = MU*MV };

static void
cap_mesh(Mesh *m)
{
	static double x[3][M];
	const Chart g = { MU, MV, 0.45, &CHART_SOCK };
	double *f[3] = { x[0], x[1], x[2] };

	sample_sockcap(g, 1, f, NULL, NULL);
	assert_int_equal(mesh_from_grid(m, g, (const double *const *)f), 0);
}

/* The mesh of a sock has one boundary, the row v = T, and is a disk: each other edge has two faces that
 * pass it in opposite directions. */
static void
a_sock_is_a_disk(void **state)
{
	static int edge[M][M];
	int f, k, a, b, edges = 0, border = 0;
	Mesh m;

	(void)state;
	cap_mesh(&m);
	for (f = 0; f < m.nf; f++)
		for (k = 0; k < 3; k++)
			assert_int_equal(edge[m.tri[3*f + k]][m.tri[3*f + (k+1)%3]]++, 0);
	for (a = 0; a < M; a++)
		for (b = 0; b < M; b++)
			if (edge[a][b]) {
				edges += a < b || !edge[b][a];
				border += !edge[b][a];
				assert_true(edge[b][a] || (a >= M - MU && b >= M - MU));
			}
	assert_int_equal(border, MU);
	assert_int_equal(M - edges + m.nf, 1);
	mesh_free(&m);
}

/* The normals of the hemisphere point to its centre, and its area is that of the sphere, to second
 * order. */
static void
a_sock_is_oriented(void **state)
{
	double e[3], d[3], n[3], area;
	int f, *t;
	Mesh m;

	(void)state;
	cap_mesh(&m);
	for (f = 0; f < m.nf; f++) {
		t = m.tri + 3*f;
		sub3(m.xyz + 3*t[1], m.xyz + 3*t[0], e);
		sub3(m.xyz + 3*t[2], m.xyz + 3*t[0], d);
		cross3(e, d, n);
		assert_true(dot3(n, m.xyz + 3*t[0]) < 0);
	}
	area = mesh_area(&m)/(2*M_PI);
	assert_true(area < 1 && area > 1 - 20./(MU*MU));
	mesh_free(&m);
}

/* The pyramid of boxes finds every face of a sock, those across the fold included. */
static void
a_sock_is_found(void **state)
{
	const Chart g = { MU, MV, 0.45, &CHART_SOCK };
	double x[3];
	int f, c;
	GridTree t;
	Mesh m;

	(void)state;
	cap_mesh(&m);
	assert_int_equal(gridtree_init(&t, &m, g), 0);
	for (f = 0; f < m.nf; f++) {
		for (c = 0; c < 3; c++)
			x[c] = (m.xyz[3*m.tri[3*f]+c] + m.xyz[3*m.tri[3*f+1]+c] + m.xyz[3*m.tri[3*f+2]+c])/3;
		assert_true(gridtree_distance2(&t, x, 1) < 1e-28);
		assert_true(gridtree_cell2(&t, f/2, x) < 1e-28);
	}
	gridtree_free(&t);
	mesh_free(&m);
}

/* Nodes that coincide beside the fold and the seam are parted, as inside. */
static void
nodes_of_a_sock_are_parted(void **state)
{
	const Chart g = { MU, MV, 0.45, &CHART_SOCK };
	int c, left;
	Mesh m;

	(void)state;
	cap_mesh(&m);
	for (c = 0; c < 3; c++) {
		m.xyz[3*5 + c] = m.xyz[3*(MU - 6) + c];         /* across the fold */
		m.xyz[3*(3*MU) + c] = m.xyz[3*(4*MU - 1) + c];  /* across the seam */
	}
	assert_int_equal(gridmesh_part(&m, g, 0, &left), 0);
	assert_int_equal(left, 0);
	assert_int_equal(flat_faces(&m), 0);
	mesh_free(&m);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_sock_is_a_disk),
		cmocka_unit_test(a_sock_is_oriented),
		cmocka_unit_test(a_sock_is_found),
		cmocka_unit_test(nodes_of_a_sock_are_parted),
		cmocka_unit_test(sound_grids_stay),
		cmocka_unit_test(the_other_diagonal_helps),
		cmocka_unit_test(coinciding_nodes_are_parted),
		cmocka_unit_test(floats_are_parted),
		cmocka_unit_test(what_has_no_area_is_told)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
