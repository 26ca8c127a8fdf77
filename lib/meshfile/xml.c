/* xml.c - the elements of an XML file (expat). */
#include <expat.h>
#include <string.h>

#include "xml.h"

/* The place in the file of the tag being read, and its end. */
static const char *
here(const Xml *x)
{
	return x->r->p + XML_GetCurrentByteIndex(x->parser);
}

static void
fail(Xml *x, int e)
{
	if (e && !x->e) {
		x->e = e;
		XML_StopParser(x->parser, XML_FALSE);
	}
}

/* Sets x->text to the text that ends at the tag being read. */
static void
text_before(Xml *x)
{
	const char *at = here(x);

	x->text = x->from ? (Token){ x->from, (size_t)(at - x->from) } : (Token){ at, 0 };
}

static void XMLCALL
start(void *arg, const char *name, const char **attr)
{
	Xml *x = arg;

	if (x->e)
		return;
	text_before(x);
	x->from = here(x) + XML_GetCurrentByteCount(x->parser);
	fail(x, x->start(x, name, attr));
}

static void XMLCALL
end(void *arg, const char *name)
{
	Xml *x = arg;

	if (x->e)
		return;
	if (XML_GetCurrentByteCount(x->parser) == 0)    /* <name/> */
		x->from = NULL;
	text_before(x);
	x->from = NULL;
	fail(x, x->end(x, name));
}

static void XMLCALL
entity(void *arg, const char *name, int parameter, const char *value, int n, const char *base, const char *id,
	const char *public, const char *notation)
{
	Xml *x = arg;

	(void)name, (void)parameter, (void)value, (void)n, (void)base, (void)id, (void)public, (void)notation;
	fail(x, mesh_fail(x->r->s->err, MESH_EFORMAT, "line %lu: XML entities are not read",
	    XML_GetCurrentLineNumber(x->parser)));
}

/* Feeds the bytes in pieces: expat copies what it is given. */
static int
feed(Xml *x, const char *end, int whole)
{
	enum { PIECE = 1 << 20 };
	const char *p = x->r->p;
	enum XML_Error why;

	do {
		const size_t left = (size_t)(end - p), n = left < PIECE ? left : PIECE;

		if (XML_Parse(x->parser, p, (int)n, whole && n == left) != XML_STATUS_OK) {
			if (x->e)
				return x->e;
			why = XML_GetErrorCode(x->parser);
			return mesh_fail(x->r->s->err, why == XML_ERROR_NO_MEMORY ? MESH_ENOMEM : MESH_EFORMAT,
			    "line %lu: XML: %s", XML_GetCurrentLineNumber(x->parser), XML_ErrorString(why));
		}
		p += n;
	} while (p < end);
	return 0;
}

int
xml_read(Xml *x, const char *stop, int whole)
{
	int e;

	x->e = 0;
	x->from = NULL;
	x->parser = XML_ParserCreate(NULL);
	if (!x->parser)
		return mesh_fail(x->r->s->err, MESH_ENOMEM, "no memory to read XML");
	XML_SetUserData(x->parser, x);
	XML_SetElementHandler(x->parser, start, end);
	XML_SetEntityDeclHandler(x->parser, entity);
	e = feed(x, stop, whole);
	XML_ParserFree(x->parser);
	return e;
}

const char *
xml_attribute(const char **attr, const char *name)
{
	for (; *attr; attr += 2)
		if (strcmp(attr[0], name) == 0)
			return attr[1];
	return "";
}

int
xml_count(Xml *x, const char **attr, const char *name, long long *n)
{
	const char *value = xml_attribute(attr, name);
	const Token t = { value, strlen(value) };
	char show[SCAN_SHOW];

	if (scan_int(t, n) && *n >= 0)
		return 0;
	return mesh_fail(x->r->s->err, MESH_EFORMAT, "line %lu: %s=\"%s\" is not a number",
	    XML_GetCurrentLineNumber(x->parser), name, scan_show(t, show));
}

static int
blank(char c)
{
	return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

static Token
trimmed(Token t)
{
	while (t.n > 0 && blank(*t.s))
		t.s++, t.n--;
	while (t.n > 0 && blank(t.s[t.n-1]))
		t.n--;
	return t;
}

Token
xml_plain(Token t)
{
	t = trimmed(t);
	if (t.n >= 12 && memcmp(t.s, "<![CDATA[", 9) == 0 && memcmp(t.s + t.n - 3, "]]>", 3) == 0)
		t = trimmed((Token){ t.s + 9, t.n - 12 });
	return t;
}

int
xml_recognise(const MeshStart *m, const char *root)
{
	enum { NEAR = 2000 };
	const size_t n = strlen(root);
	const char *end = m->p + (m->n < NEAR ? m->n : NEAR), *at;

	if (m->word.n < 2 || (memcmp(m->word.s, "<?", 2) != 0 && memcmp(m->word.s, "<!", 2) != 0 &&
	    (m->word.n < n || memcmp(m->word.s, root, n) != 0)))
		return MESHSTART_NO;
	for (at = m->p; (at = memchr(at, '<', (size_t)(end - at))) && (size_t)(end - at) >= n; at++)
		if (memcmp(at, root, n) == 0)
			return MESHSTART_LIKELY;
	return m->n < NEAR && m->least < m->most ? MESHSTART_MAYBE : MESHSTART_NO;
}
