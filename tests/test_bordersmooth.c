/* test_bordersmooth.c - fold.h, harmonicshare.h, bordersmooth.h: folded cells near the border of a grid. */
#include "cmock.h"

#include <math.h>
#include <string.h>

#include "../lib/grid/fold.h"
#include "../lib/grid/stencil.h"
#include "../lib/surface/bordersmooth.h"
#include "../lib/surface/harmonicshare.h"

enum { NU = 41, NV = 37, N = NU*NV, MOST = (NU + 1)*NV };

static double phi[3*MOST], was[3*MOST];
static unsigned char folded[MOST];

static const double *const X[3] = { phi, phi + N, phi + 2*N };

/* A bent sheet, x = u, y = v. */
static Chart
sheet(void)
{
	Chart g = { NU, NV, 0.9, &CHART_RECTANGLE };
	int p;

	for (p = 0; p < N; p++) {
		phi[p] = chart_u(g, p%NU);
		phi[N+p] = chart_v(g, p/NU);
		phi[2*N+p] = 0.2*sin(3*phi[p]);
	}
	return g;
}

static void
counted(void **state)
{
	Chart g = sheet();
	int p = 3*NU + 20, c;

	(void)state;
	assert_int_equal(fold_mark(g, X, 10, folded), 0);
	phi[p] += 1.5*chart_h(g);               /* over the edge of the cell to its right: both cells there are twisted */
	assert_int_equal(fold_mark(g, X, 10, folded), 2);
	assert_true(folded[p] && folded[p-NU]);
	for (c = 0; c < 2; c++)
		assert_int_equal(fold_mark(g, X, 3 + c, folded), c ? 2 : 1);    /* cell rows 2 and 3 */
	assert_int_equal(fold_mark(g, X, 2, folded), 0);
	phi[p] = NAN;
	assert_int_equal(fold_mark(g, X, 10, folded), 12);
}

/* On the sock the cells between the last column and the first count, those at v = 0 do not. */
static void
counted_on_the_sock(void **state)
{
	Chart g = { NU + 1, NV, 0.9, &CHART_SOCK };
	const double *const x[3] = { phi, phi + MOST, phi + 2*MOST };
	int p;

	(void)state;
	for (p = 0; p < MOST; p++) {
		double a = 2*M_PI*chart_u(g, p%g.nu);

		phi[p] = cos(a);
		phi[MOST+p] = sin(a);
		phi[2*MOST+p] = chart_v(g, p/g.nu);
	}
	assert_int_equal(fold_mark(g, x, 10, folded), 0);
	p = (NV - 3)*g.nu + g.nu - 1;
	phi[2*MOST+p] += 1.5*chart_k(g);
	assert_int_equal(fold_mark(g, x, 10, folded), 2);
	assert_true(folded[p] && folded[p-1]);
}

static void
made_harmonic(void **state)
{
	static double share[N];
	Chart g = sheet();
	double *y = was, lap[3];
	const double *const Y[3] = { y, y + N, y + 2*N };
	int p, c;

	(void)state;
	for (p = 0; p < N; p++)
		share[p] = p%NU < 20 ? 1 : 0;
	assert_int_equal(harmonic_share(g, share, phi, y), 0);
	for (p = 0; p < N; p++) {
		double before[3];

		if (!stencil_is_inner(g, p%NU, p/NU)) {
			for (c = 0; c < 3; c++)
				assert_true(y[c*N+p] == phi[c*N+p]);
			continue;
		}
		stencil_laplacian(g, X, p%NU, p/NU, before);
		stencil_laplacian(g, Y, p%NU, p/NU, lap);
		for (c = 0; c < 3; c++)
			assert_true(fabs(lap[c] - (share[p] > 0 ? 0 : before[c])) < 1e-9);
	}
}

/* Crumpled near the border: unfolded there; less and less moved farther away. */
static void
unfolded(void **state)
{
	Chart g = sheet();
	int p = 3*NU + 20, c;

	(void)state;
	phi[p] += 1.5*chart_h(g);
	phi[N+p+NU+1] -= 1.4*chart_k(g);
	phi[2*N+p-NU] += 0.3;
	memcpy(was, phi, sizeof was);
	assert_true(fold_mark(g, X, 10, folded) > 2);
	assert_int_equal(border_smooth(g, phi), 0);
	assert_int_equal(fold_mark(g, X, 10, folded), 0);
	for (c = 0; c < 3; c++) {
		assert_true(fabs(phi[c*N+p+15*NU] - was[c*N+p+15*NU]) < 0.02);
		assert_true(phi[c*N+20] == was[c*N+20]);
	}
}

/* Nothing is changed without folds, or where they are far from the border. */
static void
left_alone(void **state)
{
	Chart g = sheet();

	(void)state;
	phi[18*NU+20] += 1.5*chart_h(g);
	memcpy(was, phi, sizeof was);
	assert_true(fold_mark(g, X, 18, folded) > 0);
	assert_int_equal(border_smooth(g, phi), 0);
	assert_memory_equal(phi, was, sizeof was);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(counted),
		cmocka_unit_test(counted_on_the_sock),
		cmocka_unit_test(made_harmonic),
		cmocka_unit_test(unfolded),
		cmocka_unit_test(left_alone),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
