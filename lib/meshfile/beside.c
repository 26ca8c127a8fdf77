/* beside.c - files beside a mesh file that hold a part of it. */
#include <stdlib.h>
#include <string.h>

#include "beside.h"
#include "meshfile.h"

enum { LONGEST = 1000, SHOW = 60 };

/* Whether a folder in the path is "..". */
static int
goes_up(const char *path)
{
	for (; *path; path += strcspn(path, "/"), path += *path == '/')
		if (strncmp(path, "..", 2) == 0 && (path[2] == '/' || path[2] == '\0'))
			return 1;
	return 0;
}

/* The name for a message: printable ASCII, shortened. */
static const char *
shown(Token name, char buf[SHOW])
{
	const size_t n = name.n < SHOW - 4 ? name.n : SHOW - 4;
	size_t i;

	for (i = 0; i < n; i++)
		buf[i] = name.s[i] >= ' ' && name.s[i] < 127 ? name.s[i] : '?';
	strcpy(buf + n, n < name.n ? "..." : "");
	return buf;
}

/* Copies the name to path, or says why it is none that is read. */
static int
check_name(Reader *r, const char *what, Token name, char path[LONGEST + 1])
{
	char show[SHOW];
	size_t i;

	if (name.n == 0 || name.n > LONGEST)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in another file, whose name has %zu bytes", what, name.n);
	for (i = 0; i < name.n; i++)
		if ((unsigned char)name.s[i] < ' ')
			return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in another file, whose name has the byte 0x%02x", what,
			    (unsigned char)name.s[i]);
	memcpy(path, name.s, name.n);
	path[name.n] = '\0';
	if (*path == '/' || goes_up(path))
		return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in '%s', which is read only from the folder of the mesh, by a "
		    "name without .. and without / at its start", what, shown(name, show));
	return 0;
}

int
beside_read(Reader *r, const char *what, Token name, long long from, size_t n, char **bytes)
{
	char path[LONGEST + 1], show[SHOW], why[MESH_ERRLEN];
	char *p;
	size_t got;
	int e = check_name(r, what, name, path);

	if (e)
		return e;
	shown(name, show);
	if (!r->beside)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in another file, '%s', which cannot be found from a pipe: give the "
		    "name of the mesh file", what, show);
	if (from < 0 || n > r->most_beside)
		return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in '%s', of which %zu bytes from %lld on are more than can be read",
		    what, show, n, from);
	if ((e = r->beside->read(r->beside->arg, path, (unsigned long long)from, n, &p, &got, why)) != 0)
		return mesh_fail(r->s->err, e, "%s is in '%s' beside the mesh: %.100s", what, show, why);
	if (got < n) {
		free(p);
		return mesh_fail(r->s->err, MESH_EFORMAT, "%s is in '%s' beside the mesh, which has %zu bytes from %lld on, need %zu",
		    what, show, got, from, n);
	}
	r->most_beside -= n;
	*bytes = p;
	return 0;
}
