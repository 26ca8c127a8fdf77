/* fieldplot.h - a field of the chart with its title, colour bar and numbers. */
#ifndef FIELDPLOT_H
#define FIELDPLOT_H

#include "../base/chart.h"
#include "image.h"
#include "ticks.h"

/* Where everything lies in the image of one field, in pixels. */
typedef struct FieldPlot {
	int  zoom;              /* of the letters */
	int  w, h;              /* of the map */
	int  bar;               /* height of the colour bar */
	int  width, height;     /* of everything */
	int  bare;              /* only the map is drawn */
	int  axes;              /* numbers along u and v, and lines across the map */
	int  left, below;       /* room for these numbers */
	char title[160];
	ColourScale scale;
	Ticks ticks;
} FieldPlot;

/* The height of a map that is w pixels wide: each node of the chart is a rectangle of the width and
 * height of a cell.  If cells are more than 16 times as long as wide, they are drawn as squares, and
 * *square is set to 1, else to 0. */
int fieldplot_height(Chart g, int w, int *square);

/* Lays out a map of w x h pixels for p->scale; the caller has set scale, title,
 * bare and axes. */
void fieldplot_layout(FieldPlot *p, int w, int h);

/* Draws the field f[nv][nu], with NaN where nothing is known, with its upper left corner at (x,y).
 * Pixels have the colour of the nearest node; u goes right, v goes up. */
void fieldplot_draw(const FieldPlot *p, Chart g, const double *f, Image *m, int x, int y);

#endif
