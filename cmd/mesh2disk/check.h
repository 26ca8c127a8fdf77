/* check.h - the report of mesh2disk --check. */
#ifndef CMD_CHECK_H
#define CMD_CHECK_H

#include <stdio.h>

#include "../../lib/mend/mend.h"

/* Reports what mend found in s, and its result: out, or the reason why it refuses s. */
void check_text(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r,
	const char *refusal);
void check_json(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r,
	const char *refusal);

#endif
