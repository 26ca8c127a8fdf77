/* meshformat.c - the table of mesh formats. */
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "meshformat.h"
#include "meshpriv.h"
#include "writepriv.h"

enum { UV = MESHFORMAT_UV, SHARED = MESHFORMAT_SHARED, WRITE = MESHFORMAT_WRITE,
	SINGLE = MESHFORMAT_SINGLE, FIELDS = MESHFORMAT_FIELDS };

static const MeshFormat table[] = {
	{ "OFF", ".off", SHARED | WRITE,      off_recognise, off_read, off_write },
	{ "OBJ", ".obj", SHARED | WRITE | UV, obj_recognise, obj_read, obj_write },
	{ "PLY", ".ply", SHARED | WRITE | UV | FIELDS, ply_recognise, ply_read, ply_write },
	{ "STL", ".stl", WRITE | SINGLE,      stl_recognise, stl_read, stl_write },
	{ "XYZ", ".xyz", 0,                   xyz_recognise, xyz_read, NULL },
	{ "MNI OBJ", ".obj", SHARED,          mni_recognise, mni_read, NULL },
	{ "Hoppe M", ".m", SHARED,            hoppe_recognise, hoppe_read, NULL },
	{ "FreeSurfer", ".pial .white", SHARED | WRITE | SINGLE, fsbinary_recognise, fsbinary_read, fsbinary_write },
	{ "FreeSurfer ASCII", ".asc", SHARED, fsascii_recognise, fsascii_read, NULL },
	{ "VTK", ".vtk", SHARED,              vtk_recognise, vtk_read, NULL },
	{ "VTP", ".vtp", SHARED | WRITE | FIELDS, vtp_recognise, vtp_read, vtp_write },
	{ "GIFTI", ".gii", SHARED | WRITE | SINGLE, gifti_recognise, gifti_read, gifti_write },
	{ "glTF", ".glb .gltf", SHARED,       gltf_recognise, gltf_read, NULL }
};

enum { ROWS = sizeof table / sizeof *table };

const MeshFormat *
meshformat(int i)
{
	return i >= 0 && i < ROWS ? &table[i] : NULL;
}

/* Whether name is longer than n and ends in the n bytes at end, in upper or lower case. */
static int
ends_in(const char *name, const char *end, size_t n)
{
	const size_t all = strlen(name);

	return all > n && strncasecmp(name + all - n, end, n) == 0;
}

const MeshFormat *
meshformat_of(const char *file)
{
	const char *end;
	size_t n;
	int i;

	for (i = 0; i < ROWS; i++)
		for (end = table[i].ends; (n = strcspn(end, " ")) > 0; end += n + (end[n] == ' '))
			if ((table[i].can & WRITE) && ends_in(file, end, n))
				return &table[i];
	return NULL;
}

/* The list "A, B or C" of the formats that have all flags of can: their names, or the ends of
 * their file names. */
static char *
list(unsigned can, const char *comma, const char *word, int ends, char buf[MESHFORMAT_LIST])
{
	int i, left = 0, first = 1;
	size_t n = 0;

	for (i = 0; i < ROWS; i++)
		left += (table[i].can & can) == can;
	for (buf[0] = '\0', i = 0; i < ROWS && n < MESHFORMAT_LIST; i++) {
		const char *s = ends ? table[i].ends : table[i].name;

		if ((table[i].can & can) != can)
			continue;
		if (!first && left == 1)
			n += (size_t)snprintf(buf + n, MESHFORMAT_LIST - n, " %s ", word);
		else if (!first)
			n += (size_t)snprintf(buf + n, MESHFORMAT_LIST - n, "%s", comma);
		if (n < MESHFORMAT_LIST)
			n += (size_t)snprintf(buf + n, MESHFORMAT_LIST - n, "%s", s);
		first = 0;
		left--;
	}
	return buf;
}

char *
meshformat_names(unsigned can, const char *word, char buf[MESHFORMAT_LIST])
{
	return list(can, ", ", word, 0, buf);
}

char *
meshformat_ends(unsigned can, char buf[MESHFORMAT_LIST])
{
	return list(can, " ", "or", 1, buf);
}
