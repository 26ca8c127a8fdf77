/* test_channel.c - channels of a mesh: kept by repair and splitting, sampled on a grid by
 * sampler.h, and returned from a grid to the vertices by gridpoint.h. */
#include "cmock.h"

#include <math.h>

#include "../lib/grid/gridpoint.h"
#include "../lib/mesh/channel.h"
#include "../lib/mesh/disk.h"
#include "../lib/mesh/disksoup.h"
#include "../lib/mesh/refine.h"
#include "../lib/sample/sampler.h"
#include "synthdisk.h"

/* A curved surface with chart coordinates (u,v) in [0,1] x [0,2/3]. */
typedef struct Sheet {
	Disk    d;
	double *u, *v;
	Chart   g;
	double *x, *y;          /* (u,v) of the nodes of g */
} Sheet;

static Sheet
sheet(int n)
{
	Sheet s = { .g = { 33, 23, 2/3., &CHART_RECTANGLE } };
	SynthDomain dom;
	double *xy;
	Synth y;
	int i, j;

	synth_disk("rectangle", n, &y, &dom, &s.d, &xy);
	s.u = malloc(s.d.m.nv*sizeof *s.u);
	s.v = malloc(s.d.m.nv*sizeof *s.v);
	s.x = malloc(s.g.nu*s.g.nv*sizeof *s.x);
	s.y = malloc(s.g.nu*s.g.nv*sizeof *s.y);
	assert_true(s.u && s.v && s.x && s.y);
	for (i = 0; i < s.d.m.nv; i++) {
		double u = s.u[i] = xy[2*i]/1.5, v = s.v[i] = xy[2*i+1]/1.5;

		s.d.m.xyz[3*i] = 3*u + v*v;
		s.d.m.xyz[3*i+1] = 2*v - 0.3*u*v;
		s.d.m.xyz[3*i+2] = sin(2*u) + v;
	}
	for (j = 0; j < s.g.nv; j++)
		for (i = 0; i < s.g.nu; i++) {
			s.x[j*s.g.nu + i] = i*chart_h(s.g);
			s.y[j*s.g.nu + i] = j*chart_k(s.g);
		}
	free(xy);
	return s;
}

static void
drop(Sheet *s)
{
	disk_free(&s->d);
	free(s->u);
	free(s->v);
	free(s->x);
	free(s->y);
}

/* Samples channel c at the nodes of s->g; the caller frees every out[k]. */
static void
sampled(const Sheet *s, int surface, const Channel *c, double *out[])
{
	Sampler sampler;
	int k;

	for (k = 0; k < c->n; k++)
		assert_non_null(out[k] = malloc(s->g.nu*s->g.nv*sizeof **out));
	assert_int_equal(sampler_init(&sampler, &s->d, s->u, s->v, s->g.T, surface), 0);
	assert_int_equal(sampler_channel(&sampler, c, s->g.nu*s->g.nv, s->x, s->y, out), 0);
	sampler_free(&sampler);
}

/* A channel that is a linear function of the position is the same function of it on the grid. */
static void
linear_in_position(void **state)
{
	Sheet s = sheet(300);
	Channel c = { .n = 2, .f = malloc(2*s.d.m.nv*sizeof(double)) };
	const int n = s.g.nu*s.g.nv;
	double *out[2], *phi[3], *p;
	Sampler sampler;
	int i, k, surface;

	(void)state;
	for (i = 0; i < s.d.m.nv; i++) {
		p = &s.d.m.xyz[3*i];
		c.f[2*i] = 4 + p[0] - 2*p[1] + 0.5*p[2];
		c.f[2*i+1] = p[2];
	}
	for (surface = SAMPLER_FACETS; surface <= SAMPLER_SMOOTH; surface++) {
		sampled(&s, surface, &c, out);
		for (k = 0; k < 3; k++)
			assert_non_null(phi[k] = malloc(n*sizeof *phi[k]));
		assert_int_equal(sampler_init(&sampler, &s.d, s.u, s.v, s.g.T, surface), 0);
		assert_int_equal(sampler_points(&sampler, s.g.nu*s.g.nv, s.x, s.y, phi), 0);
		sampler_free(&sampler);
		for (i = 0; i < n; i++) {
			assert_true(fabs(out[0][i] - (4 + phi[0][i] - 2*phi[1][i] + 0.5*phi[2][i])) < 1e-12);
			assert_true(fabs(out[1][i] - phi[2][i]) < 1e-12);
		}
		for (k = 0; k < 3; k++)
			free(phi[k]);
		free(out[0]);
		free(out[1]);
	}
	free(c.f);
	drop(&s);
}

static double
quadratic(double u, double v, int k)
{
	return k == 0 ? 7*u*u - 3*u*v + v - 100 : k == 1 ? 1e-5*(u - 0.5)*(u - 0.5) : v*v*1e9 + u;
}

static double
size(int k)
{
	return k == 0 ? 1 : k == 1 ? 1e-5 : 1e9;
}

/* Quadratic polynomials of (u,v), of very different magnitudes and with an extremum inside, are
 * exact on the grid, and exact again at the vertices after interpolation from the grid. */
static void
quadratics_there_and_back(void **state)
{
	Sheet s = sheet(400);
	const int nv = s.d.m.nv, n = s.g.nu*s.g.nv;
	Channel c = { .n = 3, .f = malloc(3*nv*sizeof(double)) };
	double *out[3], *uv = malloc(2*nv*sizeof *uv), *place = malloc(2*nv*sizeof *place);
	double *back = malloc(3*nv*sizeof *back);
	int i, k, at;

	(void)state;
	for (i = 0; i < nv; i++) {
		uv[2*i] = s.u[i], uv[2*i+1] = s.v[i];
		for (k = 0; k < 3; k++) {
			c.f[3*i+k] = quadratic(s.u[i], s.v[i], k);
			back[3*i+k] = 55;
		}
	}
	sampled(&s, SAMPLER_SMOOTH, &c, out);
	for (k = 0; k < 3; k++)
		for (i = 0; i < n; i++)
			assert_true(fabs(out[k][i] - quadratic(s.x[i], s.y[i], k)) < 1e-10*size(k));
	uv[0] = uv[1] = -1;             /* a vertex without (u,v) keeps its values */
	assert_int_equal(gridpoint_uv(s.g, 0, nv, uv, place, &at), 0);
	gridpoint_vertices(s.g, 3, (const double *const *)out, nv, place, back);
	for (i = 0; i < nv; i++)
		for (k = 0; k < 3; k++)
			assert_true(i ? fabs(back[3*i+k] - c.f[3*i+k]) < 1e-10*size(k) : back[k] == 55);
	for (k = 0; k < 3; k++)
		free(out[k]);
	free(c.f);
	free(uv);
	free(place);
	free(back);
	drop(&s);
}

/* A channel that jumps from 0 to 1: the smooth surface overshoots by less than 0.5, and not at all
 * far from the jump; the facets do not overshoot. */
static void
jumps_do_not_overshoot(void **state)
{
	Sheet s = sheet(400);
	const int n = s.g.nu*s.g.nv;
	Channel c = { .n = 1, .f = malloc(s.d.m.nv*sizeof(double)) };
	double *out[1];
	int i;

	(void)state;
	for (i = 0; i < s.d.m.nv; i++)
		c.f[i] = s.u[i] > 0.5;
	sampled(&s, SAMPLER_SMOOTH, &c, out);
	for (i = 0; i < n; i++) {
		assert_true(out[0][i] > -0.5 && out[0][i] < 1.5);
		if (fabs(s.x[i] - 0.5) > 0.3)
			assert_true(fabs(out[0][i] - (s.x[i] > 0.5)) < 1e-12);
	}
	free(out[0]);
	sampled(&s, SAMPLER_FACETS, &c, out);
	for (i = 0; i < n; i++)
		assert_true(out[0][i] >= -1e-15 && out[0][i] <= 1 + 1e-15);
	free(out[0]);
	free(c.f);
	drop(&s);
}

/* Repair (dropping an unused vertex, welding) keeps the channels of a soup of two triangles, and
 * disk_channel_to_soup returns them to the vertices of the soup. */
static void
kept_by_repair(void **state)
{
	double xyz[21] = { 9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
	int first[3] = { 0, 3, 6 }, idx[6] = { 1, 2, 3, 4, 5, 6 }, i;
	Soup s = { .nv = 7, .nf = 2, .xyz = xyz, .first = first, .idx = idx };
	double *f = channel_add(&s.channels, "heat", 1, 7), *rgb = channel_add(&s.channels, "rgb", 3, 7), *to;
	Channel *c;
	Disk d;

	(void)state;
	assert_ptr_equal(channel_add(&s.channels, "heat", 1, 7), f);
	assert_int_equal(s.channels.n, 2);
	for (i = 0; i < 7; i++)
		f[i] = 10*i, rgb[3*i] = i, rgb[3*i+1] = -i, rgb[3*i+2] = 0.5;
	assert_int_equal(disk_from_soup(&d, &s), 0);
	assert_int_equal(d.m.nv, 4);
	assert_non_null(c = channel_find(&d.channels, "rgb"));
	assert_int_equal(c->n, 3);
	assert_null(channel_find(&d.channels, "uv"));
	for (i = 0; i < 4; i++) {
		assert_true(channel_values(&d.channels, "heat")[i] == 10*d.file[i]);
		assert_true(c->f[3*i] == d.file[i] && c->f[3*i+1] == -d.file[i] && c->f[3*i+2] == 0.5);
	}
	assert_int_equal(disk_channel_to_soup(&d, "back", 3, c->f, -1, &s), 0);
	to = channel_values(&s.channels, "back");
	assert_true(to[0] == -1 && to[1] == -1 && to[2] == -1);
	for (i = 1; i < 7; i++)         /* welded vertices have equal values */
		assert_true(to[3*i] == (i == 4 ? 2 : i == 6 ? 3 : i) && to[3*i+2] == 0.5);
	channels_free(&s.channels);
	disk_free(&d);
}

/* A new vertex gets the mean of the values at the ends of its edge, so a channel that is linear in
 * the position stays linear. */
static void
kept_by_splitting(void **state)
{
	Sheet s = sheet(60);
	unsigned char *marked = calloc(s.d.m.nf, 1);
	double *f = channel_add(&s.d.channels, "two", 2, s.d.m.nv), *g;
	int i, all;
	Disk finer;

	(void)state;
	for (i = 0; i < s.d.m.nv; i++)
		f[2*i] = s.d.m.xyz[3*i], f[2*i+1] = 3*s.d.m.xyz[3*i+2] - 1;
	marked[5] = 1;
	for (all = 0; all < 2; all++) {
		assert_int_equal(refine_split(&s.d, all ? NULL : marked, NULL, &finer, NULL), 0);
		assert_true(finer.m.nv > s.d.m.nv);
		g = channel_values(&finer.channels, "two");
		for (i = 0; i < finer.m.nv; i++)
			assert_true(g[2*i] == finer.m.xyz[3*i] && fabs(g[2*i+1] - (3*finer.m.xyz[3*i+2] - 1)) < 1e-14);
		disk_free(&finer);
	}
	free(marked);
	drop(&s);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(linear_in_position),
		cmocka_unit_test(quadratics_there_and_back),
		cmocka_unit_test(jumps_do_not_overshoot),
		cmocka_unit_test(kept_by_repair),
		cmocka_unit_test(kept_by_splitting),
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
