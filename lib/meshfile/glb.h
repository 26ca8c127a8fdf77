/* glb.h - a surface, or a morph of surfaces, as binary glTF 2 (.glb).
 *
 * One mesh of triangles with normals and perhaps colours.  Further frames are morph targets, and an animation
 * goes from frame to frame by their weights.  Written here, not by a library: the file is a line of JSON and
 * arrays of floats; Debian's libtinygltf would be more code to call than this, and C++.
 */
#ifndef GLB_H
#define GLB_H

#include <stddef.h>

enum { GLB_ENOMEM = -1, GLB_EVALUE = -2, GLB_ELARGE = -3 };

typedef struct Glb {
	int           nv, nf;
	const int    *tri;              /* [nf][3] */
	int           frames;           /* 1 or more */
	float *const *xyz;              /* [frames] positions, [nv][3] each */
	const unsigned short *colour;   /* [nv][4] red, green, blue and 65535, linear; or NULL */
	double        seconds;          /* from one frame to the next */
} Glb;

/* Sets *bytes, malloc'd, and *n.  On failure there is nothing to free.  Returns 0; GLB_ENOMEM; GLB_EVALUE if a
 * position is not finite; or GLB_ELARGE if the file would be larger than the 4 GiB that the format can hold. */
int glb_write(const Glb *g, char **bytes, size_t *n);

#endif
