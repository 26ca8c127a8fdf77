/* threads.c - how many threads a command has, and how they wait.
 *
 * Two settings are read by libraries before main begins, from the environment alone:
 *
 * GOMP_SPINCOUNT        After every loop libgomp's threads spin for milliseconds.  On a busy
 *                       machine (make -j, a batch over a folder) this costs several times
 *                       as much as the work.  With a hundredth of the spinning, an idle
 *                       machine loses nothing.
 * OPENBLAS_NUM_THREADS  Our calls of BLAS use one thread.  OpenBLAS starts the others
 *                       anyway, and hangs if they get no memory.
 *
 * The loader calls .preinit_array before the constructors of libraries, but an environment
 * made there by setenv is replaced by the C library's.  So each setting replaces a variable
 * that no library reads at its start, and that variable is put back before main.  If the
 * environment has no such variable (env -i), or the loader knows no .preinit_array (musl),
 * the libraries keep their defaults.
 */
#include <stddef.h>
#include <string.h>

#include <omp.h>

#include "private.h"

#define BEFORE_MAIN __attribute__((no_sanitize("address", "undefined")))

static const char *const SPARE[] = {
	"_", "OLDPWD", "SHLVL", "PWD", "LOGNAME", "USER", "SHELL", "TERM", "HOME", "PATH"
};
enum { NSPARE = sizeof SPARE/sizeof *SPARE };

static struct {
	char **at, *value;
} replaced[2];
static int nreplaced;

/* The entry of variable name in env, or NULL. */
BEFORE_MAIN static char **
find(char **env, const char *name)
{
	size_t n = strlen(name);

	for (; *env; env++)
		if (strncmp(*env, name, n) == 0 && (*env)[n] == '=')
			return env;
	return NULL;
}

BEFORE_MAIN static void
replace_spare(char **env, char *setting)
{
	char **at = NULL;
	int i;

	for (i = 0; i < NSPARE && !at; i++)
		at = find(env, SPARE[i]);
	if (!at)
		return;
	replaced[nreplaced].at = at;
	replaced[nreplaced++].value = *at;
	*at = setting;
}

/* Makes both settings, unless the user has made them. */
BEFORE_MAIN static void
before_libraries(int argc, char *argv[], char *env[])
{
	static char spin[] = "GOMP_SPINCOUNT=3000", blas[] = "OPENBLAS_NUM_THREADS=1";

	(void)argc;
	(void)argv;
	if (!find(env, "GOMP_SPINCOUNT") && !find(env, "OMP_WAIT_POLICY"))
		replace_spare(env, spin);
	if (!find(env, "OPENBLAS_NUM_THREADS"))
		replace_spare(env, blas);
}

__attribute__((section(".preinit_array"), used))
static void (*const first)(int, char *[], char *[]) = before_libraries;

__attribute__((constructor)) static void
after_libraries(void)
{
	while (nreplaced > 0) {
		nreplaced--;
		*replaced[nreplaced].at = replaced[nreplaced].value;
	}
}

void
threads_limit(void)
{
	int most = 4*omp_get_num_procs();

	if (omp_get_max_threads() > most)
		omp_set_num_threads(most);
}

void
threads_set(long n)
{
	omp_set_num_threads((int)n);
	threads_limit();
}
