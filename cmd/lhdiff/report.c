/* report.c - the values of lhdiff as text. */
#include <float.h>
#include <stdlib.h>

#include "report.h"

static const char *const name[] = { "area_a", "area_b", "max", "mean", "max_rel", "mean_rel",
	"hausdorff", "hausdorff_error", "hausdorff_rel", "self_intersections_a",
	"self_intersections_b" };

void
report_begin(Report *r, int json, int many)
{
	*r = (Report){ .json = json, .many = many };
	cmd_text_open(&r->text);
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
		fprintf(r->text.f, "{ \"frame\": %ld", r->count);
		sep = ", ";
	}
	for (i = 0; i < COMPARE_N; i++)
		if (value[i] >= 0) {
			fprintf(r->text.f, "%s\"%s\": %.17g", sep, name[i], value[i]);
			sep = ", ";
		}
	fputs(" }\n", r->text.f);
}

static int
requested(const Compare *c, int i)
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
		fputs("frame", r->text.f);
		for (i = 0; i < COMPARE_N; i++)
			if (requested(c, i))
				fprintf(r->text.f, "\t%s", name[i]);
		fputc('\n', r->text.f);
	}
	fprintf(r->text.f, "%ld", r->count);
	for (i = 0; i < COMPARE_N; i++)
		if (requested(c, i) && value[i] >= 0)
			fprintf(r->text.f, "\t%.9g", value[i]);
		else if (requested(c, i))
			fputs("\t-", r->text.f);
	fputc('\n', r->text.f);
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
		lines(r->text.f, value);
}

void
report_write(Report *r)
{
	cmd_text_close(&r->text);
	cmd_write_bytes(NULL, r->text.bytes, r->text.n);
	free(r->text.bytes);
}
