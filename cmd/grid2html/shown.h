/* shown.h - the surfaces of a stream, as a page shows them. */
#ifndef CMD_SHOWN_H
#define CMD_SHOWN_H

#include "../shared/cmd.h"

enum { SHOWN_NAME = 32 };

/* A channel to colour by: values at every vertex in each frame. */
typedef struct ShownField {
	char   name[SHOWN_NAME];
	float *f;               /* [frames][nv] */
	double low, high;       /* the ends of the colours */
	int    diverging;       /* blue to red, centred on 0; else viridis */
} ShownField;

typedef struct Shown {
	const char *name;       /* of the file */
	int         nu, nv, chart;
	int         vertices, faces, frames;
	int        *tri;        /* [faces][3], of the first frame */
	float      *xyz;        /* [frames][vertices][3] */
	int         fields;
	ShownField *field;
} Shown;

/* Reads all grids of a stream, channels x y z, or place.x place.y place.z where there are no x y z; all other
 * channels on all nodes become fields.  Dies if the grids have different sizes. */
void shown_read(const char *path, Shown *s);

/* Adds the channels of a stream of grids of the same size, as lambda and H: of grid k for frame k, of the last grid
 * beyond. */
void shown_colours(const char *path, Shown *s);

/* Adds to both the field "distance": that of the nodes of one from those of the other, which must have as many;
 * frame k with frame k, or the last one. */
void shown_distance(Shown *a, Shown *b);

/* Sets the ranges of fields: 1 to 99 percent of the values of all frames.  Fields of the same name in a and b, which
 * may be NULL, have the same range. */
void shown_ranges(Shown *a, Shown *b);

void shown_free(Shown *s);

#endif
