/* test_mend.c - lib/mend: what comes in with known faults goes out as the surface that it was made from. */
#include "cmock.h"

#include <math.h>

#include "../lib/mend/mend.h"
#include "../lib/mesh/channel.h"
#include "../lib/mesh/disk.h"

/* ---- soups ---- */

static Soup
soup_new(int nv, int nf)
{
	Soup s = { .nv = nv, .nf = nf };
	int f;

	s.xyz = malloc(3*(size_t)nv*sizeof *s.xyz);
	s.first = malloc(((size_t)nf + 1)*sizeof *s.first);
	s.idx = malloc(3*(size_t)nf*sizeof *s.idx);
	assert_true(s.xyz && s.first && s.idx);
	for (f = 0; f <= nf; f++)
		s.first[f] = 3*f;
	return s;
}

typedef void Place(double u, double v, double x[3]);

static void
sphere(double u, double v, double x[3])         /* the unit sphere, stereographic, no symmetry */
{
	const double a = u - 0.4, b = v - 0.45, r = 1 + a*a + b*b;

	x[0] = 2*a/r, x[1] = 2*b/r, x[2] = 2/r - 1;
}

static void
plane(double u, double v, double x[3])
{
	x[0] = u, x[1] = v + 0.25*u, x[2] = 0.5*u - v;
}

static void
torus(double u, double v, double x[3])
{
	const double a = 2*M_PI*u, b = 2*M_PI*v, r = 2 + 0.7*cos(b);

	x[0] = r*cos(a), x[1] = r*sin(a), x[2] = 0.7*sin(b);
}

/* A grid of n x m cells on [0,1]^2; wrap: the last column is the first one, and so for the rows. */
static Soup
grid(Place *at, int n, int m, int wrap)
{
	const int nu = n + !wrap, nv = m + !wrap;
	Soup s = soup_new(nu*nv, 2*n*m);
	int i, j, k, *t = s.idx;

	for (j = 0; j < nv; j++)
		for (i = 0; i < nu; i++)
			at((double)i/n, (double)j/m, s.xyz + 3*(j*nu + i));
	for (j = 0; j < m; j++)
		for (i = 0; i < n; i++) {
			const int p[4] = { j*nu + i, j*nu + (i + 1)%nu, (j + 1)%nv*nu + (i + 1)%nu, (j + 1)%nv*nu + i };
			static const int corner[6] = { 0, 1, 2, 0, 2, 3 };

			for (k = 0; k < 6; k++)
				*t++ = p[corner[k]];
		}
	return s;
}

/* Drops the faces with a corner within r of c. */
static void
punch(Soup *s, const double c[3], double r)
{
	int f, k, in, n = 0;

	for (f = 0; f < s->nf; f++) {
		for (in = 0, k = 0; k < 3; k++) {
			const double *x = s->xyz + 3*s->idx[3*f+k];

			in |= hypot(hypot(x[0] - c[0], x[1] - c[1]), x[2] - c[2]) < r;
		}
		if (!in)
			memmove(s->idx + 3*n++, s->idx + 3*f, 3*sizeof *s->idx);
	}
	s->nf = n;
}

/* Adds a face. */
static void
add(Soup *s, int a, int b, int c)
{
	s->idx = realloc(s->idx, 3*((size_t)s->nf + 1)*sizeof *s->idx);
	s->first = realloc(s->first, ((size_t)s->nf + 2)*sizeof *s->first);
	assert_true(s->idx && s->first);
	s->idx[3*s->nf] = a, s->idx[3*s->nf+1] = b, s->idx[3*s->nf+2] = c;
	s->nf++;
	s->first[s->nf] = 3*s->nf;
}

static int
add_vertex(Soup *s, double x, double y, double z)
{
	s->xyz = realloc(s->xyz, 3*((size_t)s->nv + 1)*sizeof *s->xyz);
	assert_non_null(s->xyz);
	s->xyz[3*s->nv] = x, s->xyz[3*s->nv+1] = y, s->xyz[3*s->nv+2] = z;
	return s->nv++;
}

/* Gives every face vertices of its own. */
static Soup
unshare(const Soup *s)
{
	Soup t = soup_new(3*s->nf, s->nf);
	int i;

	for (i = 0; i < 3*s->nf; i++) {
		memcpy(t.xyz + 3*i, s->xyz + 3*s->idx[i], 3*sizeof *t.xyz);
		t.idx[i] = i;
	}
	return t;
}

/* ---- checks ---- */

/* Mends s, and checks that vertices with a source have its position to the last bit. */
static MendReport
mended(const Soup *s, MendOptions o, Soup *out)
{
	const double *source;
	MendReport r;
	int v, e = mend(out, s, &o, &r);

	if (e)
		fail_msg("mend: %d: %s", e, out->err);
	source = channel_values(&out->channels, MESH_SOURCE);
	assert_non_null(source);
	for (v = 0; v < out->nv; v++)
		if (source[v] >= 0)
			assert_memory_equal(out->xyz + 3*v, s->xyz + 3*(int)source[v], 3*sizeof *s->xyz);
	return r;
}

static void
assert_disk(const Soup *s)
{
	Disk d;

	if (disk_from_soup(&d, s))
		fail_msg("no disk: %s", d.err);
	assert_string_equal(d.note, "");
	disk_free(&d);
}

/* Mends s with the defaults, checks that a disk of the same vertices and faces as `as` comes out. */
static MendReport
becomes(const Soup *s, const Soup *as)
{
	Soup out;
	MendReport r = mended(s, MEND_DEFAULTS, &out);

	assert_int_equal(out.nv, as->nv);
	assert_int_equal(out.nf, as->nf);
	assert_memory_equal(out.xyz, as->xyz, 3*(size_t)as->nv*sizeof *out.xyz);
	assert_memory_equal(out.idx, as->idx, 3*(size_t)as->nf*sizeof *out.idx);
	assert_disk(&out);
	soup_free(&out);
	return r;
}

static void
done(MendReport r)
{
	mend_report_free(&r);
}

/* ---- tests ---- */

static void
a_disk_stays(void **state)
{
	Soup s = grid(sphere, 9, 7, 0);

	(void)state;
	done(becomes(&s, &s));
	soup_free(&s);
}

static void
a_soup_is_welded(void **state)
{
	Soup s = grid(sphere, 9, 7, 0), t = unshare(&s), out;
	MendReport r = mended(&t, MEND_DEFAULTS, &out);
	MendOptions o = MEND_DEFAULTS;
	int v;

	(void)state;
	assert_int_equal(out.nv, s.nv);
	assert_int_equal(out.nf, s.nf);
	assert_int_equal(r.welded, t.nv - s.nv);
	assert_disk(&out);
	mend_report_free(&r);
	soup_free(&out);

	for (v = 0; v < t.nv; v++)              /* within a tenth of the distance */
		t.xyz[3*v] += 1e-4*(v%7 - 3)/3;
	r = mended(&t, MEND_DEFAULTS, &out);
	assert_int_not_equal(r.npiece, 1);
	mend_report_free(&r);
	soup_free(&out);
	o.weld = 1e-3;
	r = mended(&t, o, &out);
	assert_int_equal(r.npiece, 1);
	assert_int_equal(out.nv, s.nv);
	assert_disk(&out);
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&s);
	soup_free(&t);
}

/* A cut from the boundary into the surface: the vertices on it double. */
static void
a_seam_is_welded(void **state)
{
	Soup s = grid(sphere, 8, 8, 0), t = grid(sphere, 8, 8, 0);
	int i, f, twin[9];
	MendReport r;

	(void)state;
	for (i = 0; i < 5; i++) {
		const double *x = s.xyz + 3*(4*9 + i);

		twin[i] = add_vertex(&t, x[0], x[1], x[2]);
	}
	for (f = 2*8*4; f < t.nf; f++)                  /* above row 4 */
		for (i = 0; i < 3; i++)
			if (t.idx[3*f+i] >= 4*9 && t.idx[3*f+i] < 4*9 + 5)
				t.idx[3*f+i] = twin[t.idx[3*f+i] - 4*9];
	r = becomes(&t, &s);
	assert_int_equal(r.coincident, 4 + 1);
	assert_int_equal(r.welded, 5);
	mend_report_free(&r);
	soup_free(&s);
	soup_free(&t);
}

static void
faces_that_do_not_belong_go(void **state)
{
	Soup s = grid(sphere, 6, 5, 0), t = grid(sphere, 6, 5, 0);
	MendReport r;
	int a;

	(void)state;
	add(&t, t.idx[1], t.idx[0], t.idx[2]);          /* the same face again, turned */
	add(&t, 3, 3, 4);
	add(&t, 3, 999, 4);
	add(&t, 3, -1, 4);
	a = add_vertex(&t, NAN, 0, 0);
	add(&t, 0, 1, a);
	add_vertex(&t, 0, INFINITY, 0);
	r = becomes(&t, &s);
	assert_int_equal(r.twice, 1);
	assert_int_equal(r.twice_at, s.nf);
	assert_int_equal(r.broken, 1);
	assert_int_equal(r.broken_at, s.nf + 1);
	assert_int_equal(r.missing, 2);
	assert_int_equal(r.missing_at, s.nf + 2);
	assert_int_equal(r.infinite, 1);
	assert_int_equal(r.infinite_at, a);
	assert_int_equal(r.unused, 1);
	mend_report_free(&r);
	soup_free(&s);
	soup_free(&t);
}

static void
specks_and_flaps_go(void **state)
{
	Soup s = grid(sphere, 6, 5, 0), t = grid(sphere, 6, 5, 0);
	MendReport r;
	int a, i;

	(void)state;
	a = add_vertex(&t, 9, 9, 9);                    /* a speck, a pinched corner, and a fin on an edge */
	add_vertex(&t, 9, 9, 9.01);
	add_vertex(&t, 9, 9.01, 9);
	add(&t, a, a + 1, a + 2);
	add(&t, 0, a + 1, a + 2);
	a = add_vertex(&t, 0, 0, 0.5);
	add(&t, 3*7 + 3, 3*7 + 4, a);
	r = becomes(&t, &s);
	assert_int_equal(r.many, 1);
	assert_true(r.npiece >= 2);
	assert_true(r.piece[0].kept && !r.piece[1].kept);
	for (i = 1; i < r.npiece; i++)
		assert_true(r.piece[i].area <= r.piece[i-1].area);
	mend_report_free(&r);
	soup_free(&s);
	soup_free(&t);
}

static void
faces_are_turned(void **state)
{
	Soup s = grid(sphere, 6, 5, 0), t = grid(sphere, 6, 5, 0);
	MendReport r;
	int f, c;

	(void)state;
	for (f = 0; f < t.nf; f += 3)
		c = t.idx[3*f+1], t.idx[3*f+1] = t.idx[3*f+2], t.idx[3*f+2] = c;
	r = becomes(&t, &s);
	assert_int_equal(r.turned, (t.nf + 2)/3);
	mend_report_free(&r);
	soup_free(&s);
	soup_free(&t);
}

/* A vertex is put on an edge: in one of its two faces only (a T-junction), or as a face of its own
 * without area (a cap). */
static void
vertices_on_edges(void **state)
{
	int cap;

	(void)state;
	for (cap = 0; cap < 2; cap++) {
		Soup t = grid(plane, 6, 6, 0), out;
		const int a = 2*7 + 2, c = 3*7 + 3, f = 2*(2*6 + 2), m = add_vertex(&t, 0, 0, 0);
		MendReport r;
		double area;
		Mesh mesh;
		int k;

		for (k = 0; k < 3; k++)
			t.xyz[3*m+k] = (t.xyz[3*a+k] + t.xyz[3*c+k])/2;
		assert_int_equal(t.idx[3*f], a);        /* a b c, with a c the diagonal */
		assert_int_equal(t.idx[3*f+2], c);
		t.idx[3*f+2] = m;
		add(&t, m, t.idx[3*f+1], c);
		if (cap)
			add(&t, a, m, c);
		r = mended(&t, MEND_DEFAULTS, &out);
		assert_int_equal(cap ? r.flipped : r.seams, 1);
		assert_int_equal(out.nv, 50);
		assert_int_equal(out.nf, 74);
		assert_disk(&out);
		mesh = (Mesh){ out.nv, out.nf, out.xyz, out.idx };
		area = mesh_area(&mesh);
		mesh = (Mesh){ t.nv, t.nf, t.xyz, t.idx };
		assert_true(fabs(area - mesh_area(&mesh)) < 1e-14*area);
		mend_report_free(&r);
		soup_free(&out);
		soup_free(&t);
	}
}

static void
short_edges_collapse(void **state)
{
	Soup t = grid(sphere, 6, 6, 0), out;
	MendReport r;
	int k;

	(void)state;
	for (k = 0; k < 3; k++)
		t.xyz[3*24+k] = t.xyz[3*25+k] + 1e-12;
	r = mended(&t, MEND_DEFAULTS, &out);
	assert_int_equal(r.collapsed, 1);
	assert_int_equal(r.short_at[0] + r.short_at[1], 24 + 25);
	assert_true(r.short_at[0] == 24 || r.short_at[0] == 25);
	assert_int_equal(out.nv, t.nv - 1);
	assert_int_equal(out.nf, t.nf - 2);
	assert_disk(&out);
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&t);
}

/* The mean distance, of the vertices that fill a hole in it, from the unit sphere moved by `far`. */
static double
hole_error(int fill, double far)
{
	const double c[3] = { 0.1, 0.05, 1 };
	Soup s = grid(sphere, 40, 40, 0), out;
	MendOptions o = MEND_DEFAULTS;
	double sum = 0;
	int v, n = 0, f;
	MendReport r;

	punch(&s, c, 0.6);
	for (v = 0; v < 3*s.nv; v++)
		s.xyz[v] += far;
	o.fill = fill;
	r = mended(&s, o, &out);
	assert_int_equal(r.holes, 1);
	assert_int_equal(r.order, fill);
	assert_disk(&out);
	for (v = 0; v < out.nv; v++)
		if (channel_values(&out.channels, MESH_SOURCE)[v] < 0) {
			const double *x = out.xyz + 3*v;

			sum += fabs(hypot(hypot(x[0] - far, x[1] - far), x[2] - far) - 1);
			n++;
		}
	assert_int_equal(n, r.vertices);
	for (v = 0, f = 0; f < out.nf; f++)
		v += out.filled[f];
	assert_int_equal(v, r.faces);
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&s);
	return sum/n;
}

/* A sphere has the same curvature all over: the patch that continues it is nearest. */
static void
a_patch_continues_the_surface(void **state)
{
	const double flat = hole_error(MEND_FLAT, 0), c1 = hole_error(MEND_C1, 0);
	const double c2 = hole_error(MEND_C2, 0), far = hole_error(MEND_C2, 1e10);

	(void)state;
	print_message("mean distance from the sphere: flat %.2e, C1 %.2e, C2 %.2e, C2 far from the origin %.2e\n", flat, c1, c2, far);
	assert_true(c1 < 0.5*flat);
	assert_true(c2 < 0.5*c1);
	assert_true(far < 1.5*c2);
}

/* On a plane K x = 0 inside, and every patch is flat: the plane stays, to rounding. */
static void
a_plane_stays_a_plane(void **state)
{
	const double c[3] = { 0.4, 0.5, -0.2 };
	Soup s = grid(plane, 30, 30, 0), out;
	double most = 0;
	MendReport r;
	int v;

	(void)state;
	punch(&s, c, 0.25);
	r = mended(&s, MEND_DEFAULTS, &out);
	assert_int_equal(r.holes, 1);
	assert_true(r.vertices > 0);
	for (v = 0; v < out.nv; v++)
		most = fmax(most, fabs(out.xyz[3*v+2] - 0.75*out.xyz[3*v] + out.xyz[3*v+1]));
	assert_true(most < 1e-10);
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&s);
}

static void
handles_are_refused_or_cut(void **state)
{
	Soup s = grid(torus, 40, 16, 1), out;
	MendOptions o = MEND_DEFAULTS;
	MendReport r;

	(void)state;
	assert_int_equal(mend(&out, &s, &o, &r), MESH_EDISK);
	assert_non_null(strstr(out.err, "1 handle"));
	mend_report_free(&r);
	o.cut_handles = 1;
	r = mended(&s, o, &out);
	assert_int_equal(r.handles, 1);
	assert_int_equal(r.genus, 0);
	assert_int_equal(r.closed, 1);
	assert_true(r.handle_length < 2*M_PI*0.7);      /* not the long way round: inscribed in the short */
	assert_true(r.handle_length > 2*M_PI*0.7*0.99);
	mend_report_free(&r);
	soup_free(&out);
	o.open = MEND_OPEN_AUTO;
	r = mended(&s, o, &out);
	assert_int_equal(r.opened, 1);
	assert_int_equal(r.disks, 1);
	soup_free(&out);
	mend_report_free(&r);
	soup_free(&s);
}

/* A closed surface of six sides of a cube, each with vertices of its own. */
static Soup
cube(int n)
{
	Soup all = soup_new(0, 0);
	int side, i, j, k;

	for (side = 0; side < 6; side++) {
		const int first = all.nv, axis = side/2, u = (axis + 1)%3, v = (axis + 2)%3;
		double x[3];

		for (j = 0; j <= n; j++)
			for (i = 0; i <= n; i++) {
				x[axis] = side%2 ? 1 : -1;
				x[u] = 2.0*i/n - 1;
				x[v] = 2.0*j/n - 1;
				add_vertex(&all, x[0], x[1], x[2]);
			}
		for (j = 0; j < n; j++)
			for (i = 0; i < n; i++) {
				const int a = first + j*(n + 1) + i, b = a + n + 1;

				k = side%2;
				add(&all, a, k ? a + 1 : b + 1, k ? b + 1 : a + 1);
				add(&all, a, k ? b + 1 : b, k ? b : b + 1);
			}
	}
	return all;
}

static void
closed_stays_closed_or_is_opened(void **state)
{
	const double corner[3] = { 1, 1, 1 };
	Soup s = cube(6), out;
	MendOptions o = MEND_DEFAULTS;
	MendReport r = mended(&s, o, &out);
	Disk d;

	(void)state;
	assert_int_equal(r.closed, 1);
	assert_int_equal(out.nv, 6*6*6 + 2);
	mend_report_free(&r);
	soup_free(&out);
	o.open = MEND_OPEN_AT;
	memcpy(o.at, corner, sizeof corner);
	r = mended(&s, o, &out);
	assert_int_equal(r.opened, 1);
	assert_int_equal(disk_from_soup(&d, &out), 0);
	assert_int_equal(out.nv, 6*6*6 + 2 + d.nb/2 - 1);       /* the ends are not doubled */
	disk_free(&d);
	assert_true(r.cut >= 2*sqrt(5.0));      /* from corner to corner of the cube, unfolded */
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&s);
}

static void
one_sided_is_refused(void **state)
{
	Soup s = soup_new(0, 0), out;
	MendOptions o = MEND_DEFAULTS;
	MendReport r;
	int i;

	(void)state;
	for (i = 0; i < 12; i++) {
		const double a = 2*M_PI*i/12, b = a/2;

		add_vertex(&s, cos(a)*(1 + 0.3*cos(b)), sin(a)*(1 + 0.3*cos(b)), 0.3*sin(b));
		add_vertex(&s, cos(a)*(1 - 0.3*cos(b)), sin(a)*(1 - 0.3*cos(b)), -0.3*sin(b));
	}
	for (i = 0; i < 12; i++) {
		const int a = 2*i, b = 2*i + 1, c = i < 11 ? a + 2 : 1, d = i < 11 ? a + 3 : 0;

		add(&s, a, b, c);
		add(&s, c, b, d);
	}
	assert_int_equal(mend(&out, &s, &o, &r), MESH_EORIENT);
	mend_report_free(&r);
	o.check = 1;
	r = mended(&s, o, &out);
	assert_int_equal(r.one_sided, 1);
	mend_report_free(&r);
	soup_free(&out);
	soup_free(&s);
}

/* What was mended once is not changed again. */
static void
a_second_pass_changes_nothing(void **state)
{
	const double c[3] = { 0.1, 0.05, 1 };
	Soup s = grid(sphere, 20, 20, 0), once;
	MendReport r;

	(void)state;
	punch(&s, c, 0.3);
	add(&s, 0, add_vertex(&s, -2, -2, 0), add_vertex(&s, -2, -2.1, 0));     /* pinched */
	r = mended(&s, MEND_DEFAULTS, &once);
	mend_report_free(&r);
	channels_free(&once.channels);         /* their numbers would go along */
	done(becomes(&once, &once));
	soup_free(&once);
	soup_free(&s);
}

/* ---- random soups ---- */

static unsigned
draw(uint64_t *state, unsigned n)
{
	*state = *state*6364136223846793005u + 1442695040888963407u;
	return (unsigned)(*state >> 33)%n;
}

/* Few places, so that vertices coincide, faces have no area, and edges have many faces. */
static Soup
random_soup(uint64_t seed)
{
	const unsigned side = 2 + (unsigned)(seed%3);
	Soup s = soup_new(0, 0);
	uint64_t state = seed;
	int nv = 4 + (int)draw(&state, 20), nf = 1 + (int)draw(&state, 40), i;

	for (i = 0; i < nv; i++) {
		const double x = draw(&state, side), y = draw(&state, side), z = draw(&state, side);

		add_vertex(&s, x, y, draw(&state, 50) ? z : NAN);
	}
	for (i = 0; i < nf; i++) {
		const int a = (int)draw(&state, (unsigned)nv), b = (int)draw(&state, (unsigned)nv);

		add(&s, a, b, (int)draw(&state, (unsigned)nv));
	}
	return s;
}

/* Whatever comes in: an error with a reason, or components that are manifold, oriented, and counted
 * rightly; and a disk if there is but one. */
static void
any_soup_is_mended_or_refused(void **state)
{
	int seed, disks = 0, refused = 0, loops = 0, flat = 0, e, e2;
	MendReport r;
	Disk d;

	(void)state;
	for (seed = 1; seed <= 4000; seed++) {
		Soup s = random_soup((uint64_t)seed), out;
		MendOptions o = MEND_DEFAULTS;

		o.components = seed%4;
		o.weld = seed%5 ? 0 : seed%2 ? 0.5 : MEND_WELD_NONE;
		o.cut_handles = seed%2;
		o.fill_all = seed%7 == 0;
		o.open = seed%3 ? MEND_CLOSED : MEND_OPEN_AUTO;
		o.fill = seed%3;
		if ((e = mend(&out, &s, &o, &r)) != 0) {
			if (!out.err[0] || (e != MESH_EDISK && e != MESH_EORIENT))
				fail_msg("seed %d: error %d: %s", seed, e, out.err);
			refused++;
		} else {
			if (out.nv == 3*out.nf && r.left > 1) {       /* disk_from_soup would weld them */
				mend_report_free(&r);
				soup_free(&out);
				soup_free(&s);
				continue;
			}
			e2 = disk_from_soup(&d, &out);
			if (e2 && (e2 != MESH_EDISK || r.left == r.disks) && !r.flat_left && r.left*r.disks <= 1)
				fail_msg("seed %d: no disk: %s", seed, d.err);
			if (e2 == MESH_EMANIFOLD || e2 == MESH_EORIENT || (e2 == MESH_EFACE && !r.flat_left))
				fail_msg("seed %d: no surface: %s", seed, d.err);
			if (!e2)
				disk_free(&d);
			disks += !e2;
			loops += r.left == 1 && r.disks == 0 && r.closed == 0;
			flat += r.flat_left > 0;
		}
		mend_report_free(&r);
		if (!e)
			soup_free(&out);
		soup_free(&s);
	}
	print_message("%d disks, %d with several loops, %d with flat faces, %d refused\n", disks, loops, flat, refused);
	assert_true(disks > 1000);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(a_disk_stays),
		cmocka_unit_test(a_soup_is_welded),
		cmocka_unit_test(a_seam_is_welded),
		cmocka_unit_test(faces_that_do_not_belong_go),
		cmocka_unit_test(specks_and_flaps_go),
		cmocka_unit_test(faces_are_turned),
		cmocka_unit_test(vertices_on_edges),
		cmocka_unit_test(short_edges_collapse),
		cmocka_unit_test(a_patch_continues_the_surface),
		cmocka_unit_test(a_plane_stays_a_plane),
		cmocka_unit_test(handles_are_refused_or_cut),
		cmocka_unit_test(closed_stays_closed_or_is_opened),
		cmocka_unit_test(one_sided_is_refused),
		cmocka_unit_test(a_second_pass_changes_nothing),
		cmocka_unit_test(any_soup_is_mended_or_refused)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
