/* samefile.h - two names of one file. */
#ifndef CMD_SAMEFILE_H
#define CMD_SAMEFILE_H

/* Would a and b be written to the same place?  Symbolic links, dangling ones too, "." and ".." are followed; the files
 * need not be there.  Two hard links are two places, since an output replaces the name, not the file. */
int same_file(const char *a, const char *b);

/* Is path the regular file that descriptor fd, stdin or stdout, is open on? */
int same_as_stream(const char *path, int fd);

#endif
