/* disks.h - random disks for tests.  Their shapes are polygons, stars, strips, combs, spirals, fans
 * and grids; some have needles, spikes, folds or cusps; they may have any size and lie anywhere in
 * space. */
#ifndef DISKS_H
#define DISKS_H

#include <stdint.h>

#include "../lib/mesh/mesh.h"

enum { DISKS_TAG = 64 };

/* How rough a random disk may be. */
enum {
	DISKS_ANY,      /* may have needles, be scaled by 1e-6 .. 1e6 and lie far from the origin */
	DISKS_NICE,     /* no inserted needles, not scaled, near the origin; of size 1 .. 1000 */
	DISKS_FLAT      /* DISKS_NICE in the plane z = 0, counterclockwise */
};

/* Makes a random disk, the same for equal seeds on every machine.  kind is one of the above; tag gets
 * the names of the shape and of its changes, such as "star/needles/cusp".  Returns 0, or -1 if this
 * seed gives no usable disk, for instance because a triangle has no area or the boundary has only
 * three vertices; d then holds nothing to free. */
int disks_random(uint64_t seed, int kind, Disk *d, char tag[DISKS_TAG]);

/* Makes a disk of the given triangles.  Returns the result of disk_from_soup. */
int disks_of(int nv, const double *xyz, int nf, const int *tri, Disk *d);

/* Makes the same disk with its vertices in a random order: vertex i of d becomes vertex number[i] of
 * other.  number has room for d->m.nv numbers.  Returns the result of disk_from_soup. */
int disks_renumbered(const Disk *d, uint64_t seed, Disk *other, int *number);

/* Makes the same disk with its faces in a random order, each beginning at a random corner.  Returns
 * the result of disk_from_soup. */
int disks_reordered(const Disk *d, uint64_t seed, Disk *other);

/* Whether d is a valid disk: it is connected, its twins follow from its faces, the faces at each
 * vertex form one fan, and it has one boundary loop, which equals d->loop except perhaps for the
 * first vertex. */
int disks_is_disk(const Disk *d);

/* The number of triangles that are turned over at the places u, v of their corners, computed with more
 * digits than the places have.  *thin is the number of the others that are so thin that binary64 may not
 * tell the sign of their area: it is at most 8 roundings of the two products whose difference it is. */
int disks_turned(const Disk *d, const double *u, const double *v, int *thin);

#endif
