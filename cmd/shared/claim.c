/* claim.c - reports too little memory before the work begins. */
#include <sys/resource.h>
#include <unistd.h>

#include "claim.h"
#include "cmd.h"

/* Bytes of memory: the machine's, or the limit of the process if that is less. */
static double
memory_bytes(void)
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
	if (n*bytes > memory_bytes())
		die("%s: no memory: %s needs about %.0f bytes, there are %.0f", where, what, n*bytes, memory_bytes());
}

void
claim_possible(const char *where, const char *what, double n, double bytes)
{
	if (n*bytes > memory_bytes())
		note("%s: %s may need up to %.0f bytes, there are %.0f", where, what, n*bytes, memory_bytes());
}

size_t
claim_input(void)
{
	double half = memory_bytes()/2, most = 4.*1024*1024*1024;

	return half < most ? (size_t)half : (size_t)most;
}
