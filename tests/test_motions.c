/* test_motions.c - surface.h: transposed, mirrored, moved, turned or scaled data give the transposed ..
 * scaled surface.
 *
 * lambda and H belong to no surface here, so that the result depends on every weight. */
#include "cmock.h"

#include "../lib/grid/lambdah.h"
#include "../lib/surface/surface.h"
#include "surfaces.h"

enum { NU = 70, NV = 131, N = NU*NV, LU = 12, LV = 10, L = LU*LV };
static const double T = 0.6;

enum Motion { NONE, TRANSPOSE, MIRROR_U, MIRROR_V, MOVE, TURN, SCALE, MOTIONS };

/* What the method is given; all fields over grids of nu x nv and lu x lv nodes. */
typedef struct Data {
	int    nu, nv, lu, lv;
	double T, phi[3*N], lambda[N], H[N], nu12[2][N], tau[2][N], start[3*L];
} Data;

static Data base, moved;
static double found[3*N], kept[3*N], expected[3*N];

/* b = a at the nodes that the motion takes to the nodes of b: transposed or mirrored; times factor. */
static void
permute(enum Motion m, int nu, int nv, const double *a, double factor, double *b)
{
	int i, j;

	for (j = 0; j < nv; j++)
		for (i = 0; i < nu; i++) {
			int p = m == MIRROR_U ? j*nu + nu - 1 - i : m == MIRROR_V ? (nv - 1 - j)*nu + i : j*nu + i;

			b[m == TRANSPOSE ? i*nv + j : p] = factor*a[j*nu+i];
		}
}

/* Moves points rigidly, or scales them. */
static void
move(enum Motion m, int n, double *x)
{
	static const double R[3][3] = { { 0.36, 0.48, -0.8 }, { -0.8, 0.6, 0 }, { 0.48, 0.64, 0.6 } };
	static const double t[3] = { 3, -5, 2 };
	double y[3];
	int p, c;

	for (p = 0; p < n; p++) {
		for (c = 0; c < 3; c++)
			y[c] = x[c*n+p];
		for (c = 0; c < 3; c++)
			x[c*n+p] = m == MOVE ? y[c] + t[c] : m == SCALE ? 3*y[c]
			    : m == TURN ? R[c][0]*y[0] + R[c][1]*y[1] + R[c][2]*y[2] : y[c];
	}
}

static void
positions(enum Motion m, int nu, int nv, const double *a, double *b)
{
	int c;

	for (c = 0; c < 3; c++)
		permute(m, nu, nv, a + (size_t)c*nu*nv, 1, b + (size_t)c*nu*nv);
	move(m, nu*nv, b);
}

/* The data of the moved surface.  Where u and v are exchanged, the new u is
 * v/T, so lambda becomes T lambda; n and H change their sign, as when one of u and v is reversed. */
static void
transform(enum Motion m, const Data *a, Data *b)
{
	int t = m == TRANSPOSE, k;
	double flip = t || m == MIRROR_U || m == MIRROR_V ? -1 : 1, unit = m == SCALE ? 3 : 1;

	b->nu = t ? a->nv : a->nu, b->nv = t ? a->nu : a->nv;
	b->lu = t ? a->lv : a->lu, b->lv = t ? a->lu : a->lv;
	b->T = t ? 1/a->T : a->T;
	positions(m, a->nu, a->nv, a->phi, b->phi);
	positions(m, a->lu, a->lv, a->start, b->start);
	permute(m, a->nu, a->nv, a->lambda, unit*(t ? a->T : 1), b->lambda);
	permute(m, a->nu, a->nv, a->H, flip/unit, b->H);
	permute(m, a->nu, a->nv, a->nu12[0], t ? -1 : 1, b->nu12[0]);
	permute(m, a->nu, a->nv, a->nu12[1], t ? 1 : flip, b->nu12[1]);
	for (k = 0; k < 2; k++)
		permute(m, a->nu, a->nv, a->tau[t ? 1 - k : k], t ? a->T : m == (k ? MIRROR_V : MIRROR_U) ? -1 : 1,
		    b->tau[k]);
}

/* The way of solving: with the boundary held, without a start, with residues, free. */
enum Way { HELD, NO_START, RESIDUES, FREE, WAYS };

static void
solve(enum Way way, const Data *a, double *phi)
{
	const FitOptions o = { .tolerance = way == FREE ? 3e-3 : 5e-5, .most = 200, .sharpen = 1 };
	Residue residue = { { a->nu12[0], a->nu12[1] }, { a->tau[0], a->tau[1] }, 1 };
	Surface s = { .g = { a->nu, a->nv, a->T, &CHART_RECTANGLE }, .lambda = a->lambda, .H = a->H,
	    .residue = way == RESIDUES ? &residue : NULL, .start_chart = { a->lu, a->lv, a->T, &CHART_RECTANGLE },
	    .start_end = { 1, 1 }, .start = way == NO_START ? NULL : a->start, .free = way == FREE };
	FitProgress at;

	memcpy(phi, a->phi, sizeof a->phi);
	assert_int_equal(surface(&s, &o, phi, &at), 1);
}

static void
sample(Chart g, double *phi)
{
	size_t n = (size_t)g.nu*g.nv;
	double *x[3] = { phi, phi + n, phi + 2*n };

	sample_immersion(torus, g, 1, x, NULL, NULL);
}

/* A torus with waves, not conformal, whose lambda and H are then changed by a tenth. */
static void
make_base(void)
{
	const Chart g = { NU, NV, T, &CHART_RECTANGLE }, lattice = { LU, LV, T, &CHART_RECTANGLE };
	const double *phi[3] = { base.phi, base.phi + N, base.phi + 2*N };
	double *const nu[2] = { base.nu12[0], base.nu12[1] }, *const tau[2] = { base.tau[0], base.tau[1] };
	int p;

	base.nu = NU, base.nv = NV, base.lu = LU, base.lv = LV, base.T = T;
	sample(g, base.phi);
	sample(lattice, base.start);
	for (p = 0; p < 3*N; p++)
		base.phi[p] += 0.01*sin(p%NU*0.3)*cos(p/NU*0.2 + 1);
	lambdah(g, phi, LAMBDAH_NORMAL, base.lambda, base.H);
	lambdah_residue(g, phi, base.lambda, nu, tau);
	for (p = 0; p < N; p++) {
		base.lambda[p] *= 1 + 0.1*sin(p%NU*0.2 + p/NU*0.1);
		base.H[p] *= 1 + 0.1*cos(p%NU*0.15 - p/NU*0.12);
	}
}

static void
result_moves_with_the_data(void **state)
{
	enum Motion m;
	enum Way way;

	(void)state;
	make_base();
	for (way = 0; way < WAYS; way++)
		for (m = NONE; m < (way == FREE ? MOVE : MOTIONS); m++) {
			transform(m, &base, &moved);
			solve(way, &moved, found);
			if (m == NONE)
				memcpy(kept, found, sizeof found);
			positions(m, NU, NV, kept, expected);
			assert_true(largest(3*N, found, expected) < 1e-8);
		}
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(result_moves_with_the_data),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
