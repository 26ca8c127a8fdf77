/* fieldread.c - numbers at vertices from FreeSurfer curvature files, GIFTI arrays and PLY. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../mesh/channel.h"
#include "fieldfile.h"
#include "meshfile.h"
#include "xml.h"

/* Adds n numbers as the channel of that name, shortened if need be. */
static int
add(Reader *r, Channels *c, const char *name, const double *x, long long n)
{
	char key[CHANNEL_NAME];
	double *to;
	long long i;

	for (i = 0; i < n; i++)
		if (!isfinite(x[i]))
			return mesh_fail(r->s->err, MESH_EVALUE, "value %lld of %s is not finite", i, name);
	snprintf(key, sizeof key, "%.*s", CHANNEL_NAME - 1, name);
	to = channel_add(c, key, 1, (size_t)n);
	if (!to)
		return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %lld numbers", n);
	memcpy(to, x, (size_t)n*sizeof *to);
	return 0;
}

/* ff ff ff, the numbers of vertices, faces, values at a vertex; the values: all big-endian. */
static int
curv(Reader *r, const char *name, FieldFile *f)
{
	long long n, i;
	double *x;
	int e;

	if (scan_left(r) < 15)
		return mesh_fail(r->s->err, MESH_EFORMAT, "file ends in the counts");
	n = (long long)scan_bytes(r->p + 3, 4, 1);
	f->nf = (long long)scan_bytes(r->p + 7, 4, 1);
	if (scan_bytes(r->p + 11, 4, 1) != 1)
		return mesh_fail(r->s->err, MESH_EFORMAT, "there is not one value at each vertex");
	r->p += 15;
	if ((e = soup_check_count(r, "values", n, scan_left(r)/4)) != 0)
		return e;
	if (scan_left(r) > 4*(size_t)n)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%zu bytes follow the last of %lld values", scan_left(r) - 4*(size_t)n, n);
	x = malloc((size_t)n*sizeof *x + 1);
	if (!x)
		return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for %lld numbers", n);
	for (i = 0; i < n; i++)
		x[i] = scan_float(r->p + 4*i, 4, 1);
	f->nv = (int)n;
	e = add(r, &f->c, name, x, n);
	free(x);
	return e;
}

/* Where the reader of GIFTI is. */
typedef struct Fields {
	Reader     *r;
	FieldFile  *to;
	const char *name;
	XmlArray    a;
	long long   dim;
	int         inside, wanted, count;      /* within a DataArray; one of numbers; arrays read */
	Token       key, label; /* of the last metadatum; the Name of the array */
} Fields;

static int
start(Xml *x, const char *element, const char **attr)
{
	static const char *const coding[] = { "ASCII", "Base64Binary", "GZipBase64Binary", "ExternalFileBinary" };
	Fields *f = x->arg;
	const char *type, *how;
	long long columns = 1;
	int e, k;

	if (strcmp(element, "DataArray") != 0)
		return 0;
	if (f->inside)
		return mesh_fail(f->r->s->err, MESH_EFORMAT, "array %d has another in it", f->count);
	f->inside = 1;
	f->wanted = strcmp(xml_attribute(attr, "Intent"), "NIFTI_INTENT_POINTSET") != 0 &&
	    strcmp(xml_attribute(attr, "Intent"), "NIFTI_INTENT_TRIANGLE") != 0;
	if (!f->wanted)
		return 0;
	type = xml_attribute(attr, "DataType");
	how = xml_attribute(attr, "Encoding");
	for (k = 0; k < 4 && strcmp(how, coding[k]) != 0; k++)
		;
	if (k == 4 || (strcmp(type, "NIFTI_TYPE_FLOAT32") != 0 && strcmp(type, "NIFTI_TYPE_INT32") != 0))
		return mesh_fail(f->r->s->err, MESH_EFORMAT, "array %d: %.40s %.40s is not read", f->count, how, type);
	if ((e = xml_count(x, attr, "Dim0", &f->dim)) != 0 ||
	    (*xml_attribute(attr, "Dim1") && (e = xml_count(x, attr, "Dim1", &columns)) != 0))
		return e;
	if (columns != 1 || f->dim > 1LL << 31)
		return mesh_fail(f->r->s->err, MESH_EFORMAT, "array %d is not one number at each vertex", f->count);
	f->a = (XmlArray){ .coding = k ? XML_BASE64 : XML_ASCII, .packing = k == 2 ? XML_ZLIB : XML_PLAIN, .size = 4,
	    .kind = strcmp(type, "NIFTI_TYPE_INT32") == 0 ? 'i' : 'f',
	    .big = strcmp(xml_attribute(attr, "Endian"), "BigEndian") == 0 };
	f->label = (Token){ "", 0 };
	return k == 3 ? xmlarray_external(x, attr, f->count, f->dim, &f->a) : 0;
}

static int
take(Fields *f)
{
	char name[80];
	double *x;
	int e;

	if (f->label.n > 0)
		snprintf(name, sizeof name, "%.*s", (int)(f->label.n < 60 ? f->label.n : 60), f->label.s);
	else
		snprintf(name, sizeof name, f->count ? "%.60s_%d" : "%.60s", f->name, f->count);
	if (f->count && f->dim != f->to->nv)
		return mesh_fail(f->r->s->err, MESH_EFORMAT, "array %d has %lld numbers, those before %d", f->count, f->dim,
		    f->to->nv);
	if (!(x = xmlarray_numbers(f->r, &f->a, "values", f->dim, &e)))
		return e;
	free(f->a.own);
	f->a = (XmlArray){ .own = NULL };
	f->to->nv = (int)f->dim;
	f->count++;
	e = add(f->r, &f->to->c, name, x, f->dim);
	free(x);
	return e;
}

static int
end(Xml *x, const char *element)
{
	Fields *f = x->arg;

	if (strcmp(element, "Data") == 0 && !f->a.own)
		f->a.text = x->text;
	else if (strcmp(element, "Name") == 0)
		f->key = xml_plain(x->text);
	else if (strcmp(element, "Value") == 0 && f->key.n == 4 && memcmp(f->key.s, "Name", 4) == 0)
		f->label = xml_plain(x->text);
	else if (strcmp(element, "DataArray") == 0) {
		f->inside = 0;
		return f->wanted ? take(f) : 0;
	}
	return 0;
}

static int
gifti(Reader *r, const char *name, FieldFile *to)
{
	Fields f = { .r = r, .to = to, .name = name };
	Xml x = { .r = r, .arg = &f, .start = start, .end = end };
	int e = xml_read(&x, r->end, 1);

	free(f.a.own);
	if (!e && !f.count)
		e = mesh_fail(r->s->err, MESH_EFORMAT, "no array of numbers at vertices");
	return e;
}

/* Checks the numbers at the vertices of a PLY file, and moves them and the vertices to f. */
static int
ply(Reader *r, FieldFile *f)
{
	Soup *s = r->s;
	int e = meshfile_parse_as(s, r->p, scan_left(r), &(MeshParse){ .most = r->most, .what = MESHFILE_FIELDS }), k;

	for (k = 0; !e && k < s->channels.n; k++)
		if (strcmp(s->channels.channel[k].name, MESH_SOURCE) != 0)
			e = add(r, &f->c, s->channels.channel[k].name, s->channels.channel[k].f, s->nv);
	f->nv = s->nv;
	f->xyz = s->xyz;
	s->xyz = NULL;
	if (!e && f->c.n == 0)
		e = mesh_fail(s->err, MESH_EFORMAT, "no numbers at the vertices but their places");
	soup_free(s);
	return e;
}

int
fieldfile_parse(const char *bytes, size_t n, const char *name, const MeshBeside *beside, FieldFile *f,
	char err[MESH_ERRLEN])
{
	const size_t most = MESHFILE_MOST;
	Soup s = { .nv = 0 };
	Reader r = { .p = bytes, .end = bytes + n, .line = 1, .most = most, .unused = n, .s = &s,
		.beside = beside, .most_beside = most };
	int e;

	*f = (FieldFile){ .nv = 0 };
	if (n > 3 && memcmp(bytes, "\xff\xff\xff", 3) == 0)
		e = curv(&r, name, f);
	else if (n > 5 && (bytes[0] == '<' || memcmp(bytes, "\xef\xbb\xbf<", 4) == 0))
		e = gifti(&r, name, f);
	else if (n > 3 && memcmp(bytes, "ply", 3) == 0)
		e = ply(&r, f);
	else
		e = mesh_fail(s.err, MESH_EFORMAT, "neither a FreeSurfer curvature file nor GIFTI or PLY");
	if (e) {
		snprintf(err, MESH_ERRLEN, "%s", s.err);
		fieldfile_free(f);
	}
	return e;
}

void
fieldfile_free(FieldFile *f)
{
	free(f->xyz);
	channels_free(&f->c);
	f->xyz = NULL;
}
