/* scene.h - grids collected for one .glb file. */
#ifndef CMD_SCENE_H
#define CMD_SCENE_H

#include "gridfile.h"

/* The surfaces of a stream: the triangles of the first, and the positions of all. */
typedef struct Scene {
	int             nv, nf, frames;
	int            *tri;
	float         **xyz;
	unsigned short *colour;         /* of the first surface, by the field; or NULL */
} Scene;

/* Whether the name ends in .glb. */
int scene_is(const char *name);

/* Adds the surface of g, as gridfile_bytes makes it.  fields, at most one, colours the first.  Dies if the surface has
 * another number of vertices than the first. */
void scene_add(Scene *s, const CmdInput *in, const Lhg *g, const OnMesh *on, const Fields *fields);

/* Makes the bytes of the file, with so many seconds for all frames, and frees the scene; or dies. */
void scene_bytes(Scene *s, const CmdInput *in, double seconds, char **bytes, size_t *n);

#endif
