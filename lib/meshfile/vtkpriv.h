/* vtkpriv.h - the parts of the reader of legacy VTK files.  Private to lib/. */
#ifndef VTKPRIV_H
#define VTKPRIV_H

#include "meshpriv.h"

typedef struct VtkType {
	const char *name;
	int size, kind;         /* in binary files; 'u' unsigned, 'i' signed, 'f' floating */
} VtkType;

typedef struct Vtk {
	Reader *r;
	int binary;             /* data are big-endian, else text */
	int offsets;            /* cells as OFFSETS and CONNECTIVITY: since version 5 */
	long long tuples;       /* values of each component of an attribute, after POINT_DATA n or CELL_DATA n */
} Vtk;

/* vtk_count reads the next word as a whole number >= 0, vtk_type as the name of a type.  Both return 0 or
 * MESH_EFORMAT. */
int vtk_count(Vtk *v, const char *what, long long *n);
int vtk_type(Vtk *v, const VtkType **type);

/* Goes on to the next line. */
void vtk_nextline(Reader *r);

/* Goes to the data of n values of this type, whose line ends here.  Checks that there is room for them.
 * Returns 0 or MESH_EFORMAT. */
int vtk_data(Vtk *v, const char *what, long long n, const VtkType *type);

/* Reads value i of n from the place r, which may be another than v->r.  Returns 0 or MESH_EFORMAT. */
int vtk_value(const Vtk *v, Reader *r, const VtkType *type, const char *what, long long i, long long n, double *x);

/* Skips n values.  Returns 0 or MESH_EFORMAT. */
int vtk_skip(Vtk *v, const VtkType *type, const char *what, long long n);

/* Reads the section of this keyword, if it is one of attributes (SCALARS, FIELD, ..); *known is set to
 * whether it is.  Returns 0 or MESH_EFORMAT. */
int vtk_attribute(Vtk *v, Token keyword, int *known);

#endif
