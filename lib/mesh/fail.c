/* fail.c - error messages and memory for reading, checking and repairing meshes. */
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

#include "fail.h"

int
mesh_fail(char err[MESH_ERRLEN], int code, const char *fmt, ...)
{
	va_list ap;

	va_start(ap, fmt);
	vsnprintf(err, MESH_ERRLEN, fmt, ap);
	va_end(ap);
	return code;
}

void *
mesh_alloc(char err[MESH_ERRLEN], size_t n, size_t size)
{
	void *p = NULL;

	if (n <= SIZE_MAX / 2 / size)
		p = malloc(n ? n * size : 1);
	if (!p)
		mesh_fail(err, MESH_ENOMEM, "no memory for %zu x %zu bytes", n, size);
	return p;
}
