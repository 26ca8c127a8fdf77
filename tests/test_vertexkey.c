/* test_vertexkey.c - the keys belong to the surface. */
#include "cmock.h"

#include <math.h>

#include "../lib/map/vertexkey.h"
#include "disks.h"

enum { N = 6 };

/* A rectangle of N x N vertices with some of the inner ones moved; its corners have equal distances
 * from each other.  It is multiplied by scale and moved by `offset`. */
static void
rectangle(double scale, double offset, Disk *d)
{
	double xyz[3*N*N];
	int tri[6*(N - 1)*(N - 1)], i, n = 0;

	for (i = 0; i < N*N; i++) {
		int inside = i%N > 0 && i%N < N - 1 && i/N > 0 && i/N < N - 1;

		xyz[3*i] = scale*(i%N + inside*.3*sin(7.0*i)) + offset;
		xyz[3*i+1] = scale*(2*(i/N) + inside*.3*sin(5.0*i));
		xyz[3*i+2] = scale*.3*sin(3.0*i);
		if (i%N < N - 1 && i/N < N - 1) {
			memcpy(&tri[n], (int[]){ i, i + 1, i + N + 1, i, i + N + 1, i + N }, 6*sizeof *tri);
			n += 6;
		}
	}
	for (i = 0; i < 4; i++)
		xyz[3*(i%2*(N - 1) + i/2*N*(N - 1)) + 2] = 0;
	assert_int_equal(disks_of(N*N, xyz, n/3, tri, d), 0);
}

static void
keys_belong_to_the_surface(void **state)
{
	static const int a = 0, b = N - 1, c = N*N - 1, d = N*(N - 1);
	const int order[][4] = { { a, b, c, d }, { b, c, d, a }, { c, d, a, b }, { b, a, d, c }, { a, d, c, b } };
	static const double motion[][2] = { { 1, 0 }, { 1, 100 }, { 1e-5, 0 }, { 1e5, 0 } };
	size_t k, l;
	int i;
	Disk m, o;

	(void)state;
	rectangle(1, 0, &m);
	for (k = 0; k < sizeof motion/sizeof *motion; k++)
		for (l = 0; l < sizeof order/sizeof *order; l++) {
			double *key, *other;

			rectangle(motion[k][0], motion[k][1], &o);
			key = vertex_keys(&m.m, order[0]);
			other = vertex_keys(&o.m, order[l]);
			assert_true(key && other);
			for (i = 0; i < N*N; i++)
				assert_true(fabs(key[i] - other[i]) < 1e-9);
			free(key);
			free(other);
			disk_free(&o);
		}
	disk_free(&m);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(keys_belong_to_the_surface),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
