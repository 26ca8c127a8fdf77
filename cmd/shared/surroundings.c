/* surroundings.c - what has to be in the environment when a process begins, and can be said
 * nowhere else.
 *
 * GOMP_SPINCOUNT: at the end of every loop libgomp's threads spin for milliseconds, which on
 * a busy machine (make -j, a batch over a folder) takes five to ten times as long as the
 * work.  A hundredth of that costs an idle machine nothing.
 *
 * GLIBC_TUNABLES: large arrays in pages of 2 MiB where the system gives them on demand; a
 * tenth of the time of mesh2rect goes into smaller ones.
 */
#define _DEFAULT_SOURCE         /* readlink */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char PAGES[] = "glibc.malloc.hugetlb";

/* Leaves alone what somebody has said of it, and adds to what was said of others. */
static int
ask_for_pages(void)
{
	const char *said = getenv("GLIBC_TUNABLES");
	char all[1000];

	if (said && strstr(said, PAGES))
		return 0;
	if (snprintf(all, sizeof all, "%s%s%s=1", said ? said : "", said && *said ? ":" : "", PAGES) >= (int)sizeof all)
		return 0;
	return setenv("GLIBC_TUNABLES", all, 1);
}

/* Begins again with it set; where that cannot be, things go on as they are. */
__attribute__((constructor)) static void
begin_again(int argc, char *argv[])
{
	char program[4096];
	ssize_t n;

	(void)argc;
	if (getenv("GOMP_SPINCOUNT") || getenv("OMP_WAIT_POLICY"))
		return;
	n = readlink("/proc/self/exe", program, sizeof program - 1);
	if (n <= 0 || ask_for_pages() || setenv("GOMP_SPINCOUNT", "3000", 1))
		return;
	program[n] = '\0';
	execv(program, argv);
}
