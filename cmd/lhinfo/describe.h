/* describe.h - describes a grid as text or JSON. */
#ifndef CMD_DESCRIBE_H
#define CMD_DESCRIBE_H

#include <stdio.h>

#include "../../format/lhg.h"

/* Size, height, frame, channels with their ranges, metadata and history; name is where
 * the grid came from.  As lines for a person, or as one JSON object on one line. */
void describe_text(FILE *f, const char *name, const Lhg *g);
void describe_json(FILE *f, const char *name, const Lhg *g);

#endif
