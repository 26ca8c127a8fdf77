/* lhinfo - the contents of a stream of grids */
#include <stdlib.h>

#include "shared/cmd.h"
#include "lhinfo/describe.h"

static const char text[] =
"usage: lhinfo [--json] [FILE...]\n"
"Prints what streams of grids hold (- or no FILE: stdin).  For each grid: size, height T of the\n"
"chart, frame, channels (unit, support, number of samples, minimum, maximum, mean), metadata\n"
"and history.  Streams are read to their ends, and every byte is checked.\n"
"      --json         one JSON object for each grid, each on one line\n"
CMD_USAGE
"Example: lhinfo --stats face.lhg\n";

static const struct option longopt[] = {
	{ "json", no_argument, NULL, 'J' },
	CMD_LONGOPT
};

static void
info(FILE *f, const char *path, int json)
{
	CmdInput in;
	Lhg g;

	cmd_open(&in, path);
	while (cmd_read(&in, &g)) {
		(json ? describe_json : describe_text)(f, in.name, &g);
		lhg_free(&g);
	}
}

int
main(int argc, char *argv[])
{
	int opt, json = 0;
	CmdText t;

	cmd_begin("lhinfo", text);
	while ((opt = cmd_getopt(argc, argv, "", longopt)) != -1)
		if (opt == 'J')
			json = 1;
	cmd_operands(argc, argv, 0, argc);

	cmd_text_open(&t);
	if (optind == argc)
		info(t.f, NULL, json);
	for (; optind < argc; optind++)
		info(t.f, argv[optind], json);
	cmd_text_close(&t);
	cmd_write_bytes(NULL, t.bytes, t.n);

	free(t.bytes);
	return cmd_end();
}
