/* lhgends.c - prints the least and the largest value of each channel of each grid on stdin.
 *
 * cc -o lhgends lhgends.c $(pkg-config --cflags --libs lhg)
 * mesh2rect face.ply | grid2lh | ./lhgends
 */
#include <lhg.h>

static void
print_ends(const LhgChannel *c)
{
	double low = c->f[0], high = c->f[0];
	size_t i;

	for (i = 1; i < c->n; i++) {
		if (c->f[i] < low)
			low = c->f[i];
		if (c->f[i] > high)
			high = c->f[i];
	}
	printf("%s %.17g %.17g %s\n", c->name, low, high, c->unit);
}

int
main(void)
{
	LhgStream s;
	Lhg g;
	int k, got;

	lhg_open(&s, stdin);
	while ((got = lhg_read(&s, &g)) > 0) {
		for (k = 0; k < g.nchan; k++)
			print_ends(&g.chan[k]);
		lhg_free(&g);
	}
	if (got < 0)
		fprintf(stderr, "lhgends: stdin: %s\n", s.err);
	return got < 0;
}
