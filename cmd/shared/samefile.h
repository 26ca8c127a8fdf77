/* samefile.h - two names of one file. */
#ifndef CMD_SAMEFILE_H
#define CMD_SAMEFILE_H

/* Would a and b be written to the same place?  Symbolic links, "." and ".." are followed; the files
 * need not be there.  Hard links are two places: an output is renamed to its name. */
int same_file(const char *a, const char *b);

#endif
