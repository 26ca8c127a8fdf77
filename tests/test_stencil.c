/* test_stencil.c - stencil.h: finite differences on the rectangle and on charts with joined
 * sides. */
#include "cmock.h"

#include "../lib/grid/stencil.h"
#include "charts.h"
#include "surfaces.h"

enum { NU = 16, NV = 11, N = NU*NV };

static double phi[3][N];
static const double *const cphi[3] = { phi[0], phi[1], phi[2] };

static Chart
chart(const ChartKind *kind)
{
	return (Chart){ NU, NV, 0.7, kind };
}

/* The coordinate of node i along an axis; i may lie beyond the chart.  The first node is half a step
 * away from a joined side. */
static double
place(Chart g, int axis, int i)
{
	return (i + 0.5*g.kind->joined[axis][0])*(axis ? chart_k(g) : chart_h(g));
}

static double
quadratic(double u, double v)
{
	return 2 - u + 3*v + 5*u*u - 4*u*v + 7*v*v;
}

static void
exact_on_quadratics(void **state)
{
	Chart g = chart(&CHART_RECTANGLE);
	double phi_u[3], phi_v[3], lap[3], uu[3], uv[3], vv[3];
	int p, i, j;

	(void)state;
	for (p = 0; p < N; p++)
		phi[0][p] = quadratic(place(g, 0, p%NU), place(g, 1, p/NU));
	for (p = 0; p < N; p++) {
		double u = place(g, 0, i = p%NU), v = place(g, 1, j = p/NU);

		stencil_tangents(g, cphi, i, j, phi_u, phi_v);
		assert_true(fabs(phi_u[0] - (-1 + 10*u - 4*v)) < 1e-12);
		assert_true(fabs(phi_v[0] - (3 - 4*u + 14*v)) < 1e-12);
		assert_int_equal(stencil_is_inner(g, i, j), i > 0 && i < NU - 1 && j > 0 && j < NV - 1);
		if (!stencil_is_inner(g, i, j))
			continue;
		stencil_laplacian(g, cphi, i, j, lap);
		stencil_second_form(g, cphi, i, j, uu, uv, vv);
		assert_true(fabs(lap[0] - 24) < 1e-10);
		assert_true(fabs(uu[0] - 10) < 1e-10 && fabs(uv[0] + 4) < 1e-10 && fabs(vv[0] - 14) < 1e-10);
	}
}

/* A field that is continuous across the joined sides of every kind of chart. */
static double
wave(Chart g, double u, double v)
{
	if (g.kind == &TUBE)
		return exp(u)*sin(2*M_PI*v/g.T + 1);
	if (g.kind == &CHART_PILLOW)
		return cos(M_PI*(2*u + v/g.T)) + cos(M_PI*(4*u - 3*v/g.T));
	if (g.kind == &CHART_SOCK)
		return cos(2*M_PI*(u + 0.3*v)) + cos(2*M_PI*(2*u - 0.2*v)) + v*v;
	return sin(3*u + v);
}

/* Differences at a joined side use the values of the field continued across it. */
static void
neighbours_beyond_joined_sides(void **state)
{
	double phi_u[3], phi_v[3], lap[3], uu[3], uv[3], vv[3], f[3][3];
	int q, p, a, b;

	(void)state;
	for (q = 0; q < 4; q++) {
		Chart g = chart(KINDS[q]);
		double h = chart_h(g), k = chart_k(g);

		for (p = 0; p < N; p++)
			phi[0][p] = wave(g, place(g, 0, p%NU), place(g, 1, p/NU));
		for (p = 0; p < N; p++) {
			int i = p%NU, j = p/NU;

			if (!stencil_is_inner(g, i, j))
				continue;
			for (a = 0; a < 3; a++)
				for (b = 0; b < 3; b++)
					f[a][b] = wave(g, place(g, 0, i + a - 1), place(g, 1, j + b - 1));
			stencil_tangents(g, cphi, i, j, phi_u, phi_v);
			stencil_laplacian(g, cphi, i, j, lap);
			stencil_second_form(g, cphi, i, j, uu, uv, vv);
			assert_true(fabs(phi_u[0] - (f[2][1] - f[0][1])/(2*h)) < 1e-11);
			assert_true(fabs(phi_v[0] - (f[1][2] - f[1][0])/(2*k)) < 1e-11);
			assert_true(fabs(uu[0] - (f[2][1] - 2*f[1][1] + f[0][1])/(h*h)) < 1e-9);
			assert_true(fabs(vv[0] - (f[1][2] - 2*f[1][1] + f[1][0])/(k*k)) < 1e-9);
			assert_true(fabs(uv[0] - (f[2][2] - f[2][0] - f[0][2] + f[0][0])/(4*h*k)) < 1e-9);
			assert_true(fabs(lap[0] - uu[0] - vv[0]) < 1e-9);
		}
	}
}

static void
inner_nodes_lie_on_no_open_side(void **state)
{
	static const size_t count[4] = { (NU - 2)*(NV - 2), (NU - 2)*NV, N, NU*(NV - 1) };
	static const double steps[4][2] = { { NU - 1, NV - 1 }, { NU - 1, NV }, { NU, NV }, { NU, NV - 0.5 } };
	int q;

	(void)state;
	for (q = 0; q < 4; q++) {
		assert_int_equal(stencil_inner_count(chart(KINDS[q])), count[q]);
		assert_true(chart_steps(chart(KINDS[q]), 0) == steps[q][0]);
		assert_true(chart_steps(chart(KINDS[q]), 1) == steps[q][1]);
	}
}

static void
fill_with_noise(double *x, size_t n, unsigned long long seed)
{
	while (n--)
		*x++ = noise(&seed);
}

static void
four_at_a_time_are_as_one(void **state)
{
	double phi_u[3], phi_v[3], lap[3];
	Nodes u[3], v[3], L[3];
	int q, j, l, c;
	Quad a;

	(void)state;
	fill_with_noise(phi[0], 3*N, 4);
	for (q = 0; q < 4; q++) {
		Chart g = chart(KINDS[q]);
		Range rows = stencil_inner(g, 1);

		for (j = rows.from; j < rows.to; j++)
			for (a = quad_row(g, stencil_inner(g, 0), j); a.count > 0; quad_next(&a)) {
				quad_differences(&a, phi[0], u, v, L);
				for (l = 0; l < NODES; l++) {
					int i = a.i + (l < a.count ? l : 0);

					stencil_tangents(g, cphi, i, j, phi_u, phi_v);
					stencil_laplacian(g, cphi, i, j, lap);
					for (c = 0; c < 3; c++) {
						assert_true(fabs(u[c][l] - phi_u[c]) < 1e-11);
						assert_true(fabs(v[c][l] - phi_v[c]) < 1e-11);
						assert_true(fabs(L[c][l] - lap[c]) < 1e-9);
					}
				}
			}
	}
}

/* Row j of y, continued across joined sides, with 0 at nodes that have no complete stencil.  If y is
 * odd, it changes its sign where the chart says so (chart.h). */
static void
row_of(Chart g, const double *y, int odd, int j, double row[NU + 2])
{
	Range columns = stencil_reach(g, 0), rows = stencil_reach(g, 1);
	int i, sign;
	size_t p;

	for (i = -1; i <= NU; i++) {
		row[i+1] = 0;
		if (i < columns.from || i >= columns.to || j < rows.from || j >= rows.to)
			continue;
		sign = 1;
		p = stencil_node(g, i, j, &sign);
		if (stencil_is_inner(g, (int)(p%NU), (int)(p/NU)))
			row[i+1] = odd ? sign*y[p] : y[p];
	}
}

/* The transposed stencils are the adjoints of the stencils: <D x, y> = <x, D' y> for random x on all
 * nodes and random y on the inner nodes. */
static void
transpose_is_the_adjoint(void **state)
{
	static double y[3][N], out[N];
	double u[NU+2], row[2][3][NU+2], left, right;
	double phi_u[3], phi_v[3], lap[3];
	int q, p, j, k;

	(void)state;
	fill_with_noise(phi[0], 3*N, 5);
	fill_with_noise(y[0], 3*N, 6);
	for (q = 0; q < 4; q++) {
		Chart g = chart(KINDS[q]);

		for (left = 0, p = 0; p < N; p++) {
			if (!stencil_is_inner(g, p%NU, p/NU))
				continue;
			stencil_tangents(g, cphi, p%NU, p/NU, phi_u, phi_v);
			stencil_laplacian(g, cphi, p%NU, p/NU, lap);
			left += y[0][p]*phi_u[0] + y[1][p]*phi_v[0] + y[2][p]*lap[0];
		}
		for (j = 0; j < NV; j++) {
			row_of(g, y[0], 1, j, u);
			for (k = 0; k < 3; k++) {
				row_of(g, y[1], 1, j + k - 1, row[0][k]);
				row_of(g, y[2], 0, j + k - 1, row[1][k]);
			}
			stencil_transposed(g, (Range){ 0, NU }, u + 1,
			    (const double *[3]){ row[0][0] + 1, row[0][1] + 1, row[0][2] + 1 },
			    (const double *[3]){ row[1][0] + 1, row[1][1] + 1, row[1][2] + 1 }, out + j*NU);
		}
		for (right = 0, p = 0; p < N; p++)
			right += phi[0][p]*out[p];
		assert_true(fabs(left/right - 1) < 1e-11);
	}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(exact_on_quadratics),
		cmocka_unit_test(neighbours_beyond_joined_sides),
		cmocka_unit_test(inner_nodes_lie_on_no_open_side),
		cmocka_unit_test(four_at_a_time_are_as_one),
		cmocka_unit_test(transpose_is_the_adjoint),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
