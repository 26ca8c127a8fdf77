/* xmlexternal.c - arrays of GIFTI in other files. */
#include <stdio.h>
#include <string.h>

#include "beside.h"
#include "xml.h"

int
xmlarray_external(Xml *x, const char **attr, long long i, long long n, XmlArray *a)
{
	const char *name = xml_attribute(attr, "ExternalFileName");
	const size_t size = (size_t)n*(size_t)a->size;
	long long from = 0;
	char what[40];
	int e;

	if (*xml_attribute(attr, "ExternalFileOffset") && (e = xml_count(x, attr, "ExternalFileOffset", &from)) != 0)
		return e;
	snprintf(what, sizeof what, "array %lld", i);
	if ((e = beside_read(x->r, what, (Token){ name, strlen(name) }, from, size, &a->own)) != 0)
		return e;
	a->coding = XML_RAW;
	a->packing = XML_PLAIN;
	a->text = (Token){ a->own, size };
	x->r->unused += size;
	return 0;
}
