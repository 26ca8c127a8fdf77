/* samefile.h - whether two names refer to the same file. */
#ifndef CMD_SAMEFILE_H
#define CMD_SAMEFILE_H

/* Whether outputs to a and b would replace the same file, which need not exist.  Symbolic links,
 * dangling ones too, "." and ".." are followed.  Two hard links are different, since an output
 * replaces the name only. */
int same_file(const char *a, const char *b);

/* Whether path is the regular file behind fd, the descriptor of stdin or stdout. */
int same_as_stream(const char *path, int fd);

#endif
