/* memory.c - counts the memory that the code under test has allocated (link with --wrap). */
#include <malloc.h>
#include <stdio.h>
#include <stdlib.h>

#include "fuzz.h"

static size_t live, peak;

void *__real_malloc(size_t n);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t n);
void __real_free(void *p);

void *__wrap_malloc(size_t n);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t n);
void __wrap_free(void *p);

static void *
took(void *p)
{
	live += malloc_usable_size(p);
	if (live > peak)
		peak = live;
	return p;
}

void *
__wrap_malloc(size_t n)
{
	return took(__real_malloc(n));
}

void *
__wrap_calloc(size_t n, size_t size)
{
	return took(__real_calloc(n, size));
}

void *
__wrap_realloc(void *p, size_t n)
{
	size_t old = malloc_usable_size(p);
	void *q = __real_realloc(p, n);

	if (!q)
		return NULL;
	if (n <= old)
		live -= old;            /* a block that shrinks stays in place */
	took(q);
	if (n > old)
		live -= old;
	return q;
}

void
__wrap_free(void *p)
{
	live -= malloc_usable_size(p);
	__real_free(p);
}

size_t
fuzz_live(void)
{
	return live;
}

size_t
fuzz_peak(void)
{
	return peak;
}

void
fuzz_mark(void)
{
	peak = live;
}

void
fuzz_need(int ok, const char *what)
{
	if (ok)
		return;
	fprintf(stderr, "fuzz: %s\n", what);
	abort();
}
