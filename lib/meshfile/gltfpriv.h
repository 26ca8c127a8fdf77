/* gltfpriv.h - the parts of the reader of glTF 2.  Private to lib/. */
#ifndef GLTFPRIV_H
#define GLTFPRIV_H

#include "json.h"

/* The items of an array of the root, such as "nodes". */
typedef struct GltfList {
	const char *name;
	uint32_t *item;         /* [n] their values */
	uint32_t n;
} GltfList;

enum { GLTF_BUFFERS, GLTF_VIEWS, GLTF_ACCESSORS, GLTF_MESHES, GLTF_NODES, GLTF_SCENES, GLTF_LISTS };

typedef struct GltfBuffer {
	const char *p;          /* its bytes, NULL before it is used; in the file, or own */
	size_t n;
	char *own;              /* malloc'd, or NULL */
} GltfBuffer;

typedef struct Gltf {
	Reader *r;
	size_t size;            /* of the file and of what was read of files beside it, in bytes */
	Json j;
	const char *bin;        /* the binary chunk of .glb, NULL: none */
	size_t nbin;
	GltfList list[GLTF_LISTS];
	GltfBuffer *buffer;     /* [list[GLTF_BUFFERS].n] */
	char *seen;             /* [list[GLTF_NODES].n] the node was reached */
	size_t nv, nf, ni;      /* counted in a first pass over the scene, before memory is allocated */
	size_t visits;          /* primitives met in that pass */
	int counting;
} Gltf;

/* Numbers in the file: vectors of n components. */
typedef struct GltfArray {
	const char *p;
	size_t stride, count;
	int n, size, kind;      /* of a component: 'i' signed, 'u' unsigned, 'f' floating */
	double scale;           /* of normalized integers; 1: none */
} GltfArray;

/* Item i of a list, or -1 with a message if there is none. */
long long gltf_item(Gltf *g, int list, long long i);

/* Accessor i as an array of n components; checks that its bytes are there.  Returns 0 or a MESH_E code. */
int gltf_accessor(Gltf *g, long long i, int n, GltfArray *a);

/* Component c of item i. */
double gltf_component(const GltfArray *a, size_t i, int c);

/* Reads the meshes of the scene, as its nodes place them; or counts what they have.  Returns 0 or a MESH_E
 * code. */
int gltf_scene(Gltf *g);

#endif
