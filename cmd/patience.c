/* patience.c - threads that wait soon give the processor away.
 *
 * At the end of every loop libgomp's spin for milliseconds, which on a busy machine (make
 * -j, a batch over a folder) takes five to ten times as long as the work.  A hundredth of
 * that costs an idle machine nothing.  How long is in the environment when a process
 * begins, and nowhere else.
 */
#define _DEFAULT_SOURCE         /* readlink */
#include <stdlib.h>
#include <unistd.h>

/* Begins again with it set; where that cannot be, things go on as they are. */
__attribute__((constructor)) static void
wait_briefly(int argc, char *argv[])
{
	char program[4096];
	ssize_t n;

	(void)argc;
	if (getenv("GOMP_SPINCOUNT") || getenv("OMP_WAIT_POLICY"))
		return;
	n = readlink("/proc/self/exe", program, sizeof program - 1);
	if (n <= 0 || setenv("GOMP_SPINCOUNT", "3000", 1))
		return;
	program[n] = '\0';
	execv(program, argv);
}
