/* fault.c - fault injection, linked into commands and tests with --wrap: the environment
 * variable FAULT selects which calls fail.
 *
 *   FAULT="CALL N ERROR"       the N-th call of CALL fails with errno ERROR, a number
 *   FAULT="CALL N+ ERROR"      the N-th and all later calls fail
 *   FAULT="CALL N+ short"      the N-th and all later calls transfer one byte; CALL is read or write
 *   FAULT="CALL N kill"        the process is killed at the N-th call
 *   FAULT="CALL odd ERROR"     the first, the third, the fifth .. call fails
 *   FAULT_COUNT=FILE           at exit, the number of calls of CALL is written to FILE
 *
 * CALL is `memory`, for all allocations, or one of read, write, close, fsync, rename, mkstemp and
 * fchmod.  Allocations inside FFTW, OpenBLAS and libgomp are not included: these libraries end the
 * process if they get no memory.  Those of CHOLMOD are included: it is given the wrapped functions.
 */
#define _GNU_SOURCE
#include <errno.h>
#include <limits.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <suitesparse/SuiteSparse_config.h>
#include <sys/types.h>

#include "fault.h"

enum { SHORT = -1, KILL = -2 };

static struct {
	char call[16];
	long from, to, stride, seen;    /* calls from, from + stride, .., to fail */
	int  error;                     /* their errno, or SHORT or KILL */
	long live;
} fault;

/* Counts this call.  Returns 0, or the error with which it must fail. */
static int
fails(const char *call)
{
	long n;

	if (strcmp(call, fault.call) != 0)
		return 0;
	n = __atomic_add_fetch(&fault.seen, 1, __ATOMIC_SEQ_CST);
	if (n < fault.from || n > fault.to || (n - fault.from)%fault.stride != 0)
		return 0;
	if (fault.error == KILL)
		raise(SIGKILL);
	return fault.error;
}

void
fault_set(const char *call, long from, long to, int error)
{
	snprintf(fault.call, sizeof fault.call, "%s", call);
	fault.from = from;
	fault.to = to;
	fault.stride = 1;
	fault.error = error;
	fault.seen = 0;
}

long
fault_seen(void)
{
	return fault.seen;
}

long
fault_live(void)
{
	return fault.live;
}

/* ---- memory ---- */

static void *
counted(void *p)
{
	if (p)
		__atomic_add_fetch(&fault.live, 1, __ATOMIC_SEQ_CST);
	return p;
}

static int
no_memory(void)
{
	int e = fails("memory");

	if (e)
		errno = ENOMEM;
	return e;
}

#define MEMORY(type, name, parameters, arguments) \
type __real_##name parameters; \
type __wrap_##name parameters; \
type __wrap_##name parameters { return no_memory() ? NULL : counted(__real_##name arguments); }

MEMORY(void *, malloc, (size_t n), (n))
MEMORY(void *, calloc, (size_t n, size_t size), (n, size))
MEMORY(void *, aligned_alloc, (size_t at, size_t n), (at, n))
MEMORY(char *, strdup, (const char *s), (s))
MEMORY(double *, fftw_alloc_real, (size_t n), (n))

void *__real_realloc(void *p, size_t n);
void *__wrap_realloc(void *p, size_t n);
void *
__wrap_realloc(void *p, size_t n)
{
	void *q = no_memory() ? NULL : __real_realloc(p, n);

	return p ? q : counted(q);
}

void __real_free(void *p);
void __wrap_free(void *p);
void
__wrap_free(void *p)
{
	if (p)
		__atomic_sub_fetch(&fault.live, 1, __ATOMIC_SEQ_CST);
	__real_free(p);
}

void __real_fftw_free(void *p);
void __wrap_fftw_free(void *p);
void
__wrap_fftw_free(void *p)
{
	if (p)
		__atomic_sub_fetch(&fault.live, 1, __ATOMIC_SEQ_CST);
	__real_fftw_free(p);
}

/* The two forms of C++ operator new, which throw an exception if there is no memory. */
void *__wrap__Znwm(size_t n);
void *__real__Znwm(size_t n);
void *__wrap__Znam(size_t n);
void *__real__Znam(size_t n);
void _ZSt17__throw_bad_allocv(void);
void *
__wrap__Znwm(size_t n)
{
	if (no_memory())
		_ZSt17__throw_bad_allocv();
	return __real__Znwm(n);
}

void *
__wrap__Znam(size_t n)
{
	if (no_memory())
		_ZSt17__throw_bad_allocv();
	return __real__Znam(n);
}

/* ---- stdio streams: libc allocates their memory itself, so opening them is made to fail ---- */

FILE *__real_fopencookie(void *cookie, const char *mode, cookie_io_functions_t io);
FILE *__wrap_fopencookie(void *cookie, const char *mode, cookie_io_functions_t io);
FILE *
__wrap_fopencookie(void *cookie, const char *mode, cookie_io_functions_t io)
{
	return no_memory() ? NULL : __real_fopencookie(cookie, mode, io);
}

FILE *__real_fmemopen(void *p, size_t n, const char *mode);
FILE *__wrap_fmemopen(void *p, size_t n, const char *mode);
FILE *
__wrap_fmemopen(void *p, size_t n, const char *mode)
{
	return no_memory() ? NULL : __real_fmemopen(p, n, mode);
}

/* ---- system calls ---- */

/* Returns 0, or sets errno to the error with which this call must fail and returns the error. */
static int
no_call(const char *call)
{
	int e = fails(call);

	if (e)
		errno = e;
	return e;
}

#define CALL(type, name, parameters, arguments) \
type __real_##name parameters; \
type __wrap_##name parameters; \
type __wrap_##name parameters { return no_call(#name) ? -1 : __real_##name arguments; }

CALL(int, fsync, (int fd), (fd))
CALL(int, rename, (const char *from, const char *to), (from, to))
CALL(int, mkstemp, (char *name), (name))
CALL(int, fchmod, (int fd, mode_t mode), (fd, mode))

/* A close that fails closes the descriptor all the same, as Linux does. */
int __real_close(int fd);
int __wrap_close(int fd);
int
__wrap_close(int fd)
{
	int e = fails("close"), r = __real_close(fd);

	if (e)
		errno = e;
	return e ? -1 : r;
}

ssize_t __real_read(int fd, void *bytes, size_t n);
ssize_t __wrap_read(int fd, void *bytes, size_t n);
ssize_t
__wrap_read(int fd, void *bytes, size_t n)
{
	int e = no_call("read");

	return e > 0 ? -1 : __real_read(fd, bytes, e == SHORT && n > 1 ? 1 : n);
}

ssize_t __real_write(int fd, const void *bytes, size_t n);
ssize_t __wrap_write(int fd, const void *bytes, size_t n);
ssize_t
__wrap_write(int fd, const void *bytes, size_t n)
{
	int e = no_call("write");

	return e > 0 ? -1 : __real_write(fd, bytes, e == SHORT && n > 1 ? 1 : n);
}

/* Makes CHOLMOD allocate through the wrapped functions.  Up to SuiteSparse 6 they are members of a
 * struct; from version 7 on they are set by functions. */
static void
replace_suitesparse(void)
{
#if SUITESPARSE_VERSION >= SUITESPARSE_VER_CODE(7, 0)
	SuiteSparse_config_malloc_func_set(__wrap_malloc);
	SuiteSparse_config_calloc_func_set(__wrap_calloc);
	SuiteSparse_config_realloc_func_set(__wrap_realloc);
	SuiteSparse_config_free_func_set(__wrap_free);
#else
	SuiteSparse_config.malloc_func = __wrap_malloc;
	SuiteSparse_config.calloc_func = __wrap_calloc;
	SuiteSparse_config.realloc_func = __wrap_realloc;
	SuiteSparse_config.free_func = __wrap_free;
#endif
}

/* ---- the variables FAULT and FAULT_COUNT ---- */

static void __attribute__((constructor))
begin(void)
{
	const char *s = getenv("FAULT");
	char call[16], which[16], error[16];
	long n;

	replace_suitesparse();
	if (!s || sscanf(s, "%15s %15s %15s", call, which, error) != 3)
		return;
	n = strtol(which, NULL, 10);
	fault_set(call, n, strchr(which, '+') ? LONG_MAX : n, strcmp(error, "short") == 0 ? SHORT :
	    strcmp(error, "kill") == 0 ? KILL : atoi(error));
	if (strcmp(which, "odd") == 0) {
		fault.from = 1;
		fault.to = LONG_MAX;
		fault.stride = 2;
	}
}

static void __attribute__((destructor))
end(void)
{
	const char *name = getenv("FAULT_COUNT");
	FILE *f = name ? fopen(name, "w") : NULL;

	if (f) {
		fprintf(f, "%ld\n", fault.seen);
		fclose(f);
	}
}
