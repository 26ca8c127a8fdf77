/* describe.h - describes a grid as text or JSON. */
#ifndef CMD_DESCRIBE_H
#define CMD_DESCRIBE_H

#include <stdio.h>

#include "../../format/lhg.h"

/* Write size, height, frame, channels with their ranges, metadata and history of g to f: as lines
 * for a person, or as one JSON object on one line.  name: the input that the grid came from.  With
 * stats, each channel also has its median, its values at 1 and 99 %, and a histogram between these. */
void describe_text(FILE *f, const char *name, const Lhg *g, int stats);
void describe_json(FILE *f, const char *name, const Lhg *g, int stats);

#endif
