/* descriptor.c - stdio streams over descriptors that retry EINTR, EAGAIN and short transfers. */
#define _GNU_SOURCE             /* fopencookie */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <stdint.h>
#include <unistd.h>

#include "private.h"

/* Whether to repeat a call that moved no byte.  If another process made the descriptor
 * non-blocking, waits until it is ready. */
static int
again(int fd, short what)
{
	struct pollfd p = { .fd = fd, .events = what };

	if (errno == EAGAIN || errno == EWOULDBLOCK)
		return poll(&p, 1, -1) >= 0 || errno == EINTR;
	return errno == EINTR;
}

static ssize_t
read_some(void *cookie, char *bytes, size_t n)
{
	int fd = (int)(intptr_t)cookie;
	ssize_t got;

	while ((got = read(fd, bytes, n)) < 0 && again(fd, POLLIN))
		;
	return got;
}

/* Writes until all n bytes are written, because stdio treats a count below n as an error. */
static ssize_t
write_all(void *cookie, const char *bytes, size_t n)
{
	int fd = (int)(intptr_t)cookie;
	size_t gone = 0;
	ssize_t k;

	while (gone < n)
		if ((k = write(fd, bytes + gone, n - gone)) > 0)
			gone += (size_t)k;
		else if (k == 0 || !again(fd, POLLOUT))
			break;
	return (ssize_t)gone;
}

static int
close_descriptor(void *cookie)
{
	return close((int)(intptr_t)cookie);
}

FILE *
descriptor_stream(int fd, const char *mode)
{
	return fopencookie((void *)(intptr_t)fd, mode, (cookie_io_functions_t){ read_some, write_all, NULL,
		close_descriptor });
}

/* Without this a file opened later would get one of these numbers, and results or messages would
 * go into it. */
int
descriptor_fill(void)
{
	static const int mode[3] = { O_WRONLY, O_RDONLY, O_RDWR };      /* 0, 1: opened so that use fails */
	int fd;

	for (fd = 0; fd < 3; fd++)
		if (fcntl(fd, F_GETFD) < 0 && open("/dev/null", mode[fd]) != fd)
			return -1;
	return 0;
}
