/* notes.h - the notes of mesh2disk: a line for each change. */
#ifndef CMD_NOTES_H
#define CMD_NOTES_H

#include "../../lib/mend/mend.h"
#include "../../lib/meshfile/meshformat.h"

/* Prints the notes on stderr.  Returns the same lines, each beginning with "mesh2disk: ", for the comments
 * of the output, to be freed.  s is the input. */
char *notes(const char *name, const Soup *s, const MendReport *r, const MeshFormat *format);

#endif
