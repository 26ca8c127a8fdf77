/* chosen.c - the channels that lh2png draws. */
#include <string.h>

#include "chosen.h"

int
chosen_by_name(const PageOpt *o)
{
	return o->channels && strcmp(o->channels, "all") != 0;
}

static int
all_channels(const Lhg *g, const LhgChannel *c[LHG_MAXCHAN])
{
	int k;

	for (k = 0; k < g->nchan; k++)
		c[k] = &g->chan[k];
	return g->nchan;
}

static int
named_channels(const CmdInput *in, const Lhg *g, const char *names, const LhgChannel *c[LHG_MAXCHAN])
{
	char name[LHG_NAMELEN];
	size_t len;
	int n = 0;

	for (; *names; names += len + (names[len] == ',')) {
		len = strcspn(names, ",");
		if (n == LHG_MAXCHAN)
			misuse("--channel: more than %d channels", LHG_MAXCHAN);
		if (len == 0 || len >= sizeof name)
			misuse("--channel: '%.*s' is not the name of a channel", (int)len, names);
		memcpy(name, names, len);
		name[len] = '\0';
		c[n] = lhg_find(g, name);
		if (!c[n++])
			cmd_need(in, g, name, LHG_GRID);        /* dies, and names the command that makes it */
	}
	return n;
}

int
chosen(const CmdInput *in, const Lhg *g, const PageOpt *o, const LhgChannel *c[LHG_MAXCHAN])
{
	int n = 0;

	if (chosen_by_name(o))
		return named_channels(in, g, o->channels, c);
	if (!o->channels && lhg_find(g, "lambda"))
		c[n++] = lhg_find(g, "lambda");
	if (!o->channels && lhg_find(g, "H"))
		c[n++] = lhg_find(g, "H");
	return n ? n : all_channels(g, c);
}
