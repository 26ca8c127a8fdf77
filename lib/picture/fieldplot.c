/* fieldplot.c - a field of the chart with its title, colour bar and numbers. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "fieldplot.h"
#include "font.h"

static const Colour BLACK = { 0, 0, 0 }, GREY = { 110, 110, 110 };

/* Lengths in pixels at zoom 1; LINES is the least height of the bar in lines of text. */
enum { PAD = 8, BAR = 14, MARK = 4, LINES = 8 };

enum { APART = 40, DIGITS = 5 };         /* lines of the axes at least so far apart; room for a number */

/* Beyond this ratio of its sides a cell is drawn as a square: the picture would be a line. */
static const double LONGEST = 16;

int
fieldplot_height(Chart g, int w, int *square)
{
	double ratio = chart_k(g)/chart_h(g), h;

	*square = !(ratio >= 1/LONGEST && ratio <= LONGEST);
	if (*square)
		ratio = 1;
	h = floor(w/(double)g.nu*g.nv*ratio + 0.5);
	return (int)fmin(fmax(h, 1), 1e8);      /* too large for an image, but not for an int */
}

void
fieldplot_layout(FieldPlot *p, int w, int h)
{
	const int zoom = 1 + w/1024, line = FONT_HEIGHT*zoom, em = FONT_WIDTH*zoom;
	int i, most = 0;

	p->zoom = zoom;
	p->width = p->w = w;
	p->height = p->h = h;
	p->left = p->axes ? DIGITS*em + MARK*zoom : 0;
	p->below = p->axes ? line + MARK*zoom : 0;
	if (p->bare)
		return;
	p->bar = h > LINES*line ? h : LINES*line;
	ticks_set(&p->ticks, &p->scale, p->bar, 1.5*line);
	for (i = 0; i < p->ticks.n; i++)
		most = (int)fmax(most, (double)strlen(p->ticks.label[i]));
	p->width = (int)fmax(p->left + w + (3*PAD + BAR + 2*MARK)*zoom + most*em, 2*PAD*zoom + (double)strlen(p->title)*em);
	p->height = p->bar + p->below + 2*PAD*zoom + 2*line;
}

static void
draw_map(const FieldPlot *p, Chart g, const double *f, Image *m, int x, int y)
{
	int a, b, i, j;

	for (b = 0; b < p->h; b++) {
		j = (int)((p->h - 1 - b + 0.5)*g.nv/p->h);
		for (a = 0; a < p->w; a++) {
			i = (int)((a + 0.5)*g.nu/p->w);
			image_rectangle(m, x + a, y + b, 1, 1, colourscale_colour(&p->scale, f[(size_t)j*g.nu + i]));
		}
	}
}

static void
draw_bar(const FieldPlot *p, Image *m, int x, int y)
{
	const int zoom = p->zoom, right = x + BAR*zoom;
	const Ticks *t = &p->ticks;
	int i, at;

	for (i = 0; i < p->bar; i++)
		image_rectangle(m, x, y + i, BAR*zoom, 1, colourmap(p->scale.map,
		    t->n > 1 ? 1 - i/(p->bar - 1.0) : 0.5));
	for (i = 0; i < t->n; i++) {
		at = y + (int)((1 - colourscale_place(&p->scale, t->value[i]))*(p->bar - 1) + 0.5);
		image_rectangle(m, right, at, MARK*zoom, zoom, BLACK);
		image_text(m, right + 2*MARK*zoom, at - FONT_HEIGHT*zoom/2, zoom, t->label[i]);
	}
}

/* The least of .., 0.1, 0.2, 0.5, 1, .. that is at least APART pixels long. */
static double
axis_step(double pixels, int zoom)
{
	static const double by[3] = { 2, 2.5, 2 };
	double step = 1e-4;
	int k;

	for (k = 0; step*pixels < APART*zoom && k < 60; k++)
		step *= by[k % 3];
	return step;
}

/* Lines at round numbers of u (axis 0) or v, with these numbers left of and below the map, whose upper
 * left corner is (x,y).  u = 0 is the middle of the first node. */
static void
draw_axis(const FieldPlot *p, Chart g, int axis, Image *m, int x, int y)
{
	int length = axis ? p->h : p->w, n = axis ? g.nv : g.nu, k, at, end;
	double side = axis ? g.T : 1, steps = chart_steps(g, axis), step = axis_step(length*steps/(n*side), p->zoom), i;
	char number[24];

	for (k = 0; k*step <= side*(1 + 1e-9); k++) {
		i = k*step/side*steps - 0.5*g.kind->joined[axis][0] + 0.5;
		at = (int)fmin(fmax(i*length/n, 0), length - 1);
		snprintf(number, sizeof number, "%.4g", k*step);
		end = (int)strlen(number)*FONT_WIDTH*p->zoom;
		if (axis) {
			image_rectangle(m, x - MARK*p->zoom, y + length - 1 - at, p->w + MARK*p->zoom, 1, GREY);
			image_text(m, x - 2*MARK*p->zoom - end, y + length - 1 - at - FONT_HEIGHT*p->zoom/2, p->zoom, number);
		} else {
			image_rectangle(m, x + at, y, 1, p->h + MARK*p->zoom, GREY);
			image_text(m, x + at - end/2, y + p->h + MARK*p->zoom, p->zoom, number);
		}
	}
}

void
fieldplot_draw(const FieldPlot *p, Chart g, const double *f, Image *m, int x, int y)
{
	const int pad = PAD*p->zoom, line = FONT_HEIGHT*p->zoom;

	if (p->bare) {
		draw_map(p, g, f, m, x, y);
		return;
	}
	image_text(m, x + pad, y + pad/2, p->zoom, p->title);
	draw_map(p, g, f, m, x + pad + p->left, y + pad + line);
	draw_bar(p, m, x + 2*pad + p->left + p->w, y + pad + line);
	if (p->axes) {
		draw_axis(p, g, 0, m, x + pad + p->left, y + pad + line);
		draw_axis(p, g, 1, m, x + pad + p->left, y + pad + line);
	}
}
