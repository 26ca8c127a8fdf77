/* disks.h - random disks for tests: stars, strips, combs, spirals, fans, grids, with needles,
 * spikes, folds, cusps, of any size and place. */
#ifndef DISKS_H
#define DISKS_H

#include <stdint.h>

#include "../lib/mesh/mesh.h"

enum { DISKS_TAG = 64 };

/* How rough the disks are. */
enum {
	DISKS_ANY,      /* with needles and fans of thin triangles, scaled by 1e-6 .. 1e6, moved far away */
	DISKS_NICE,     /* without these, of size 1 .. 1000 */
	DISKS_FLAT      /* DISKS_NICE in the plane z = 0, counterclockwise */
};

/* A random disk, the same for equal seeds on every machine.  tag: a name for its kind.  Returns 0,
 * or -1 if the seed has none: a triangle without area, or a boundary of three vertices. */
int disks_random(uint64_t seed, int kind, Disk *d, char tag[DISKS_TAG]);

/* A disk of triangles.  Returns the result of disk_from_soup. */
int disks_of(int nv, const double *xyz, int nf, const int *tri, Disk *d);

/* The vertices in another order: vertex i becomes number[i], of d->m.nv numbers. */
int disks_renumbered(const Disk *d, uint64_t seed, Disk *other, int *number);

/* The faces in another order, each beginning at any of its corners. */
int disks_reordered(const Disk *d, uint64_t seed, Disk *other);

/* Whether d is one: the twins are those of the faces, one fan at each vertex, one boundary, which
 * is the loop up to its start. */
int disks_is_disk(const Disk *d);

#endif
