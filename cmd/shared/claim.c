/* claim.c - memory that is not there is said so before the work begins. */
#include <sys/resource.h>
#include <unistd.h>

#include "claim.h"
#include "cmd.h"

/* What there is: all of the machine's, or the process's share. */
static double
there_is(void)
{
	double all = (double)sysconf(_SC_PHYS_PAGES)*(double)sysconf(_SC_PAGESIZE);
	struct rlimit r;

	if (getrlimit(RLIMIT_AS, &r) == 0 && r.rlim_cur != RLIM_INFINITY && (double)r.rlim_cur < all)
		return (double)r.rlim_cur;
	return all;
}

void
claim(const char *where, const char *what, double n, double bytes)
{
	if (n*bytes > there_is())
		die("%s: no memory: %s needs about %.0f bytes, there are %.0f", where, what, n*bytes, there_is());
}

size_t
claim_input(void)
{
	double half = there_is()/2, most = 4.*1024*1024*1024;

	return half < most ? (size_t)half : (size_t)most;
}
