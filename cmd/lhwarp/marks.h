/* marks.h - the file of lhwarp --landmarks. */
#ifndef CMD_MARKS_H
#define CMD_MARKS_H

#include "pair.h"

typedef struct Marks {
	int     n;
	double (*at[2])[2];     /* (u,v) on the charts of A and of B */
} Marks;

/* Reads landmarks: on each line two vertex numbers, two pairs u v, or two points x y z; or dies.  To be
 * called before side_match. */
void marks_read(const char *path, const Side *a, const Side *b, Marks *m);
void marks_free(Marks *m);

#endif
