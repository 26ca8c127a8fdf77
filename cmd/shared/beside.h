/* beside.h - files beside a mesh file that hold a part of it. */
#ifndef CMD_BESIDE_H
#define CMD_BESIDE_H

#include "../../lib/meshfile/meshfile.h"

/* Sets b to read the files in the folder of the mesh file `path`, and returns it; NULL for stdin ("-" or NULL), which
 * has no folder.  Only regular files are read. */
const MeshBeside *beside_of(const char *path, MeshBeside *b);

#endif
