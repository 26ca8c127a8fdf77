/* lhinterp - between two pairs (lambda, H) */
#include <stdlib.h>
#include <string.h>

#include "../lib/blend.h"
#include "cmd.h"
#include "history.h"

static const char text[] =
"usage: lhinterp -t T | -n FRAMES A B >lh.lhg\n"
"reads two grids of equal size and equal channels (- is stdin) and writes (1-t) A + t B:\n"
"lambda and H, the boundary band, the start, the height T of the chart and all other\n"
"channels, equations (20)-(22).  Boundaries correspond by equal place on the rectangle.\n"
"  -t, --at=T         one grid at T, 0..1: A itself at 0, B at 1\n"
"  -n, --frames=N     N grids, t = 0, 1/(N-1), .., 1, as one stream; 2..1000000\n"
CMD_USAGE
"Metadata equal in A and B stay, others go; t is added.  The history holds the steps of\n"
"both, marked A and B.\n";

static const struct option longopt[] = {
	{ "at",     required_argument, NULL, 't' },
	{ "frames", required_argument, NULL, 'n' },
	CMD_LONGOPT
};

static void
check_match(const CmdInput *A, const Lhg *a, const CmdInput *B, const Lhg *b)
{
	const LhgChannel *c, *d;
	int i;

	if (a->nu != b->nu || a->nv != b->nv)
		die("%s has %d x %d nodes, %s has %d x %d", A->name, a->nu, a->nv, B->name, b->nu, b->nv);
	cmd_need(A, a, "lambda", LHG_GRID);
	cmd_need(A, a, "H", LHG_GRID);
	for (i = 0; i < b->nchan; i++)
		if (!lhg_find(a, b->chan[i].name))
			die("%s has a channel %s, %s has none", B->name, b->chan[i].name, A->name);
	for (i = 0; i < a->nchan; i++) {
		c = &a->chan[i];
		d = lhg_find(b, c->name);
		if (!d)
			die("%s has a channel %s, %s has none", A->name, c->name, B->name);
		if (d->support != c->support || d->step != c->step)
			die("channel %s has another support in %s than in %s", c->name, A->name, B->name);
		if (strcmp(c->unit, d->unit) != 0)
			die("channel %s is in %s in %s, in %s in %s", c->name, c->unit, A->name, d->unit, B->name);
	}
}

static void
between(const Lhg *a, const Lhg *b, double t, Lhg *g)
{
	const LhgChannel *c;
	int i;

	lhg_init(g, a->nu, a->nv, a->T);
	blend(1, t, &a->T, &b->T, &g->T);
	for (i = 0; i < a->nchan; i++) {
		c = &a->chan[i];
		blend(c->n, t, c->f, lhg_find(b, c->name)->f, cmd_add(g, c->name, c->unit, c->support, c->step));
	}
	history_merge(a, b, g);
	cmd_meta(g, "t", "%.10g", t);
}

int
main(int argc, char *argv[])
{
	double t = -1;
	int opt, frames = 0, i;
	CmdInput A, B;
	Lhg a, b, g;

	cmd_begin("lhinterp", text);
	while ((opt = cmd_getopt(argc, argv, "t:n:", longopt)) != -1)
		switch (opt) {
		case 't': t = opt_double(optarg, 0, 1, "at"); break;
		case 'n': frames = opt_long(optarg, 2, LHG_MAXFRAMES, "frames"); break;
		}
	if ((t < 0) == (frames == 0))
		misuse("say one of -t T and -n FRAMES");
	cmd_operands(argc, argv, 2, 2);
	cmd_binary_output();

	cmd_open(&A, argv[optind]);
	cmd_read_one(&A, &a);
	cmd_open(&B, argv[optind + 1]);
	cmd_read_one(&B, &b);
	check_match(&A, &a, &B, &b);
	for (i = 1; i <= (frames ? frames : 1); i++) {
		between(&a, &b, frames ? (i - 1)/(frames - 1.0) : t, &g);
		g.frame = i;
		g.frames = frames ? frames : 1;
		cmd_write(&g);
		lhg_free(&g);
	}
	lhg_free(&a);
	lhg_free(&b);
	return cmd_end();
}
