/* facts.c - statements of a mesh file about its coordinates. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "facts.h"
#include "meshpriv.h"

/* Copies the value with each run of blanks as one, none at its ends, and ? for bytes that are not
 * printable ASCII.  What does not fit is cut off.  Returns its length. */
static size_t
clean(Token t, char out[FACT_VALUE])
{
	size_t i, n = 0;

	for (i = 0; i < t.n && n < FACT_VALUE - 1; i++)
		if (!strchr(" \t\r\n\v\f", t.s[i]) || !t.s[i])
			out[n++] = t.s[i] > ' ' && t.s[i] < 127 ? t.s[i] : '?';
		else if (n > 0 && out[n-1] != ' ')
			out[n++] = ' ';
	n -= n > 0 && out[n-1] == ' ';
	out[n] = '\0';
	return n;
}

int
fact_add(Reader *r, const char *key, Token value)
{
	char v[FACT_VALUE], *p;
	const size_t had = r->s->facts ? strlen(r->s->facts) : 0;
	const size_t n = strlen(key) + clean(value, v) + 3;

	if (n == strlen(key) + 3 || had + n > FACTS_MOST)
		return 0;
	if (!(p = realloc(r->s->facts, had + n)))
		return mesh_fail(r->s->err, MESH_ENOMEM, "no memory for the fact %s", key);
	snprintf(p + had, n, "%s %s\n", key, v);
	r->s->facts = p;
	return 0;
}

int
fact_is(const char *key)
{
	static const char *const known[] = { "space", "c_ras", "unit", "source" };
	size_t i;

	for (i = 0; i < sizeof known/sizeof *known; i++)
		if (strcmp(key, known[i]) == 0)
			return 1;
	if (strncmp(key, "fs.", 3) != 0 || !key[3] || strlen(key) >= FACT_KEY)
		return 0;
	for (key += 3; *key >= 'a' && *key <= 'z'; key++)
		continue;
	return *key == '\0';
}

int
fact_comment(Reader *r)
{
	char key[FACT_KEY];
	const char *from;
	Token t;

	if (!scan_word(r, &t) || t.n >= sizeof key)
		return 0;
	memcpy(key, t.s, t.n);
	key[t.n] = '\0';
	from = r->p;
	scan_skipline(r);
	return fact_is(key) ? fact_add(r, key, (Token){ from, (size_t)(r->p - from) }) : 0;
}

const char *
fact_next(const char *facts, char key[FACT_KEY], char value[FACT_VALUE])
{
	const char *blank, *end;

	if (!facts || !(end = strchr(facts, '\n')) || !(blank = memchr(facts, ' ', (size_t)(end - facts))))
		return NULL;
	snprintf(key, FACT_KEY, "%.*s", (int)(blank - facts), facts);
	snprintf(value, FACT_VALUE, "%.*s", (int)(end - blank - 1), blank + 1);
	return end + 1;
}
