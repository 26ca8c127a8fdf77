/* grid2html - surfaces as a page to turn, zoom and play */
#include <stdlib.h>
#include <string.h>

#include "grid2html/page.h"
#include "shared/cmd.h"

enum { BESIDE = 256, DISTANCE, THREE = CMD_UNRECORDED };

static const char text[] =
"usage: grid2html [-c NAME] [--colours=LH] [--beside=GRID] [--distance] [GRID] >page.html\n"
"Writes a page that shows a gridded surface, or a stream of them, in a browser, without a\n"
"network: drag to turn, wheel to zoom, a slider for the frames (scales, the steps of a morph).\n"
"GRID has channels x y z, or place.x place.y place.z; all its other channels on all nodes can colour\n"
"it.  A viridis scale, or for values of both signs blue to red, from 1 to 99 percent of the values\n"
"of all frames.\n"
"  -c, --channel=NAME  the channel that is shown first [none]\n"
"      --colours=LH   also the channels of this stream of grids of the same size: of its grid k for\n"
"                     frame k, of its last grid beyond\n"
"      --beside=GRID  a second surface, or stream, at the right, with the same camera and slider,\n"
"                     each in the middle of its half; enlarged if it is a tenth as\n"
"                     wide as the other or less, as in metres beside millimetres\n"
"      --distance     with --beside: also the distance of each node from the same node of the other\n"
"      --three=DIR    the folder with three.min.js and examples/js/controls/OrbitControls.js of\n"
"                     three.js [/usr/share/javascript/three, of Debian's libjs-three]; they become\n"
"                     part of the page\n"
CMD_USAGE
"Example: lhfft --scale=3,6,12 face-lh.lhg | lh2grid | grid2html -o scales.html\n";

static const struct option longopt[] = {
	{ "channel",  required_argument, NULL, 'c' },
	{ "colours",  required_argument, NULL, 'C' },
	{ "beside",   required_argument, NULL, BESIDE },
	{ "distance", no_argument,       NULL, DISTANCE },
	{ "three",    required_argument, NULL, THREE },
	CMD_LONGOPT
};

static int
has_field(const Shown *s, const char *name)
{
	int k;

	for (k = 0; k < s->fields; k++)
		if (strcmp(s->field[k].name, name) == 0)
			return 1;
	return 0;
}

int
main(int argc, char *argv[])
{
	const char *channel = NULL, *colours = NULL, *beside = NULL, *three = "/usr/share/javascript/three";
	int opt, distance = 0;
	Shown a, b = { .frames = 0 };
	CmdText t;

	cmd_begin("grid2html", text);
	while ((opt = cmd_getopt(argc, argv, "c:", longopt)) != -1)
		switch (opt) {
		case 'c': channel = optarg; break;
		case 'C': colours = optarg; break;
		case BESIDE: beside = optarg; break;
		case DISTANCE: distance = 1; break;
		case THREE: three = optarg; break;
		}
	if (distance && !beside)
		misuse("--distance needs --beside");
	cmd_operands(argc, argv, 0, 1);

	shown_read(argv[optind], &a);
	if (colours)
		shown_colours(colours, &a);
	if (beside)
		shown_read(beside, &b);
	if (distance)
		shown_distance(&a, &b);
	if (channel && !has_field(&a, channel) && !has_field(&b, channel))
		die("%s: no channel %s on all nodes", a.name, channel);
	shown_ranges(&a, beside ? &b : NULL);
	cmd_text_open(&t);
	page_write(t.f, three, &a, beside ? &b : NULL, channel);
	cmd_text_close(&t);
	cmd_write_bytes(NULL, t.bytes, t.n);

	free(t.bytes);
	shown_free(&a);
	shown_free(&b);
	return cmd_end();
}
