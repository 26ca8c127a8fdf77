/* patchnode.h - sizes of the equations of a node.  Private to patch. */
#ifndef PATCHNODE_H
#define PATCHNODE_H

#include "misfitnode.h"
#include "patch.h"

/* A node and its four neighbours; their coordinates; the derivatives of its residuals. */
enum { BESIDE = 5, NUMBERS = 3*BESIDE, JACOBIAN = MISFIT_PARTS*NUMBERS };

#endif
