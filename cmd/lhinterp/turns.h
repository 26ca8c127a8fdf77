/* turns.h - which of the four ways to lay a chart onto itself fits one surface best onto another. */
#ifndef CMD_TURNS_H
#define CMD_TURNS_H

enum { TURNS = 4 };

/* rms[k] is the distance between A and B, turned in the way k, after the best rigid motion of B, a root mean square
 * in units of their size; angle[k] that of the rotation, 0 .. pi.  Returns the way that fits clearly better than way 0,
 * or 0 if there is none.  aligned: B will be moved for the morph, too; otherwise ways that need a large rotation are
 * excluded. */
int turns_better(const double rms[TURNS], const double angle[TURNS], int aligned);

#endif
