/* report.c - the values of lhdiff as text. */
#include <float.h>
#include <stdlib.h>

#include "cmd.h"
#include "report.h"

static const char *const name[] = { "area_a", "area_b", "max", "mean", "max_rel", "mean_rel",
	"hausdorff", "hausdorff_error", "hausdorff_rel", "self_intersections_a",
	"self_intersections_b" };

void
report_begin(Report *r, int json, int many)
{
	*r = (Report){ .json = json, .many = many };
	if (!(r->f = open_memstream(&r->bytes, &r->n)))
		die("no memory");
}

static void
lines(FILE *f, const double value[COMPARE_N])
{
	int i;

	for (i = 0; i < COMPARE_N; i++)
		if (value[i] >= 0)
			fprintf(f, "%s %.9g\n", name[i], value[i]);
}

static void
object(const Report *r, const double value[COMPARE_N])
{
	const char *sep = "{ ";
	int i;

	if (r->many) {
		fprintf(r->f, "{ \"frame\": %ld", r->count);
		sep = ", ";
	}
	for (i = 0; i < COMPARE_N; i++)
		if (value[i] >= 0) {
			fprintf(r->f, "%s\"%s\": %.17g", sep, name[i], value[i]);
			sep = ", ";
		}
	fputs(" }\n", r->f);
}

static int
asked(const Compare *c, int i)
{
	if (i == COMPARE_CROSS_A || i == COMPARE_CROSS_B)
		return c->cross;
	return c->far || i < COMPARE_HAUSDORFF;
}

static void
row(const Report *r, const Compare *c, const double value[COMPARE_N])
{
	int i;

	if (r->count == 1) {
		fputs("frame", r->f);
		for (i = 0; i < COMPARE_N; i++)
			if (asked(c, i))
				fprintf(r->f, "\t%s", name[i]);
		fputc('\n', r->f);
	}
	fprintf(r->f, "%ld", r->count);
	for (i = 0; i < COMPARE_N; i++)
		if (asked(c, i) && value[i] >= 0)
			fprintf(r->f, "\t%.9g", value[i]);
		else if (asked(c, i))
			fputs("\t-", r->f);
	fputc('\n', r->f);
}

void
report_add(Report *r, const Compare *c, const double value[COMPARE_N])
{
	int i;

	for (i = 0; i < COMPARE_N; i++)
		if (!(value[i] <= DBL_MAX))
			die("%s is not finite", name[i]);
	r->count++;
	if (r->json)
		object(r, value);
	else if (r->many)
		row(r, c, value);
	else
		lines(r->f, value);
}

void
report_write(Report *r)
{
	if (fclose(r->f))
		die("no memory");
	cmd_emit(NULL, r->bytes, r->n);
	free(r->bytes);
}
