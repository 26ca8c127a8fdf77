/* report.h - the values of lhdiff as text. */
#ifndef CMD_REPORT_H
#define CMD_REPORT_H

#include "../shared/cmd.h"
#include "compare.h"

/* Of one pair of surfaces: lines "name value", or one JSON object.  Of many: a table, or a
 * JSON object a line, that begin with the number of the pair. */
typedef struct Report {
	int     json, many;
	long    count;          /* pairs told */
	CmdText text;
} Report;

void report_begin(Report *r, int json, int many);

/* Tell of one pair.  What cannot be said, -1, is left out; in a table it is a column of
 * no value, -, or, when c did not ask for it, none. */
void report_add(Report *r, const Compare *c, const double value[COMPARE_N]);

/* All that was told to -o or stdout. */
void report_write(Report *r);

#endif
