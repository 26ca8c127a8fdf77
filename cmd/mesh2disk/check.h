/* check.h - the report of mesh2disk --check. */
#ifndef CMD_CHECK_H
#define CMD_CHECK_H

#include <stdio.h>

#include "../../lib/mend/mend.h"

/* What mend found in s and what it made of it: out, or nothing if it refuses with that reason. */
void check_text(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r,
	const char *refusal);
void check_json(FILE *f, const char *name, const Soup *s, const Soup *out, const MendReport *r,
	const char *refusal);

#endif
