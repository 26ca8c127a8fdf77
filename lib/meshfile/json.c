/* json.c - JSON text as a list of its values. */
#include <stdlib.h>
#include <string.h>

#include "json.h"

enum { DEEPEST = 200 };         /* arrays and objects inside each other */

static int value(Json *j, int depth);

static void
blanks(Json *j)
{
	while (j->p < j->end && strchr(" \t\n\r", *j->p) && *j->p)
		j->p++;
}

static int
fail(const Json *j, const char *why)
{
	return mesh_fail(j->r->s->err, MESH_EFORMAT, "byte %zu of the JSON text: %s", (size_t)(j->p - j->text),
	    j->p < j->end ? why : "it ends here");
}

/* Whether the next character is c; goes past it then. */
static int
comes(Json *j, char c)
{
	blanks(j);
	if (j->p == j->end || *j->p != c)
		return 0;
	j->p++;
	return 1;
}

static int
string(Json *j)
{
	for (j->p++; j->p < j->end && *j->p != '"'; j->p++)
		if (*j->p == '\\' && j->p + 1 < j->end)
			j->p++;
	if (j->p == j->end)
		return fail(j, "");
	j->p++;
	return 0;
}

/* The values of an array, or the keys and values of an object, up to the bracket that closes it. */
static int
inside(Json *j, int depth, char close)
{
	int e;

	j->p++;
	if (comes(j, close))
		return 0;
	do {
		blanks(j);
		if (close == '}' && (j->p == j->end || *j->p != '"'))
			return fail(j, "no key");
		if ((e = value(j, depth + 1)) != 0)
			return e;
		if (close == '}' && (!comes(j, ':') ? fail(j, "no ':'") : (e = value(j, depth + 1))))
			return e ? e : MESH_EFORMAT;
	} while (comes(j, ','));
	return comes(j, close) ? 0 : fail(j, "no ',' or closing bracket");
}

static int
value(Json *j, int depth)
{
	const uint32_t me = j->n;
	const char *begin;
	int e = 0;

	blanks(j);
	if (j->p == j->end)
		return fail(j, "");
	if (depth > DEEPEST)
		return fail(j, "too many brackets inside each other");
	begin = j->p;
	j->n++;
	if (*j->p == '{' || *j->p == '[')
		e = inside(j, depth, *j->p == '{' ? '}' : ']');
	else if (*j->p == '"')
		e = string(j);
	else
		while (j->p < j->end && *j->p && strchr("+-.0123456789abcdefghijklmnopqrstuvwxyzE", *j->p))
			j->p++;
	if (!e && j->p == begin)
		e = fail(j, "no value");
	j->value[me] = (JsonValue){ (uint32_t)(begin - j->text), (uint32_t)(j->p - begin), j->n };
	return e;
}

/* At least as many as there are values: each follows one of [ { , : or the beginning. */
static size_t
most_values(const char *p, const char *end)
{
	size_t n = 1;
	int quoted = 0;

	for (; p < end; p++)
		if (quoted && *p == '\\')
			p++;
		else if (*p == '"')
			quoted = !quoted;
		else
			n += !quoted && (*p == '[' || *p == '{' || *p == ',' || *p == ':');
	return n;
}

int
json_read(Json *j, Reader *r, const char *p, const char *end)
{
	int e;

	*j = (Json){ .r = r, .text = p, .p = p, .end = end };
	if ((unsigned long long)(end - p) > UINT32_MAX)
		return mesh_fail(r->s->err, MESH_EFORMAT, "JSON text of 4 GiB or more");
	j->value = mesh_alloc(r->s->err, most_values(p, end), sizeof *j->value);
	if (!j->value)
		return MESH_ENOMEM;
	e = value(j, 0);
	blanks(j);
	while (!e && j->p < j->end && *j->p == '\0')    /* padding */
		j->p++;
	if (!e && j->p < j->end)
		e = fail(j, "more text after the end");
	if (e)
		free(j->value);
	return e;
}

static char
kind(const Json *j, long long v)
{
	return v < 0 ? '\0' : j->text[j->value[v].at];
}

long long
json_first(const Json *j, long long in)
{
	const char k = kind(j, in);

	return (k == '[' || k == '{') && j->value[in].next > in + 1 ? in + 1 : -1;
}

long long
json_next(const Json *j, long long in, long long v)
{
	return in >= 0 && v >= 0 && j->value[v].next < j->value[in].next ? (long long)j->value[v].next : -1;
}

long long
json_get(const Json *j, long long object, const char *key)
{
	long long v;
	Token t;

	if (kind(j, object) != '{')
		return -1;
	for (v = json_first(j, object); v >= 0; v = json_next(j, object, v + 1)) {
		t = json_text(j, v);
		if (t.n == strlen(key) && memcmp(t.s, key, t.n) == 0)
			return v + 1;
	}
	return -1;
}

double
json_number(const Json *j, long long v, double none)
{
	double x;

	return v >= 0 && kind(j, v) != '"' && scan_number(json_text(j, v), &x) ? x : none;
}

long long
json_int(const Json *j, long long v, long long none)
{
	const double x = json_number(j, v, 0.5);

	return x >= -9e15 && x <= 9e15 && x == (double)(long long)x ? (long long)x : none;
}

Token
json_text(const Json *j, long long v)
{
	if (v < 0)
		return (Token){ "", 0 };
	if (kind(j, v) == '"')
		return (Token){ j->text + j->value[v].at + 1, j->value[v].n - 2 };
	return (Token){ j->text + j->value[v].at, j->value[v].n };
}
