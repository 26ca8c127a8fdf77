/* cornerunfold.h - turns folded cells near a corner of a grid back.
 *
 * Between ragged borders a smooth surface may still have folded cells.  Moving a node or two by a part
 * of a cell is then enough. */
#ifndef CORNERUNFOLD_H
#define CORNERUNFOLD_H

#include "../base/chart.h"

/* Moves inner nodes less than `radius` steps along u and along v from corner k, one after the other,
 * each along one of the lines to its eight neighbours.  Always the move is made that lowers the sum of
 * max(0, 1/10 - cos)^2 most, over the angles between cells side by side, and of several such moves the
 * shortest.  If folded cells (cornerfold.h) are left, phi stays as it was.  radius is at most
 * corner_radius. */
void corner_unfold(Chart g, int k, double *const phi[3], int radius);

#endif
