/* describe.c - describes a grid as text or JSON. */
#include <stdio.h>
#include <string.h>

#include "describe.h"
#include "spread.h"
#include "../shared/json.h"
#include "../shared/warped.h"

static const char *const support[] = { "grid", "border", "lattice" };

typedef struct Range {
	double min, max, mean;
} Range;

/* The mean is updated with each sample, since a sum could overflow. */
static Range
range(const LhgChannel *c)
{
	Range r = { c->f[0], c->f[0], c->f[0] };
	size_t i;

	for (i = 1; i < c->n; i++) {
		r.min = c->f[i] < r.min ? c->f[i] : r.min;
		r.max = c->f[i] > r.max ? c->f[i] : r.max;
		r.mean += c->f[i]/(double)(i+1) - r.mean/(double)(i+1);
	}
	return r;
}

/* Writes the lines of s, which may be NULL, as JSON strings.  With pairs, splits each line at its
 * first space and writes "key": "value". */
static void
json_lines(FILE *f, const char *s, int pairs)
{
	char line[LHG_MAXHEAD], *rest;
	const char *end, *sep = "";

	for (; s && (end = strchr(s, '\n')); s = end + 1, sep = ", ") {
		snprintf(line, sizeof line, "%.*s", (int)(end - s), s);
		fputs(sep, f);
		rest = pairs ? strchr(line, ' ') : NULL;
		if (rest) {
			*rest++ = '\0';
			json_string(f, line);
			fputs(": ", f);
		}
		json_string(f, rest ? rest : line);
	}
}

void
describe_json(FILE *f, const char *name, const Lhg *g, int stats)
{
	const LhgChannel *c;
	Spread s;
	Range r;

	fputs("{ \"file\": ", f);
	json_string(f, name);
	fprintf(f, ", \"chart\": \"%s\", \"nu\": %d, \"nv\": %d, \"T\": %.17g, \"frame\": %d, \"frames\": %d, "
		"\"channels\": [", lhg_chartname(g->chart), g->nu, g->nv, g->T, g->frame, g->frames);
	for (c = g->chan; c < g->chan + g->nchan; c++) {
		r = range(c);
		fprintf(f, "%s{ \"name\": ", c == g->chan ? "" : ", ");
		json_string(f, c->name);
		fputs(", \"unit\": ", f);
		json_string(f, c->unit);
		fprintf(f, ", \"support\": \"%s\", \"step\": %d, \"samples\": %zu, \"min\": %.17g, "
			"\"max\": %.17g, \"mean\": %.17g", support[c->support], c->step, c->n, r.min, r.max, r.mean);
		if (stats) {
			s = spread_of(c);
			spread_json(f, &s);
		}
		fputs(" }", f);
	}
	fputs("], \"meta\": { ", f);
	json_lines(f, g->meta, 1);
	fputs(" }, \"history\": [", f);
	json_lines(f, g->hist, 0);
	fputs("] }\n", f);
}

static void
print_lines(FILE *f, const char *word, const char *s)
{
	const char *end;

	for (; s && (end = strchr(s, '\n')); s = end + 1)
		fprintf(f, "  %s %.*s\n", word, (int)(end - s), s);
}

void
describe_text(FILE *f, const char *name, const Lhg *g, int stats)
{
	const LhgChannel *c;
	char span[32];
	size_t len;
	Spread s;
	Range r;

	for (; *name; name += len ? len : 1)
		if ((len = lhg_utf8(name, strlen(name))))
			fprintf(f, "%.*s", (int)len, name);
		else
			putc('?', f);
	fprintf(f, ": %d x %d nodes%s%s, T %.9g, frame %d of %d\n", g->nu, g->nv, g->chart ? " of a " : "",
		g->chart ? lhg_chartname(g->chart) : "", g->T, g->frame, g->frames);
	for (c = g->chan; c < g->chan + g->nchan; c++) {
		r = range(c);
		snprintf(span, sizeof span, c->step ? "%s %d" : "%s", support[c->support], c->step);
		fprintf(f, "  channel %-8s %-9s %-11s %8zu samples  min %-12.6g max %-12.6g mean %.6g\n",
			c->name, c->unit, span, c->n, r.min, r.max, r.mean);
		if (stats) {
			s = spread_of(c);
			spread_text(f, &s);
		}
	}
	print_lines(f, "meta", g->meta);
	if (warped_H(g) && lhg_find(g, "H"))
		fprintf(f, "  note %s\n", warped_H(g));
	print_lines(f, "history", g->hist);
}
