/* beside.c - files beside a mesh file that hold a part of it. */
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "beside.h"
#include "cmd.h"
#include "private.h"

static int
fail(int fd, const char *why, char err[MESH_ERRLEN])
{
	snprintf(err, MESH_ERRLEN, "%s", why);
	if (fd >= 0)
		close(fd);
	return MESH_EFORMAT;
}

/* Opens the file; a pipe is not waited for. */
static int
open_beside(const char *path, const char *name)
{
	const char *slash = strrchr(path, '/');
	const size_t folder = slash ? (size_t)(slash - path) + 1 : 0;
	char *to = cmd_alloc(folder + strlen(name) + 1, 1);
	int fd;

	memcpy(to, path, folder);
	strcpy(to + folder, name);
	fd = open(to, O_RDONLY | O_NONBLOCK | O_CLOEXEC);
	free(to);
	return fd;
}

/* The read of a MeshBeside; path is the name of the mesh file. */
static int
read_beside(const void *path, const char *name, unsigned long long from, size_t want, char **bytes, size_t *n,
	char err[MESH_ERRLEN])
{
	const int fd = open_beside(path, name);
	unsigned long long left;
	struct stat st;
	FILE *f;

	if (fd < 0 || fstat(fd, &st) || (S_ISREG(st.st_mode) && lseek(fd, (off_t)from, SEEK_SET) < 0))
		return fail(fd, strerror(errno), err);
	if (!S_ISREG(st.st_mode))
		return fail(fd, "no regular file", err);
	if (!(f = descriptor_stream(fd, "rb")))
		return fail(fd, "no memory to read it", err);
	left = from < (unsigned long long)st.st_size ? (unsigned long long)st.st_size - from : 0;
	*bytes = cmd_alloc(want < left ? want : (size_t)left, 1);
	*n = fread(*bytes, 1, want < left ? want : (size_t)left, f);
	if (ferror(f)) {
		fail(-1, strerror(errno), err);
		free(*bytes);
		fclose(f);
		return MESH_EFORMAT;
	}
	fclose(f);
	return 0;
}

const MeshBeside *
beside_of(const char *path, MeshBeside *b)
{
	if (cmd_name_of(path) != path)
		return NULL;
	*b = (MeshBeside){ read_beside, path };
	return b;
}
