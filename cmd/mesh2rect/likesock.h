/* likesock.h - the option --like of mesh2rect on the sock. */
#ifndef CMD_LIKESOCK_H
#define CMD_LIKESOCK_H

#include "../../lib/map/conformal.h"

/* Sets g->nu and g->nv to those of the sock in the file; dies if it holds none. */
void likesock_size(const char *path, Chart *g);

/* Exchanges the cones of c, a map of a mesh of so many vertices, which turns it by half a period, if the boundary then comes nearer to that of
 * the sock in the file, which has as many nodes.  Returns the distance of the boundaries after the best
 * motion: root mean square over the nodes, in units of the root mean square distance from their centre. */
double likesock_turn(const char *path, int vertices, Conformal *c);

#endif
