/* meshfile.c - which kind of mesh file is this, and read it. */
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "meshfile.h"
#include "meshpriv.h"

/* What people will try that we do not read, by its first bytes. */
static const struct {
	const char *magic;
	size_t n;
	const char *kind;
} OTHER[] = {
	{ "\xff\xff\xfe", 3,          "a FreeSurfer surface" },
	{ "\xff\xff\xff", 3,          "a FreeSurfer curvature file" },
	{ "#!ascii version of", 18,   "a FreeSurfer ASCII surface" },
	{ "# vtk DataFile", 14,       "a legacy VTK file" },
	{ "MATLAB 5.0 MAT-file", 19,  "a MATLAB file" },
	{ "\x89HDF", 4,               "an HDF5 file" },
	{ "lhg ", 4,                  "an lhg grid" },
	{ "glTF", 4,                  "a glTF file" },
	{ "PK\3\4", 4,                "a zip archive" },
	{ "\x28\xb5\x2f\xfd", 4,      "a zstd file" },
	{ "\xfd" "7zXZ", 5,           "an xz file" },
	{ "BZh", 3,                   "a bzip2 file" },
	{ "\x1f\x8b", 2,              "gzip data within gzip data" }
};

typedef int Read(Reader *);

static int
contains(const Reader *r, size_t most, const char *word)
{
	const size_t n = strlen(word), left = scan_left(r) < most ? scan_left(r) : most;
	size_t i;

	for (i = 0; i + n <= left; i++)
		if (memcmp(r->p + i, word, n) == 0)
			return 1;
	return 0;
}

static const char *
otherkind(const Reader *r, Token first)
{
	size_t i;

	for (i = 0; i < sizeof OTHER / sizeof *OTHER; i++)
		if (scan_left(r) >= OTHER[i].n && memcmp(r->p, OTHER[i].magic, OTHER[i].n) == 0)
			return OTHER[i].kind;
	if (first.n > 0 && *first.s == '<')
		return contains(r, 2000, "GIFTI") ? "a GIFTI file" :
		    contains(r, 2000, "VTKFile") ? "a VTK XML file" : "an XML or HTML file";
	return scan_is(first, "Vertex") ? "a Hoppe .m mesh" : NULL;
}

static int
isobj(Token t)
{
	static const char *const word[] = { "v", "vt", "vn", "vp", "f", "o", "g", "s", "l", "p",
	    "mtllib", "usemtl" };
	size_t i;

	for (i = 0; i < sizeof word / sizeof *word; i++)
		if (scan_is(t, word[i]))
			return 1;
	return 0;
}

/* Binary data whose first 84 bytes could begin an STL of believable size. */
static int
nearlystl(const Reader *r)
{
	return scan_left(r) >= 84 && scan_bytes(r->p + 80, 4, 0) < 100000000 &&
	    memchr(r->p, '\0', 84) != NULL;
}

/* The reader for what r holds, or NULL with the reason in err. */
static Read *
choose(const Reader *r, char *err)
{
	Reader ahead = *r;
	Token t = { "", 0 };
	const char *kind;
	int extra;

	ahead.hash = 1;
	if (!scan_token(&ahead, &t))
		t.n = 0;
	if (stl_isbinary(r->p, scan_left(r)))
		return stl_read;
	if ((kind = otherkind(r, t)) != NULL) {
		mesh_fail(err, MESH_EFORMAT, "this is %s, not OFF, OBJ, PLY or STL", kind);
		return NULL;
	}
	if (t.s == r->p && t.n == 3 && memcmp(t.s, "ply", 3) == 0)
		return ply_read;
	if (off_keyword(t, &extra))
		return off_read;
	if (scan_is(t, "solid") || nearlystl(r))
		return stl_read;
	if (isobj(t))
		return obj_read;
	mesh_fail(err, MESH_EFORMAT, "not an OFF, OBJ, PLY or STL file");
	return NULL;
}

/* Every corner is a vertex.  first is there also when there is no face. */
static int
finish(Reader *r)
{
	Soup *s = r->s;
	int e, f, i;

	if ((e = soup_reserve(r, 0, 0, 0)) != 0)
		return e;
	for (f = 0; f < s->nf; f++)
		for (i = s->first[f]; i < s->first[f+1]; i++)
			if (s->idx[i] < 0 || s->idx[i] >= s->nv)
				return mesh_fail(s->err, MESH_EINDEX, "face %d names vertex %d of %d",
				    f, s->idx[i], s->nv);
	return 0;
}

static int
plain(Soup *s, const char *p, size_t n, int wantuv)
{
	Reader r = { .p = p, .end = p + n, .line = 1, .s = s, .wantuv = wantuv };
	Read *read;
	int e;

	if (n >= 3 && memcmp(p, "\xef\xbb\xbf", 3) == 0)
		r.p += 3;                       /* the byte order mark of some editors */
	if (r.p == r.end)
		return mesh_fail(s->err, MESH_EFORMAT, "empty input");
	read = choose(&r, s->err);
	if (!read)
		return MESH_EFORMAT;
	if (wantuv && read != obj_read && read != ply_read)
		return mesh_fail(s->err, MESH_EFORMAT, "only OBJ and PLY carry (u,v)");
	if ((e = soup_reserve(&r, 0, 0, 0)) == 0 && (e = read(&r)) == 0)
		e = finish(&r);
	if (!e && wantuv)
		e = uv_check(s);
	if (e)
		soup_free(s);
	return e;
}

static int
parse(Soup *s, const void *bytes, size_t n, int wantuv)
{
	const char *p = bytes;
	char *out;
	int e;

	memset(s, 0, sizeof *s);
	if (n < 2 || memcmp(p, "\x1f\x8b", 2) != 0)
		return plain(s, p, n, wantuv);
	if ((e = gunzip(p, n, &out, &n, s->err)) != 0)
		return e;
	e = plain(s, out, n, wantuv);
	free(out);
	return e;
}

int
meshfile_parse(Soup *s, const void *bytes, size_t n)
{
	return parse(s, bytes, n, 0);
}

int
meshfile_parse_uv(Soup *s, const void *bytes, size_t n)
{
	return parse(s, bytes, n, 1);
}

int
meshfile_kind(const char *name)
{
	static const char *const end[] = { ".off", ".obj", ".ply", ".stl" };
	const size_t n = strlen(name);
	int k;

	for (k = 0; k < 4; k++)
		if (n > 4 && strcasecmp(name + n - 4, end[k]) == 0)
			return k;
	return -1;
}
