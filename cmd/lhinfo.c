/* lhinfo - the contents of a stream of grids */
#include <stdlib.h>

#include "shared/cmd.h"
#include "lhinfo/describe.h"
#include "lhinfo/script.h"

static const char text[] =
"usage: lhinfo [--json] [--stats | --history] [FILE...]\n"
"Prints what streams of grids hold (- or no FILE: stdin).  For each grid: size, height T of the\n"
"chart, frame, channels (unit, support, number of samples, minimum, maximum, mean), metadata\n"
"and history.  Streams are read to their ends, and every byte is checked.\n"
"      --json         one JSON object for each grid, each on one line\n"
"      --stats        also the median of each channel, the values that 1 and 99 % of the samples are\n"
"                     below, and a histogram between these: minimum and maximum are often a few nodes\n"
"                     at a corner\n"
"      --history      only the history, as a script for sh that makes the streams again, on stdout,\n"
"                     from the mesh files that it names\n"
CMD_USAGE
"Example: lhinfo --stats face.lhg\n";

static const struct option longopt[] = {
	{ "json",    no_argument, NULL, 'J' },
	{ "stats",   no_argument, NULL, 'S' },
	{ "history", no_argument, NULL, 'H' },
	CMD_LONGOPT
};

typedef struct Want {
	int json, stats, script;
	int folder;                     /* of script_write */
} Want;

static void
info(FILE *f, const char *path, Want *w)
{
	CmdInput in;
	Lhg g;

	cmd_open(&in, path);
	while (cmd_read(&in, &g)) {
		if (!w->script)
			(w->json ? describe_json : describe_text)(f, in.name, &g, w->stats);
		else if (g.frame == 1)
			script_write(f, in.name, &g, &w->folder);
		lhg_free(&g);
	}
}

int
main(int argc, char *argv[])
{
	Want w = { .json = 0 };
	CmdText t;
	int opt;

	cmd_begin("lhinfo", text);
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		switch (opt) {
		case 'J': w.json = 1; break;
		case 'S': w.stats = 1; break;
		case 'H': w.script = 1; break;
		}
	if (w.script && (w.json || w.stats))
		misuse("--history prints a script alone: not with --json or --stats");
	cmd_operands(argc, argv, 0, argc);

	cmd_text_open(&t);
	if (w.script)
		fputs("#!/bin/sh\nset -e\n", t.f);
	if (optind == argc)
		info(t.f, NULL, &w);
	for (; optind < argc; optind++)
		info(t.f, argv[optind], &w);
	cmd_text_close(&t);
	cmd_write_bytes(NULL, t.bytes, t.n);

	free(t.bytes);
	return cmd_end();
}
