/* pages.c - large arrays in pages of 2 MiB, where the system gives them on request.  With small
 * pages mesh2rect spends a third of its time in page faults and address look-ups.
 *
 * glibc takes arrays up to MAPPED from its heap.  The commands are linked with --wrap for the
 * functions below: they mark larger arrays, and what the heap has grown by, for large pages.
 * Only calls of our own objects pass here.  With another C library nothing is marked.
 */
#define _DEFAULT_SOURCE         /* madvise, sbrk */
#include <malloc.h>
#include <stdint.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

void *__real_malloc(size_t n);
void *__real_calloc(size_t n, size_t size);
void *__real_realloc(void *p, size_t n);
void *__real_aligned_alloc(size_t alignment, size_t n);
void *__wrap_malloc(size_t n);
void *__wrap_calloc(size_t n, size_t size);
void *__wrap_realloc(void *p, size_t n);
void *__wrap_aligned_alloc(size_t alignment, size_t n);

#if defined __GLIBC__ && defined MADV_HUGEPAGE

enum { LARGE = 1 << 21, GROWTH = LARGE, MAPPED = 8 << 20, KEPT = 1 << 30 };

static uintptr_t marked;                /* the end of the heap when it was last marked */

__attribute__((constructor)) static void
set_growth(void)
{
	mallopt(M_MMAP_THRESHOLD, MAPPED);
	mallopt(M_TRIM_THRESHOLD, KEPT);
	mallopt(M_TOP_PAD, GROWTH);
	marked = (uintptr_t)sbrk(0);
}

/* Marks the array p if glibc has mapped it outside of the heap; otherwise marks what the heap has
 * grown by.  If the system refuses, only time is lost.  Two threads may mark the same part, which
 * does no harm. */
static void *
mark(void *p, size_t n)
{
	uintptr_t end = (uintptr_t)sbrk(0), from = __atomic_load_n(&marked, __ATOMIC_RELAXED);

	if (p && n > MAPPED)
		(void)madvise((void *)((uintptr_t)p & ~(uintptr_t)4095), n, MADV_HUGEPAGE);
	else if (end > from) {
		from &= ~(uintptr_t)(LARGE - 1);        /* the page that the heap has grown into */
		(void)madvise((void *)from, end - from, MADV_HUGEPAGE);
		__atomic_store_n(&marked, end, __ATOMIC_RELAXED);
	}
	return p;
}

#else

static void *
mark(void *p, size_t n)
{
	(void)n;
	return p;
}

#endif

void *
__wrap_malloc(size_t n)
{
	return mark(__real_malloc(n), n);
}

/* If calloc returned an array, n*size did not overflow. */
void *
__wrap_calloc(size_t n, size_t size)
{
	return mark(__real_calloc(n, size), n*size);
}

void *
__wrap_realloc(void *p, size_t n)
{
	return mark(__real_realloc(p, n), n);
}

void *
__wrap_aligned_alloc(size_t alignment, size_t n)
{
	return mark(__real_aligned_alloc(alignment, n), n);
}
