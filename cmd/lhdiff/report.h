/* report.h - the values of lhdiff as text. */
#ifndef CMD_REPORT_H
#define CMD_REPORT_H

#include "../shared/cmd.h"
#include "compare.h"

/* For one pair of surfaces: lines "name value", or one JSON object.  For many: a table, or a JSON
 * object on each line, whose rows begin with the number of the pair. */
typedef struct Report {
	int     json, many;
	long    count;          /* pairs added */
	CmdText text;
} Report;

void report_begin(Report *r, int json, int many);

/* Add one pair.  A value of -1 is not defined: it is left out, and a table has "-" for it.  A
 * table has no columns for values that c does not request. */
void report_add(Report *r, const Compare *c, const double value[COMPARE_N]);

/* Write all pairs to -o or stdout. */
void report_write(Report *r);

#endif
