/* channel.c - channels and metadata of a grid; a missing channel ends the program. */
#include <stdarg.h>
#include <string.h>

#include "cmd.h"

/* The command that makes a channel, for the message when stages were run in the wrong order. */
static const struct {
	const char *channel, *command;
} MAKER[] = {
	{ "x", "lh2grid" },           { "y", "lh2grid" },           { "z", "lh2grid" },
	{ "lambda", "grid2lh" },      { "H", "grid2lh" },
	{ "band.x", "grid2lh" },      { "band.y", "grid2lh" },      { "band.z", "grid2lh" },
	{ "start.x", "grid2lh" },     { "start.y", "grid2lh" },     { "start.z", "grid2lh" },
	{ "place.x", "grid2lh" },     { "place.y", "grid2lh" },     { "place.z", "grid2lh" },
	{ "nu1", "grid2lh --residual" },  { "nu2", "grid2lh --residual" },
	{ "tau1", "grid2lh --residual" }, { "tau2", "grid2lh --residual" }
};

/* A channel is missing: names the stage that was left out.  Positions are made of lambda and H, if
 * these are there, or else of a mesh. */
static _Noreturn void
missing(const CmdInput *in, const Lhg *g, const char *name)
{
	const char *command;
	size_t i;

	for (i = 0; i < sizeof MAKER/sizeof *MAKER; i++)
		if (strcmp(name, MAKER[i].channel) == 0) {
			command = i < 3 && !lhg_find(g, "lambda") ? "mesh2rect" : MAKER[i].command;
			die("%s: no channel %s: run %s first", in->name, name, command);
		}
	die("%s: no channel %s", in->name, name);
}

double *
cmd_need(const CmdInput *in, const Lhg *g, const char *name, int support)
{
	static const char *const word[] = { "grid", "border", "lattice" };
	LhgChannel *c = lhg_find(g, name);

	if (!c)
		missing(in, g, name);
	if (c->support != support)
		die("%s: channel %s has support %s, need %s", in->name, name, word[c->support], word[support]);
	return c->f;
}

double *
cmd_add(Lhg *g, const char *name, const char *unit, int support, int step)
{
	double *f = lhg_add(g, name, unit, support, step);

	if (!f)
		die("no memory or no room for channel %s", name);
	return f;
}

void
cmd_meta(Lhg *g, const char *key, const char *fmt, ...)
{
	char value[256];
	va_list ap;

	va_start(ap, fmt);
	vsnprintf(value, sizeof value, fmt, ap);
	va_end(ap);
	if (lhg_setmeta(g, key, value))
		die("no memory for the metadata");
}
