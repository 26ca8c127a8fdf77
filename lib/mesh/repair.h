/* repair.h - welding vertices of equal position, by CGAL. */
#ifndef REPAIR_H
#define REPAIR_H

#ifdef __cplusplus
extern "C" {
#endif

enum { REPAIR_ENOMEM = -1 };

/* Gives vertices of equal position the same number.
 *
 * nv, xyz  in      [nv][3], finite
 * to       out     [nv] the new number of each vertex; new numbers run from 0 in the order in
 *                  which positions first appear
 * nnew     out     the count of new numbers
 *
 * Returns 0 or REPAIR_ENOMEM. */
int repair_weld(int nv, const double *xyz, int *to, int *nnew);

#ifdef __cplusplus
}
#endif

#endif
