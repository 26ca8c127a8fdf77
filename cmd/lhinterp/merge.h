/* merge.h - metadata and history of a grid that is made of several. */
#ifndef CMD_MERGE_H
#define CMD_MERGE_H

#include "morph.h"

/* Adds to g the metadata that all grids of m have in common, and the steps of each, those of the first
 * marked "A: ", of the second "B: ", and so on to "Z: ", "AA: ", ..; or dies if memory runs out.  The
 * metadatum `warped` (format/LHG.md) is that of the grid with the largest |mu| whose weight is not 0. */
void merge_text(const Morph *m, const double *w, Lhg *g);

#endif
