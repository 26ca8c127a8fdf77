/* report.h - the values of lhdiff as text. */
#ifndef CMD_REPORT_H
#define CMD_REPORT_H

#include "../shared/cmd.h"
#include "compare.h"

/* For one pair of surfaces: lines "name value", or one JSON object.  For many pairs: a table, or
 * one JSON object on each line; each row or object begins with the number of the pair. */
typedef struct Report {
	int     json, many;
	long    count;          /* pairs added */
	CmdText text;
} Report;

void report_begin(Report *r, int json, int many);

/* Add one pair.  The value -1 means not defined: it is left out, or "-" in a table.  A
 * table has no columns for values that c does not request. */
void report_add(Report *r, const Compare *c, const double value[COMPARE_N]);

/* Write all pairs to -o or stdout. */
void report_write(Report *r);

#endif
