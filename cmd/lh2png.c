/* lh2png - channels of a grid as a picture */
#include <stdlib.h>

#include "../lib/picture/png.h"
#include "shared/cmd.h"
#include "shared/numbered.h"
#include "lh2png/page.h"

enum { RANGE = 256, LOG, MAP, BARE, AXES, MOST = 32768 };

static const char text[] =
"usage: lh2png [-c NAME[,NAME..]|all] [--range=LOW,HIGH] [--log] [-o FILE] [GRID] >picture.png\n"
"Draws channels of a grid as a PNG picture: u goes right, v goes up.  Each channel has its name,\n"
"unit and colour bar; several are drawn side by side, in rows.  A pixel has the colour of the\n"
"nearest node.  Grey: the channel has no value there (a border is known only near the edge).\n"
"  -c, --channel=NAME  the channels to draw, or all [lambda,H; all if there is neither]\n"
"      --range=LOW,HIGH  the values at the ends of the colour bar, numbers or percentages: 1% is\n"
"                     the value that 1 % of the samples are below.  Values beyond have the colour\n"
"                     of the end.  Numbers make pictures comparable [1%,99%; 0%,100% shows all]\n"
"      --log          colours by the logarithm of the value, which must be positive; with -c all\n"
"                     only where it is\n"
"      --map=viridis|diverging  dark violet to yellow; or blue for negative, light grey at 0 and\n"
"                     red for positive, with a range centred on 0 [diverging for H and for\n"
"                     channels with both signs]\n"
"      --size=N       width of each map in pixels, its height follows from T [the number of nodes,\n"
"                     or its least multiple of at least 256]\n"
"      --axes         numbers along u and v, and lines across the map: to find the place of a\n"
"                     landmark for lhwarp\n"
"      --bare         only the maps: no names, bars and margins\n"
"  -o, --output=FILE  write FILE, which is complete or not there at all.  For a stream of several\n"
"                     grids the name must have a number, as in frame-%03d.png, which counts from 1\n"
"      --no-history   accepted as by every command, without effect: pictures have no history\n"
CMD_USAGE_COMMON
"-v prints the ends of the colour bar and of the values.\n"
"Example: mesh2rect face.ply | grid2lh | lh2png -o face.png\n";

static const struct option longopt[] = {
	{ "channel", required_argument, NULL, 'c' },
	{ "range",   required_argument, NULL, RANGE },
	{ "log",     no_argument,       NULL, LOG },
	{ "map",     required_argument, NULL, MAP },
	{ "size",    required_argument, NULL, 's' },
	{ "axes",    no_argument,       NULL, AXES },
	{ "bare",    no_argument,       NULL, BARE },
	CMD_LONGOPT
};

static void
write_picture(const CmdInput *in, const Image *m, const char *path)
{
	unsigned char *bytes;
	size_t n;

	if (png_bytes(m, &bytes, &n))
		die("%s: no memory for the bytes of a picture of %d x %d pixels", in->name, m->w, m->h);
	cmd_write_bytes(path, bytes, n);
	free(bytes);
}

int
main(int argc, char *argv[])
{
	char path[4096];
	const char *name;
	int opt, many, i = 0;
	PageOpt o;
	CmdInput in;
	Image m;
	Lhg g;

	cmd_begin("lh2png", text);
	pageopt_init(&o);
	while ((opt = cmd_getopt(argc, argv, "c:", longopt)) != -1)
		switch (opt) {
		case 'c': o.channels = optarg; break;
		case RANGE: pageopt_range(&o, optarg); break;
		case LOG: o.log = 1; break;
		case MAP: o.map = opt_word(optarg, "viridis\0diverging\0", "map"); break;
		case 's': o.size = (int)opt_long(optarg, 1, MOST, "size"); break;
		case AXES: o.axes = 1; break;
		case BARE: o.bare = 1; break;
		}
	cmd_operands(argc, argv, 0, 1);
	pageopt_check(&o);
	name = cmd_output();
	many = numbered(name);
	cmd_binary_output();

	cmd_open(&in, argv[optind]);
	while (cmd_read(&in, &g)) {
		if (!many && (g.frames > 1 || in.s.ahead))
			die("%s: holds several grids, one for each file: need -o NAME-%%03d.png", in.name);
		page_draw(&in, &g, &o, &m);
		write_picture(&in, &m, numbered_name(name, ++i, path, sizeof path));
		image_free(&m);
		lhg_free(&g);
	}
	return cmd_end();
}
