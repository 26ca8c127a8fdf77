/* meshreads.h - for tests of the mesh readers: what bytes are read as, and why they are refused. */
#ifndef MESHREADS_H
#define MESHREADS_H

static const size_t MOST = (size_t)1 << 32;      /* largest size that packed data may unpack to */

/* Parses a copy of exactly n bytes, so that a sanitizer sees any access beyond them. */
__attribute__((noinline, unused)) static int
parse(Soup *s, const void *bytes, size_t n)
{
	char *copy = malloc(n + !n);
	int e;

	if (n)
		memcpy(copy, bytes, n);
	e = meshfile_parse(s, copy, n, MOST);
	free(copy);
	if (e)
		assert_true(!s->xyz && !s->first && !s->idx && !s->facts && s->err[0] && !strchr(s->err, '\n'));
	return e;
}

/* Checks that the bytes are read as nv vertices and the given faces, written as in "0 1 2/0 2 3". */
static inline void
reads_bytes(const char *text, size_t length, int nv, const char *faces)
{
	char got[200] = "";
	size_t n = 0;
	int f, i;
	Soup s;

	if (parse(&s, text, length))
		fail_msg("'%s': %s", text, s.err);
	for (f = 0; f < s.nf; f++)
		for (i = s.first[f]; i < s.first[f+1]; i++)
			n += (size_t)snprintf(got + n, sizeof got - n, "%s%d",
			    i > s.first[f] ? " " : f ? "/" : "", s.idx[i]);
	if (s.nv != nv || strcmp(got, faces) != 0)
		fail_msg("'%s': %d vertices, faces %s", text, s.nv, got);
	soup_free(&s);
}

static inline void
reads(const char *text, int nv, const char *faces)
{
	reads_bytes(text, strlen(text), nv, faces);
}

static inline void
refuses_bytes(const char *text, size_t length, int code, const char *why)
{
	Soup s;
	int e = parse(&s, text, length);

	if (!e)
		soup_free(&s);
	if (e != code || !strstr(s.err, why))
		fail_msg("'%.60s': code %d, '%s', not %d, '%s'", text, e, e ? s.err : "", code, why);
}

static inline void
refuses(const char *text, int code, const char *why)
{
	refuses_bytes(text, strlen(text), code, why);
}

#endif
