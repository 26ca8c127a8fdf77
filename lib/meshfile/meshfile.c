/* meshfile.c - recognises the format of a mesh file and reads it; writes mesh files. */
#include <stdlib.h>
#include <string.h>

#include "meshfile.h"
#include "meshpriv.h"
#include "writepriv.h"

#define UTF16 "UTF-16 text (iconv -f UTF-16 -t UTF-8 converts it)"

/* Other formats that people may try, by their first bytes. */
static const struct {
	const char *magic;
	size_t n;
	const char *kind;
} OTHER[] = {
	{ "\xff\xfe\0\0", 4,        "UTF-32 text (iconv -f UTF-32 -t UTF-8 converts it)" },
	{ "\xff\xfe", 2,             UTF16 },
	{ "\xfe\xff", 2,             UTF16 },
	{ "\xff\xff\xff\xff", 4,      "a FreeSurfer patch" },
	{ "\xff\xff\xff", 3,          "a FreeSurfer curvature file or surface of quadrangles" },
	{ "\xff\xff\xfd", 3,          "a FreeSurfer surface of quadrangles" },
	{ "MATLAB 5.0 MAT-file", 19,  "a MATLAB file" },
	{ "\x89HDF", 4,               "an HDF5 file" },
	{ "lhg ", 4,                  "an lhg grid" },
	{ "PK\3\4", 4,                "a zip archive" },
	{ "\x28\xb5\x2f\xfd", 4,      "a zstd file" },
	{ "\xfd" "7zXZ", 5,           "an xz file" },
	{ "BZh", 3,                   "a bzip2 file" },
	{ "\x1f\x8b", 2,              "gzip data within gzip data" }
};

/* Whether it is UTF-16 text without a byte order mark, of which every second byte is 0. */
static int
is_utf16(const MeshStart *m)
{
	const size_t zero = m->n > 0 && m->p[0] != '\0';
	size_t i;

	for (i = 0; i < m->n && i < 32; i++)
		if ((m->p[i] == '\0') != (i % 2 == zero) || (unsigned char)m->p[i] > 126)
			return 0;
	return i >= 8;
}

static const char *
other_format(const MeshStart *m)
{
	size_t i;

	for (i = 0; i < sizeof OTHER / sizeof *OTHER; i++)
		if (m->n >= OTHER[i].n && memcmp(m->p, OTHER[i].magic, OTHER[i].n) == 0)
			return OTHER[i].kind;
	if (is_utf16(m))
		return UTF16;
	return NULL;
}

static int
is_gzip(const char *p, size_t n)
{
	return n >= 2 && memcmp(p, "\x1f\x8b", 2) == 0;
}

/* The beginning of a file of `least` to `most` bytes.  Its first n bytes are at p. */
static MeshStart
beginning_of(const char *p, size_t n, size_t least, size_t most)
{
	MeshStart m = { .p = p, .n = n, .least = least, .most = most };
	Reader ahead = { .hash = 1 };

	if (n >= 3 && memcmp(p, "\xef\xbb\xbf", 3) == 0)
		m.p += 3, m.n -= 3, m.least -= 3, m.most -= 3;  /* the byte order mark of some editors */
	ahead.p = m.p;
	ahead.end = m.p + m.n;
	if (!scan_token(&ahead, &m.word))
		m.word.n = 0;
	return m;
}

/* The format of a file, or NULL with the reason in err. */
static const MeshFormat *
choose(const MeshStart *m, char *err)
{
	const MeshFormat *f, *best = NULL;
	int i, how, most = MESHSTART_NO;
	const char *kind;
	char list[MESHFORMAT_LIST];

	for (i = 0; (f = meshformat(i)); i++)
		if ((how = f->recognise(m)) > most) {
			best = f;
			most = how;
		}
	if (most < MESHSTART_SURE && (kind = other_format(m)) != NULL) {
		mesh_fail(err, MESH_EFORMAT, "this is %s, not %s", kind, meshformat_names(0, "or", list));
		return NULL;
	}
	if (!best && m->word.n > 0 && *m->word.s == '<')
		mesh_fail(err, MESH_EFORMAT, "this is another XML or HTML file, not %s", meshformat_names(0, "or", list));
	else if (!best)
		mesh_fail(err, MESH_EFORMAT, "not an %s file", meshformat_names(0, "or", list));
	return best;
}

/* No format begins with a word of more characters than this. */
enum { LONGEST_WORD = 100 };

int
meshfile_plausible(const void *head, size_t n, size_t most, char err[MESH_ERRLEN])
{
	char out[4096];
	const int packed = is_gzip(head, n);
	const size_t k = packed ? gunzip_head(head, n, out, sizeof out) : n;
	const MeshStart m = beginning_of(packed ? out : head, k, k, most);
	const int open = m.word.s + m.word.n == m.p + m.n && m.word.n < LONGEST_WORD;

	if (m.word.n == 0 || open)
		return 0;                       /* more bytes are needed to decide */
	return choose(&m, err) ? 0 : MESH_EFORMAT;
}

/* Checks that every corner of a face is the number of a vertex.  Also allocates s->first, even if
 * there are no faces. */
static int
check_corners(Reader *r)
{
	Soup *s = r->s;
	int e, f, i;

	if ((e = soup_reserve(r, 0, 0, 0)) != 0)
		return e;
	for (f = 0; f < s->nf && !r->loose; f++)
		for (i = s->first[f]; i < s->first[f+1]; i++)
			if (s->idx[i] < 0 || s->idx[i] >= s->nv)
				return mesh_fail(s->err, MESH_EINDEX, "face %d refers to vertex %d, there are %d",
				    f, s->idx[i], s->nv);
	return 0;
}

static int
parse_unpacked(Soup *s, const char *p, size_t n, const MeshParse *how)
{
	const MeshStart m = beginning_of(p, n, n, n);
	Reader r = { .p = m.p, .end = m.p + m.n, .line = 1, .s = s, .most = how->most, .unused = m.n,
		.read_uv = (how->what & MESHFILE_UV) != 0, .loose = (how->what & MESHFILE_LOOSE) != 0,
		.fields = (how->what & MESHFILE_FIELDS) != 0, .normals = (how->what & MESHFILE_NORMALS) != 0,
		.beside = how->beside, .most_beside = how->most };
	const MeshFormat *format;
	char list[MESHFORMAT_LIST];
	int e;

	if (m.n == 0)
		return mesh_fail(s->err, MESH_EFORMAT, "empty input");
	format = choose(&m, s->err);
	if (!format)
		return MESH_EFORMAT;
	if (r.read_uv && !(format->can & MESHFORMAT_UV))
		return mesh_fail(s->err, MESH_EFORMAT, "only %s carry (u,v)",
		    meshformat_names(MESHFORMAT_UV, "and", list));
	if ((e = soup_reserve(&r, 0, 0, 0)) == 0 && (e = format->read(&r)) == 0)
		e = check_corners(&r);
	if (!e && r.read_uv)
		e = uv_check(&r);
	free(r.offset);
	if (e)
		soup_free(s);
	return e;
}

int
meshfile_parse_as(Soup *s, const void *bytes, size_t n, const MeshParse *how)
{
	const char *p = bytes;
	char *out;
	int e;

	memset(s, 0, sizeof *s);
	if (!is_gzip(p, n))
		return parse_unpacked(s, p, n, how);
	if ((e = gunzip(p, n, how->most, &out, &n, s->err)) != 0)
		return e;
	e = parse_unpacked(s, out, n, how);
	free(out);
	return e;
}

int
meshfile_parse(Soup *s, const void *bytes, size_t n, size_t most)
{
	return meshfile_parse_as(s, bytes, n, &(MeshParse){ .most = most });
}

int
meshfile_write(const Soup *s, const MeshFormat *format, char **bytes, size_t *n)
{
	Text t = { NULL, 0, 0 };
	int e = format->write(&t, s);

	if (e) {
		free(t.p);
		return e;
	}
	*bytes = t.p;
	*n = t.n;
	return 0;
}

int
meshfile_write_mesh(const Mesh *m, const MeshFormat *format, char **bytes, size_t *n)
{
	const Soup s = { .nv = m->nv, .nf = m->nf, .xyz = m->xyz, .idx = m->tri };

	return meshfile_write(&s, format, bytes, n);
}
