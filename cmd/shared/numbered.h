/* numbered.h - names of output files with a number in them, as in frame-%03d.off. */
#ifndef CMD_NUMBERED_H
#define CMD_NUMBERED_H

#include <stddef.h>

/* Returns 1 if name has a number, "%d" or "%03d"; 0 if it has no "%" or is NULL.  Exit 2 if it has
 * another "%" or more than one. */
int numbered(const char *name);

/* The name of file number i: name with i in place of its number, written to out[n]; name itself if it
 * has none. */
const char *numbered_name(const char *name, int i, char *out, size_t n);

#endif
