/* exact.h - whether residual channels belong to lambda and H: metadatum "residual" of format/LHG.md. */
#ifndef EXACT_H
#define EXACT_H

#include "../../format/lhg.h"

/* Writes the metadatum: lambda, H and the residual channels of g are those of one surface. */
void exact_promise(Lhg *g);

/* Whether g has the metadatum, and no stage has changed a sample of these channels since. */
int exact_holds(const Lhg *g);

#endif
