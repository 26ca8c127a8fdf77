/* landfile.h - the file of --landmarks. */
#ifndef CMD_LANDFILE_H
#define CMD_LANDFILE_H

#include "../../lib/morph/matching.h"

/* Sets m to the correspondence of borders a and b by the landmarks in the file path, or dies. */
void landfile_match(const char *path, const Border *a, const Border *b, Matching *m);

#endif
