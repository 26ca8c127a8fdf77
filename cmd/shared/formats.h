/* formats.h - the mesh formats in usage texts. */
#ifndef CMD_FORMATS_H
#define CMD_FORMATS_H

#include <stddef.h>

/* Copies text to out, of n bytes, with these marks replaced by lists from the table of formats.
 * Returns out.
 *
 *   {formats}     OFF, OBJ, .. or glTF      {ends}     .off .obj .ply or .stl
 *   {uv formats}  those with (u,v)          {uv ends}  theirs
 *   {stdout}      the format of a mesh written to stdout */
enum { FORMATS_USAGE = 8192 };
char *formats_usage(const char *text, char *out, size_t n);

#endif
