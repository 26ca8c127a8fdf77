/* kinds.c - the kinds of synthetic surfaces in usage text and operands. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "../shared/cmd.h"
#include "kinds.h"

char *
kinds_manual(const char *head)
{
	const SynthKind *k;
	const SynthPar *q;
	const char *line, *end;
	CmdText t;
	FILE *f;
	int i;

	cmd_text_open(&t);
	fputs(head, f = t.f);
	for (i = 0; (k = synth_kind(i)); i++) {
		fprintf(f, "  %s", k->name);
		for (q = k->par; q->name; q++)
			fprintf(f, "  %s=%g, %g..%g", q->name, q->value, q->lo, q->hi);
		for (line = k->text; (end = strchr(line, '\n')); line = end + 1)
			fprintf(f, "\n      %.*s", (int)(end - line), line);
		fputc('\n', f);
	}
	putc('\0', f);
	cmd_text_close(&t);
	return t.bytes;
}

void
kinds_list(void)
{
	char names[1024] = "";
	int i;

	for (i = 0; synth_kind(i); i++)
		snprintf(names + strlen(names), sizeof names - strlen(names), "%s\n", synth_kind(i)->name);
	cmd_write_bytes(NULL, names, strlen(names));
}

void
kinds_set(Synth *s, char *arg)
{
	char *equals = strchr(arg, '='), *end;
	const SynthPar *q;
	double value;

	if (!equals)
		misuse("%s: need NAME=VALUE", arg);
	*equals = '\0';
	for (q = s->kind->par; q->name && strcmp(q->name, arg); q++)
		;
	if (!q->name)
		misuse("%s: no parameter of the kind %s", arg, s->kind->name);
	value = strtod(equals + 1, &end);
	if (end == equals + 1 || *end || synth_set(s, arg, value))
		misuse("%s=%s: need a number in [%g,%g]", arg, equals + 1, q->lo, q->hi);
}
