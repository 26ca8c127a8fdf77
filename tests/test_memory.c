/* test_memory.c - functions of lib/ and format/ are called again and again, each time with another
 * allocation that fails: they must return an error and free all memory that they allocated.
 *
 * The program is linked with fault.c, which says which allocations it does not let fail.  After the
 * call in which allocation N fails comes one in which allocation N + 1 + N/SHARE fails.  If SOAK is
 * set, each of the first 3000 allocations fails, and SHARE is 100 for later ones.
 */
#include "cmock.h"

#include <errno.h>

#include "../format/lhg.h"
#include "../lib/map/conformal.h"
#include "../lib/map/corners.h"
#include "../lib/mesh/disk.h"
#include "../lib/mesh/distance.h"
#include "../lib/scales/filter.h"
#include "../lib/surface/frame.h"
#include "../lib/grid/gridmesh.h"
#include "../lib/meshfile/glb.h"
#include "../lib/meshfile/meshfile.h"
#include "../lib/surface/surface.h"
#include "../lib/synth/synth.h"
#include "fault.h"
#include "sockcap.h"

enum { SHARE = 40 };

/* Tells the leak detector to ignore memory that CGAL itself leaks if operator new throws while CGAL
 * builds a container. */
const char *__lsan_default_suppressions(void);
const char *
__lsan_default_suppressions(void)
{
	return "leak:allocate_new_block\nleak:CGAL::Properties\nleak:CGAL::Kd_tree\n";
}

static Mesh mesh;               /* the input, allocated before any fault */
static Disk disk;
static int  corner[4];

/* Calls work(which) repeatedly, each time with another failing allocation.  work must return 0 or
 * an error, and free its memory in either case. */
static void
refuse_each(int (*work)(int), int which)
{
	const int soak = getenv("SOAK") != NULL;
	const long live = fault_live();
	long n, tried = 0;
	int e;

	for (n = 1; ; n += soak && n < 3000 ? 1 : 1 + n/(soak ? 100 : SHARE), tried++) {
		fault_set("memory", n, n, ENOMEM);
		e = work(which);
		if (fault_live() != live)
			fail_msg("request %ld refused: %ld blocks not freed", n, fault_live() - live);
		if (fault_seen() < n)
			break;
		if (e >= 0)
			fail_msg("request %ld refused, and no error", n);
	}
	fault_set("", 0, 0, 0);
	assert_int_equal(e, 0);
	assert_true(tried > 0);
}

static int
through_a_file(int row)
{
	Soup s = { 0 };
	Disk d = { .m = { 0 } };
	char *bytes = NULL;
	size_t n;
	int c[4], e = meshfile_write_mesh(&mesh, meshformat(row), &bytes, &n);

	if (!e && (e = meshfile_parse(&s, bytes, n, 1 << 20)) == 0) {
		if ((e = disk_from_soup(&d, &s)) == 0) {
			e = corners_auto(&d, c);
			disk_free(&d);
		}
		soup_free(&s);
	}
	free(bytes);
	return e;
}

/* Reads a kept input of the fuzz target of a format that is only read. */
static const char *const seed[] = { "xyz/seed0", "mni/seed0", "hoppe/seed0", "fsbinary/seed1", "fsascii/seed0", "vtk/seed1",
	"vtk/seed2", "gifti/seed0", "gifti/seed2", "vtp/seed2", "vtp/seed3", "gltf/seed0" };

static int
kept_input(int i)
{
	char path[100], bytes[4096];
	FILE *f;
	size_t n;
	Soup s;
	int e;

	snprintf(path, sizeof path, "tests/fuzz/corpus/%s", seed[i]);
	if (!(f = fopen(path, "rb")))
		return 1;
	n = fread(bytes, 1, sizeof bytes, f);
	fclose(f);
	if (!(e = meshfile_parse(&s, bytes, n, 1 << 20)))
		soup_free(&s);
	return e;
}

static int
synthetic(int n)
{
	double *xy = NULL;
	Synth s;
	Mesh m;
	int e;

	synth_init(&s, "cap");
	e = synth_mesh(&s, n, 1, &m, &xy);
	if (!e) {
		mesh_free(&m);
		free(xy);
	}
	return e;
}

static int
mapped(int way)
{
	static const ConformalOptions options[2] = {
		{ .map = { 1, 0, 1000 }, .surface = SAMPLER_FACETS, .polish = 0 }, { .map = { 1e-3, 1, 1000 }, .surface = SAMPLER_SMOOTH, .polish = 1 }
	};
	SpdReport report;
	Conformal c;
	int e = conformal_grid(&disk, corner, (Chart){ 9, 7, 1, &CHART_RECTANGLE }, &options[way], &c,
		&report);

	if (!e)
		conformal_free(&c);
	return e;
}

enum { NU = 9, NV = 7, NODES = NU*NV };

/* A simple curved surface. */
static void
sheet(double phi[3][NODES])
{
	int i, j;

	for (j = 0; j < NV; j++)
		for (i = 0; i < NU; i++) {
			phi[0][j*NU+i] = i/(NU - 1.0);
			phi[1][j*NU+i] = j/(NV - 1.0);
			phi[2][j*NU+i] = i*j/400.0;
		}
}

/* Reconstructs the sheet.  way 0: by the surface method with a start; 1: without a start; 2: by the
 * frame method; 3: a cap on the sock, without a start. */
static int
solved(int way)
{
	static const double end[2] = { 1, 1 };
	double phi[3][NODES], start[3][NODES], lambda[NODES], H[NODES];
	double *x[3] = { phi[0], phi[1], phi[2] };
	Surface s = { .g = { NU, NV, 1, &CHART_RECTANGLE }, .lambda = lambda, .H = H,
		.start_chart = { NU, NV, 1, &CHART_RECTANGLE },
	    .start_end = { end[0], end[1] }, .start = way ? NULL : start[0] };
	FitOptions o = { .tolerance = 1e-4, .most = 50, .sharpen = 1 };
	FitProgress at;
	int p, e;

	sheet(phi);
	sheet(start);
	for (p = 0; p < NODES; p++) {
		lambda[p] = 1;
		H[p] = 0;
	}
	if (way == 3) {
		s.filtered = 1;
		s.g = (Chart){ NU - 1, NV, 0.4, &CHART_SOCK };
		sample_sockcap(s.g, 1, (double *[3]){ phi[0], phi[0] + (NU - 1)*NV, phi[0] + 2*(NU - 1)*NV }, lambda, H);
	}
	if (way == 2)
		return frame_surface(s.g, lambda, H, x, &p, NULL);
	e = surface(&s, &o, phi[0], &at);
	return e < 0 ? e : !e;
}

static int
filtered(int basis)
{
	Spectrum s = { basis, { NU, NV, 1, &CHART_RECTANGLE } };
	Filter by = { FILTER_KEEP, 5, 1 };
	double f[NODES], out[2*NODES];
	size_t kept;
	int p, e;

	for (p = 0; p < NODES; p++)
		f[p] = 1 + p%5;
	e = filter_field(s, &by, f, &kept);
	return e < 0 ? e : filter_percent(s, 1, f, out);
}

static int
compared(int crossings)
{
	const Chart g = { NU, NV, 1, &CHART_RECTANGLE };
	double phi[3][NODES], d;
	long pairs;
	Mesh m;
	int e;

	sheet(phi);
	if ((e = mesh_from_grid(&m, g, (const double *[]){ phi[0], phi[1], phi[2] })) != 0)
		return e;
	e = crossings ? distance_crossings(&m, &pairs) : distance_hausdorff(&m, &mesh, 0.1, &d);
	mesh_free(&m);
	return e;
}

/* Writes a stream of grids with metadata and history, and reads it again. */
static int
passed_on(int frames)
{
	FILE *f = tmpfile();
	LhgStream s;
	Lhg g, h;
	int k, e = 0;

	assert_non_null(f);
	lhg_init(&g, NU, NV, 0.7);
	g.frames = frames;
	if (!lhg_add(&g, "x", "length", LHG_GRID, 0) || !lhg_add(&g, "band.x", "length", LHG_BORDER, 2))
		e = LHG_ENOMEM;
	lhg_open(&s, f);
	for (k = 1; !e && k <= frames; k++) {
		g.frame = k;
		e = lhg_setmeta(&g, "t", "0.5");
		if (!e)
			e = lhg_note(&g, "step");
		if (!e)
			e = lhg_write(&s, &g);
	}
	rewind(f);
	lhg_open(&s, f);
	while (!e && (k = lhg_read(&s, &h)) != 0)
		if (k < 0)
			e = k;
		else
			lhg_free(&h);
	lhg_free(&g);
	fclose(f);
	return e;
}


/* Mesh files of every format are written and read while allocations fail. */
static void
files(void **state)
{
	int row;

	(void)state;
	for (row = 0; meshformat(row); row++)
		if (meshformat(row)->can & MESHFORMAT_WRITE)
			refuse_each(through_a_file, row);
}

static void
readers(void **state)
{
	int i;

	(void)state;
	for (i = 0; i < (int)(sizeof seed/sizeof *seed); i++)
		refuse_each(kept_input, i);
}

static void synth(void **state)    { (void)state; refuse_each(synthetic, 40); }
static void facets(void **state)      { (void)state; refuse_each(mapped, 0); }
static void polished(void **state)   { (void)state; refuse_each(mapped, 1); }
static void fit_start(void **state) { (void)state; refuse_each(solved, 0); }
static void fit_frame(void **state) { (void)state; refuse_each(solved, 1); }
static void fit_sock(void **state) { (void)state; refuse_each(solved, 3); }
static void frame(void **state)    { (void)state; refuse_each(solved, 2); }
static void dct(void **state)      { (void)state; refuse_each(filtered, SPECTRUM_DCT); }
static void dft(void **state)      { (void)state; refuse_each(filtered, SPECTRUM_DFT); }
static void hausdorff(void **state) { (void)state; refuse_each(compared, 0); }
static void crossings(void **state) { (void)state; refuse_each(compared, 1); }
static void grids(void **state)    { (void)state; refuse_each(passed_on, 3); }

static int
begin(void **state)
{
	Soup s;
	Synth kind;
	char *bytes;
	size_t n;

	(void)state;
	return synth_init(&kind, "cap") || synth_mesh(&kind, 40, 1, &mesh, NULL) ||
	    meshfile_write_mesh(&mesh, meshformat(0), &bytes, &n) || meshfile_parse(&s, bytes, n, 1 << 20) ||
	    disk_from_soup(&disk, &s) || corners_auto(&disk, corner) || (free(bytes), soup_free(&s), 0);
}

/* Two frames of a square. */
static int
to_glb(int colours)
{
	static float place[3*4] = { 0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0 };
	static const int tri[6] = { 0, 1, 2, 0, 2, 3 };
	static const unsigned short white[16] = { 65535, 65535, 65535, 65535 };
	float *const xyz[2] = { place, place };
	const Glb g = { 4, 2, tri, 2, xyz, colours ? white : NULL, 1 };
	char *bytes = NULL;
	size_t n;
	int e = glb_write(&g, &bytes, &n);

	free(bytes);
	return e;
}

static void
glb(void **state)
{
	(void)state;
	refuse_each(to_glb, 0);
	refuse_each(to_glb, 1);
}

static int
end(void **state)
{
	(void)state;
	mesh_free(&mesh);
	disk_free(&disk);
	return fault_live() != 0;
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(files), cmocka_unit_test(readers), cmocka_unit_test(glb),
		cmocka_unit_test(synth), cmocka_unit_test(facets), cmocka_unit_test(polished),
		cmocka_unit_test(fit_start), cmocka_unit_test(fit_frame),
		cmocka_unit_test(fit_sock), cmocka_unit_test(frame),
		cmocka_unit_test(dct), cmocka_unit_test(dft),
		cmocka_unit_test(hausdorff), cmocka_unit_test(crossings), cmocka_unit_test(grids),
	};

	return cmocka_run_group_tests(tests, begin, end);
}
