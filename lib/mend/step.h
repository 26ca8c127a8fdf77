/* step.h - the larger steps of mend: each adds to the report what it found and did.  Private to
 * lib/mend. */
#ifndef STEP_H
#define STEP_H

#include "mend.h"
#include "sheet.h"

/* Welds the boundary, finds neighbours, and gives every fan a vertex.  Returns 0 or MESH_ENOMEM. */
int mend_connect(Sheet *s, const MendOptions *o, MendReport *r);

/* Keeps the components that the options ask for.  Returns 0 or MESH_ENOMEM. */
int mend_choose(Sheet *s, const MendOptions *o, MendReport *r);

/* Closes T-junctions and fills the holes that the options ask for.  Returns 0, MESH_ENOMEM or
 * MESH_EDISK. */
int mend_fill(Sheet *s, const MendOptions *o, MendReport *r);

#endif
