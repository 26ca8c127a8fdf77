/* test_readers.c - the readers of XYZ, MNI OBJ, Hoppe M, FreeSurfer, VTK, VTP and GIFTI: what they read, the facts
 * that they keep, what they refuse.  Files of formats with counts are also cut at every byte, and then refused. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <cmocka.h>

#include "../lib/meshfile/facts.h"
#include "../lib/meshfile/meshfile.h"
#include "meshreads.h"

/* Checks that the first n bytes and no fewer are read. */
static void
cut(const char *bytes, size_t n, size_t from)
{
	Soup s;

	for (; from < n; from++)
		if (parse(&s, bytes, from) == 0)
			fail_msg("%.20s: %zu of %zu bytes are read", bytes, from, n);
}

static void
has_facts(const char *bytes, size_t n, const char *facts)
{
	Soup s;

	if (parse(&s, bytes, n))
		fail_msg("%s", s.err);
	assert_string_equal(s.facts ? s.facts : "", facts);
	soup_free(&s);
}

static void
coordinate(const char *bytes, size_t n, int i, double x)
{
	Soup s;

	if (parse(&s, bytes, n))
		fail_msg("%s", s.err);
	assert_true(i < 3*s.nv && s.xyz[i] == x);
	soup_free(&s);
}

static void
xyz_rules(void **state)
{
	(void)state;
	reads("0 0 0\n1 0 0\n0 1 0", 3, "");
	reads("# c\r\n\r\n0.5 -1e3 .25 255 0 0 # c\r\n1 0 0 0 255 0\r\n", 2, "");
	coordinate("0 0 0\n1 2.5 0\n", 14, 4, 2.5);
	refuses("0 0 0\n1 0\n", MESH_EFORMAT, "line 2: point 1 has 2 numbers, the first has 3");
	refuses("0 0 0\n1 0 x\n", MESH_EFORMAT, "line 2: 'x' is not a coordinate");
	refuses("0 0 0\n1 0 nan\n", MESH_EVALUE, "vertex 1");
	refuses("1 2\n0 0 0\n", MESH_EFORMAT, "not an OFF, OBJ");
}

#define MNI "P 0.3 0.3 0.4 10 1 4\n0 0 0\n1 0 0\n0 1 0\n1 1 0.5\n\n0 0 1\n0 0 1\n0 0 1\n0 0 1\n\n 2\n"

static void
mni_rules(void **state)
{
	static const char file[] = MNI " 0 1 1 1 1\n\n 3 6\n\n 0 1 2 2 1 3\n";

	(void)state;
	reads(file, 4, "0 1 2/2 1 3");
	reads(MNI "1 1 1 1 1 0 0 0 0 4 6 0 1 2 3 0 1", 4, "0 1 2 3/0 1");
	reads(MNI "2 1 1 1 1 0 0 0 0 1 1 1 1 1 1 1 1 3 6 0 1 2 2 1 3", 4, "0 1 2/2 1 3");
	coordinate(file, sizeof file - 1, 11, 0.5);
	cut(file, sizeof file - 2, 0);
	refuses(MNI "3 1 1 1 1 3 6 0 1 2 2 1 3", MESH_EFORMAT, "kind of colours 3, not 0, 1 or 2");
	refuses(MNI "0 1 1 1 1 3 2 0 1 2 2 1 3", MESH_EFORMAT, "face 1 ends at corner 2, before it begins");
	refuses(MNI "0 1 1 1 1 3 7000 0 1 2 2 1 3", MESH_EFORMAT, "header announces 7000 corners");
	refuses(MNI "0 1 1 1 1 3 6 0 1 2 2 1 4", MESH_EINDEX, "face 1 refers to vertex 4, there are 4");
	refuses(MNI "0 1 1 1 1 3 6 0 1 2 2 1 3 4", MESH_EFORMAT, "'4' is not expected after the last face");
	refuses("P 0.3 0.3 0.4 10 1 2000000000\n0 0 0\n", MESH_EFORMAT, "header announces 2000000000 vertices");
	reads("v 0 0 0\np 1 1 1 1 1 1\n", 1, "");
}

static void
hoppe_rules(void **state)
{
	(void)state;
	reads("Vertex 1 0 0 0\nVertex 2 1 0 0 {normal=(0 0 1)}\nVertex 3 0 1 0\nFace 1 1 2 3\n", 3, "0 1 2");
	reads("# c\nVertex 70 0 0 0\nVertex 5 1 0 0\nFace 9 70 5 6 8 {matid=1}\nEdge 70 5 {sharp}\nVertex 6 1 1 0\n"
	    "Vertex 8 0 1 0\n", 4, "0 1 2 3");
	refuses("Vertex 1 0 0 0\nVertex 1 1 0 0\n", MESH_EFORMAT, "two vertices have the ID 1");
	refuses("Vertex 1 0 0 0\nFace 1 1 1 2\n", MESH_EINDEX, "face 0 refers to the ID 2, which no vertex has");
	refuses("Vertex 1 0 0\n", MESH_EFORMAT, "line 1: '' is not a coordinate");
	refuses("Vertex 1 0 0 0\nFace 1 1 x\n", MESH_EFORMAT, "line 2: 'x' is not the ID of a vertex");
	refuses("Vertex 1 0 0 0\nVertx 2\n", MESH_EFORMAT, "line 2: 'Vertx' is not Vertex, Face, Edge or Corner");
	refuses("Vertex 4294967297 0 0 0\n", MESH_EFORMAT, "is not an ID");
}

/* Three vertices (0,0,0), (1,0,0), (0,1,0), one face. */
#define FS_TEXT "\xff\xff\xfe" "created by x\n\n"
#define FS_ONE "\x3f\x80\0\0"
#define FS_ZERO "\0\0\0\0"
#define FS_MESH "\0\0\0\3\0\0\0\1" FS_ZERO FS_ZERO FS_ZERO FS_ONE FS_ZERO FS_ZERO FS_ZERO FS_ONE FS_ZERO "\0\0\0\0\0\0\0\1\0\0\0\2"
#define FS_GEOMETRY "\0\0\0\x14valid = 1  # volume info valid\nfilename = ../mri/T1.mgz\nvolume = 256 256 256\n" \
	"voxelsize = 1.0 1.0 1.0\nxras   = -1 0 0\nyras   = 0 0 -1\nzras   = 0 1 0\ncras   = 5.5 -17.25  18\n"
#define FS_FACTS "source FreeSurfer\nunit mm\nfs.valid 1 # volume info valid\nfs.filename ../mri/T1.mgz\nfs.volume 256 256 256\n" \
	"fs.voxelsize 1.0 1.0 1.0\nfs.xras -1 0 0\nfs.yras 0 0 -1\nfs.zras 0 1 0\nc_ras 5.5 -17.25 18\n"

static void
freesurfer_binary(void **state)
{
	static const char plain[] = FS_TEXT FS_MESH, one[] = "\xff\xff\xfe" "x\n" FS_MESH;
	static const char tkras[] = FS_TEXT FS_MESH "\0\0\0\2\0\0\0\0" FS_GEOMETRY;
	static const char scanner[] = FS_TEXT FS_MESH "\0\0\0\3\0\0\0\0\0\0\0\2ab" "\0\0\0\2\0\0\0\1" FS_GEOMETRY "\0\0\0\3";
	static const char invalid[] = FS_TEXT FS_MESH "\0\0\0\x14valid = 0\n";
	static const char odd[] = FS_TEXT FS_MESH "\0\0\0\x14valid = 1\n\xb6 = 7\nvolume 1\n= 3\nxras = =\ny\nz\n\n";
	static const char many[] = FS_TEXT "\x7f\xff\xff\xff\0\0\0\1", index[] = FS_TEXT "\0\0\0\1\0\0\0\1" FS_ZERO FS_ZERO
	    FS_ZERO FS_ZERO FS_ZERO "\xff\xff\xff\xff";
	Soup s;

	(void)state;
	reads_bytes(plain, sizeof plain - 1, 3, "0 1 2");
	reads_bytes(one, sizeof one - 1, 3, "0 1 2");
	coordinate(plain, sizeof plain - 1, 3, 1);
	cut(plain, sizeof plain - 1, 0);
	has_facts(plain, sizeof plain - 1, "source FreeSurfer\nunit mm\nspace tkras\n");
	has_facts(tkras, sizeof tkras - 1, FS_FACTS "space tkras\n");
	has_facts(scanner, sizeof scanner - 1, FS_FACTS "space scanner\n");
	has_facts(invalid, sizeof invalid - 1, "source FreeSurfer\nunit mm\nspace tkras\n");
	has_facts(odd, sizeof odd - 1, "source FreeSurfer\nunit mm\nfs.valid 1\nfs.xras =\nspace tkras\n");
	coordinate(tkras, sizeof tkras - 1, 3, 1);      /* not moved by c_ras */
	assert_int_equal(parse(&s, many, sizeof many - 1), MESH_EFORMAT);
	assert_non_null(strstr(s.err, "header announces 2147483647 vertices, file has room for 0"));
	assert_int_equal(parse(&s, index, sizeof index - 1), MESH_EINDEX);
	assert_int_equal(parse(&s, tkras, sizeof tkras - 10), MESH_EFORMAT);
	assert_non_null(strstr(s.err, "file ends in line 7 of the volume geometry"));
}

static void
freesurfer_ascii(void **state)
{
	static const char file[] = "#!ascii version of lh.pial\n3 1\n0 0 0  0\n1 0 0  0\n0 1 0  0\n0 1 2 0\n";

	(void)state;
	reads(file, 3, "0 1 2");
	cut(file, sizeof file - 3, 0);
	has_facts(file, sizeof file - 1, "source FreeSurfer\nunit mm\nspace tkras\n");
	refuses("#!ascii version of patch lh.flat\n3 1\n#12\n", MESH_EFORMAT, "FreeSurfer ASCII patch is not read");
	refuses("#!ascii version of x\n3 x\n", MESH_EFORMAT, "line 2, count 1: 'x' is not a whole number");
	refuses("#!ascii version of x\n1 1\n0 0 0 0\n0 0 1 0\n", MESH_EINDEX, "face 0 refers to vertex 1, there are 1");
	refuses("#!ascii version of x\n1 1\n0 0 0 0\n0 0 0 0 7\n", MESH_EFORMAT, "'7' is not expected after the last face");
}

/* ---- VTK ---- */

#define VTK(version, kind) "# vtk DataFile Version " version "\ntitle\n" kind "\nDATASET POLYDATA\n"
#define FOUR "POINTS 4 float\n0 0 0\n1 0 0\n0 1 0  1 1 0.5\n"

static void
vtk_ascii(void **state)
{
	static const char old[] = VTK("1.0", "ASCII") FOUR "POLYGONS 2 8\n3 0 1 2\n3 2 1 3\n";
	static const char new[] = VTK("5.1", "ASCII") FOUR "METADATA\nINFORMATION 0\n\nPOLYGONS 3 6\nOFFSETS vtktypeint64\n0 3 6\n"
	    "CONNECTIVITY vtktypeint64\n0 1 2\n2 1 3";

	(void)state;
	reads(old, 4, "0 1 2/2 1 3");
	coordinate(old, sizeof old - 1, 11, 0.5);
	cut(old, sizeof old - 2, (size_t)(strstr(old, "POLYGONS") - old) + 1);
	reads(new, 4, "0 1 2/2 1 3");
	cut(new, sizeof new - 1, (size_t)(strstr(new, "POLYGONS") - new) + 1);
	reads(VTK("3.0", "ASCII") FOUR "VERTICES 1 2 1 0\nLINES 1 3 2 0 1\nTRIANGLE_STRIPS 1 5 4 0 1 2 3\n", 4, "0 1 2/2 1 3");
	reads(VTK("4.2", "ASCII") FOUR "POLYGONS 1 5 4 0 1 3 2\nPOINT_DATA 4\nSCALARS a float\nLOOKUP_TABLE default\n1 2 3 4\n"
	    "VECTORS b double 1 2 3 4 5 6 7 8 9 10 11 12\nCELL_DATA 1\nFIELD f 2\nc 1 1 int\n7\nd 2 1 float\n1 2\n", 4, "0 1 3 2");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 5 4 0 1 3\n", MESH_EFORMAT, "file ends in face 0 of 1");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 4 4 0 1 3 2\n", MESH_EFORMAT, "need 0 to 3");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 5 3 0 1 2\n7", MESH_EFORMAT, "face: 5 values announced, 4 used");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 4 3 0 1 4\n", MESH_EINDEX, "face 0 refers to vertex 4, there are 4");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 4 3 0 1 -4\n", MESH_EINDEX, "face 0 refers to vertex -4");
	refuses(VTK("3.0", "ASCII") "POINTS 2000000000 float\n", MESH_EFORMAT, "header announces 2000000000 points");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGONS 1 2000000000\n3", MESH_EFORMAT, "header announces 2000000000 values of cells");
	refuses(VTK("5.1", "ASCII") FOUR "POLYGONS 3 6\nOFFSETS int\n0 4 3\nCONNECTIVITY int\n0 1 2 2 1 3", MESH_EFORMAT,
	    "face 2 of 3 has the size or offset 3, need 6 to 6");
	refuses(VTK("3.0", "ASCII") "POINTS 1 bit\n0 0 0", MESH_EFORMAT, "line 5: 'bit' is not a type of numbers that is read");
	refuses("# vtk DataFile Version 3.0\nt\nASCII\nDATASET UNSTRUCTURED_GRID\n", MESH_EFORMAT,
	    "line 4: DATASET UNSTRUCTURED_GRID is not read, only POLYDATA");
	refuses(VTK("3.0", "ASCII") FOUR "POLYGON 1", MESH_EFORMAT, "'POLYGON' is not a keyword");
	refuses(VTK("3.0", "ASCI"), MESH_EFORMAT, "line 3: 'ASCI' is not ASCII or BINARY");
}

static void
vtk_binary(void **state)
{
	static const char old[] = VTK("3.0", "BINARY") "POINTS 3 float\n" FS_ZERO FS_ZERO FS_ZERO FS_ONE FS_ZERO FS_ZERO FS_ZERO
	    FS_ONE FS_ZERO "\nPOLYGONS 1 4\n" "\0\0\0\3\0\0\0\0\0\0\0\1\0\0\0\2" "\nCELL_DATA 1\nNORMALS n float\n" FS_ZERO FS_ZERO FS_ONE;
	static const char new[] = VTK("5.1", "BINARY") "POINTS 3 float\n" FS_ZERO FS_ZERO FS_ZERO FS_ONE FS_ZERO FS_ZERO FS_ZERO
	    FS_ONE FS_ZERO "\nPOLYGONS 2 3\nOFFSETS vtktypeint64\n" FS_ZERO FS_ZERO FS_ZERO "\0\0\0\3\nCONNECTIVITY vtktypeint32\n"
	    "\0\0\0\0\0\0\0\1\0\0\0\2";

	static const char below[] = VTK("3.0", "BINARY") "POINTS 1 float\n" FS_ZERO FS_ZERO FS_ZERO "\nPOLYGONS 1 2\n"
	    "\0\0\0\1\xff\xff\xff\xfe";

	(void)state;
	reads_bytes(old, sizeof old - 1, 3, "0 1 2");
	coordinate(old, sizeof old - 1, 3, 1);
	reads_bytes(new, sizeof new - 1, 3, "0 1 2");
	cut(old, sizeof old - 1, sizeof old - 25);
	cut(new, sizeof new - 1, sizeof new - 70);
	refuses_bytes(below, sizeof below - 1, MESH_EINDEX, "face 0 refers to vertex -2");
}

/* ---- GIFTI ---- */

#define GIFTI(n) "<?xml version=\"1.0\"?>\n<!DOCTYPE GIFTI SYSTEM \"gifti.dtd\">\n<GIFTI Version=\"1.0\" NumberOfDataArrays=\"" n "\">\n"
#define GII(intent, type, order, dim, encoding, endian, inside) "<DataArray Intent=\"NIFTI_INTENT_" intent \
	"\" DataType=\"NIFTI_TYPE_" type "\" ArrayIndexingOrder=\"" order "\" Dim0=\"" dim "\" Dim1=\"3\" Encoding=\"" encoding \
	"\" Endian=\"" endian "\" ExternalFileName=\"x.bin\">" inside "</DataArray>\n"
#define GII_POINTS(encoding, data) GII("POINTSET", "FLOAT32", "RowMajorOrder", "4", encoding, "LittleEndian", "<Data>" data "</Data>")
#define GII_FACES(encoding, data) GII("TRIANGLE", "INT32", "RowMajorOrder", "2", encoding, "LittleEndian", "<Data>" data "</Data>")
#define P_ASCII "0 0 0\n1 0 0\n0 1 0\n1 1 .5\n"
#define F_ASCII "0 1 2 2 1 3"
/* The same as bytes, by Python's base64 and zlib. */
#define P_BASE64 "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAA\nAACAPwAAgD8AAAA/\n"
#define F_BASE64 "AAAAAAEAAAACAAAAAgAAAAEAAAADAAAA"
#define P_GZIP "eJxjYEAGDfYMWPkgGsy2BwAyLwM8"
#define F_GZIP "eJxjYGBgYARiJigGsZmBGAAAeAAK"

static void
gifti_rules(void **state)
{
	static const char file[] = GIFTI("2") GII_POINTS("GZipBase64Binary", P_GZIP) GII_FACES("Base64Binary", F_BASE64) "</GIFTI>\n";
	static const char column[] = GIFTI("3") "<DataArray Intent=\"NIFTI_INTENT_SHAPE\"><Data>x</Data></DataArray>"
	    GII("TRIANGLE", "INT32", "ColumnMajorOrder", "2", "ASCII", "BigEndian", "<Data>0 2 1 1 2 3</Data>")
	    GII_POINTS("ASCII", P_ASCII) "</GIFTI>";
	static const char points[] = GIFTI("2") GII("POINTSET", "FLOAT32", "ColumnMajorOrder", "4", "ASCII", "LittleEndian",
	    "<Data>0 1 0 1  0 0 1 1  0 0 0 .5</Data>") GII_FACES("ASCII", F_ASCII) "</GIFTI>";

	(void)state;
	reads(GIFTI("2") GII_POINTS("ASCII", P_ASCII) GII_FACES("ASCII", F_ASCII) "</GIFTI>", 4, "0 1 2/2 1 3");
	reads(GIFTI("2") GII_POINTS("Base64Binary", P_BASE64) GII_FACES("GZipBase64Binary", F_GZIP) "</GIFTI>", 4, "0 1 2/2 1 3");
	reads(file, 4, "0 1 2/2 1 3");
	reads(column, 4, "0 1 2/2 1 3");
	coordinate(file, sizeof file - 1, 11, 0.5);
	coordinate(column, sizeof column - 1, 11, 0.5);
	cut(file, sizeof file - 2, 0);
	has_facts(file, sizeof file - 1, "source GIFTI\nunit mm\n");
	reads(points, 4, "0 1 2/2 1 3");
	coordinate(points, sizeof points - 1, 10, 1);
	coordinate(points, sizeof points - 1, 11, 0.5);
}

#define SPACE "<MetaData><MD><Name><![CDATA[VolGeomC_R]]></Name><Value><![CDATA[5.5]]></Value></MD><MD><Name>VolGeomC_A</Name>" \
	"<Value>-17</Value></MD><MD><Name>VolGeomC_S</Name><Value>18</Value></MD></MetaData><CoordinateSystemTransformMatrix>" \
	"<DataSpace><![CDATA[NIFTI_XFORM_TALAIRACH]]></DataSpace><TransformedSpace>X</TransformedSpace><MatrixData>2 0 0 9 0 2 0 9 " \
	"0 0 2 9 0 0 0 1</MatrixData></CoordinateSystemTransformMatrix><Data>" P_ASCII "</Data>"

static void
gifti_space(void **state)
{
	static const char file[] = GIFTI("2") GII("POINTSET", "FLOAT32", "RowMajorOrder", "4", "ASCII", "LittleEndian", SPACE)
	    GII_FACES("ASCII", F_ASCII) "</GIFTI>";

	(void)state;
	has_facts(file, sizeof file - 1, "source GIFTI\nunit mm\nspace NIFTI_XFORM_TALAIRACH\nc_ras 5.5 -17 18\n");
	coordinate(file, sizeof file - 1, 3, 1);        /* the transform is not applied */
}

static void
gifti_refused(void **state)
{
	(void)state;
	refuses(GIFTI("3") GII_POINTS("ASCII", P_ASCII) GII_FACES("ASCII", F_ASCII) "</GIFTI>", MESH_EFORMAT,
	    "NumberOfDataArrays is 3, the file has 2");
	refuses(GIFTI("1") GII_POINTS("ASCII", P_ASCII) "</GIFTI>", MESH_EFORMAT, "no surface: no array of triangles");
	refuses(GIFTI("1") "<DataArray Intent=\"NIFTI_INTENT_SHAPE\"><DataArray/></DataArray></GIFTI>", MESH_EFORMAT,
	    "array 0 has another in it");
	refuses(GIFTI("1") GII_POINTS("ASCII", "0 1 2"), MESH_EFORMAT, "header announces 12 coordinates");
	refuses(GIFTI("1") GII_POINTS("ASCII", P_ASCII "7"), MESH_EFORMAT, "coordinates: more than 12 numbers");
	refuses(GIFTI("1") GII_POINTS("Base64Binary", "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAAAAgD8AAAAAAACAPwAAgD8AAAA="),
	    MESH_EFORMAT, "coordinates: data end early");
	refuses(GIFTI("1") GII_POINTS("Base64Binary", P_BASE64 "AAAA"), MESH_EFORMAT, "more than 48 bytes");
	refuses(GIFTI("1") GII_POINTS("Base64Binary", "AAAAAAAAAAAAAAAAAACAPwAAAAAAAAAAAAAAAA*AgD8AAAAAAACAPwAAgD8AAAA/"),
	    MESH_EFORMAT, "byte 0x2a is no base64");
	refuses(GIFTI("1") GII_POINTS("GZipBase64Binary", "eJxjYEAGDfYMWPkgGsy2BwAyLwM9"), MESH_EFORMAT, "zlib data are damaged");
	refuses(GIFTI("1") GII_POINTS("GZipBase64Binary", F_GZIP), MESH_EFORMAT, "zlib data are damaged, or not of 48 bytes");
	refuses(GIFTI("1") GII("POINTSET", "FLOAT32", "RowMajorOrder", "2000000000", "GZipBase64Binary", "LittleEndian",
	    "<Data>" P_GZIP "</Data>"), MESH_EFORMAT, "header announces 6000000000 coordinates");
	refuses(GIFTI("1") GII_POINTS("ExternalFileBinary", ""), MESH_EFORMAT, "array 0 is in another file, 'x.bin', which cannot be found");
	refuses(GIFTI("1") GII("POINTSET", "FLOAT32", "RowMajorOrder", "0", "ASCII", "LittleEndian", "") "</GIFTI>", MESH_EFORMAT,
	    "no array of coordinates");
	refuses(GIFTI("1") GII("POINTSET", "COMPLEX64", "RowMajorOrder", "4", "ASCII", "LittleEndian", ""), MESH_EFORMAT,
	    "array 0: DataType=\"NIFTI_TYPE_COMPLEX64\" is not read");
	refuses(GIFTI("2") GII_POINTS("ASCII", P_ASCII) GII_POINTS("ASCII", P_ASCII), MESH_EFORMAT, "more than one array of points");
	refuses(GIFTI("2") GII_POINTS("ASCII", P_ASCII) GII_FACES("ASCII", "0 1 2 2 1 4") "</GIFTI>", MESH_EINDEX,
	    "face 1 refers to vertex 4, there are 4");
	refuses(GIFTI("2") GII_POINTS("ASCII", P_ASCII) GII_FACES("Base64Binary", "AAAAAAEAAAACAAAAAgAAAAEAAAD/////") "</GIFTI>",
	    MESH_EINDEX, "face 1 refers to vertex -1, there are 4");
	refuses(GIFTI("2") GII_POINTS("ASCII", P_ASCII) GII_FACES("ASCII", "0 1 2 2 1 2.5") "</GIFTI>", MESH_EFORMAT,
	    "face 1 has a corner 2.5");
	refuses("<?xml version=\"1.0\"?><!DOCTYPE GIFTI [<!ENTITY a \"b\">]><GIFTI>", MESH_EFORMAT, "XML entities are not read");
	refuses(GIFTI("2") "</GIFT>", MESH_EFORMAT, "line 4: XML: mismatched tag");
}

/* ---- VTP ---- */

#define VTP(attributes) "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" byte_order=\"LittleEndian\" " attributes "><PolyData>"
#define VTP_ARRAY(type, name, format, data) "<DataArray type=\"" type "\" Name=\"" name "\" format=" format ">" data "</DataArray>"
#define VTP_PIECE(format, points, corners, offsets) "<Piece NumberOfPoints=\"4\" NumberOfPolys=\"2\"><PointData>" \
	VTP_ARRAY("UInt8", "ids", format, points) "</PointData><Points>" VTP_ARRAY("Float32", "Points", format, points) \
	"</Points><Polys>" VTP_ARRAY("Int32", "connectivity", format, corners) VTP_ARRAY("Int32", "offsets", format, offsets) \
	"</Polys></Piece>"
#define VTP_END "</PolyData></VTKFile>\n"
#define A "\"ascii\""
#define B "\"binary\""

static void
vtp_rules(void **state)
{
	static const char plain[] = VTP("") VTP_PIECE(B, "MAAAAAAAAAAAAAAAAAAAAAAAgD8AAAAAAAAAAAAAAAAAAIA/AAAAAAAAgD8AAIA/AAAAPw==",
	    "GAAAAAAAAAABAAAAAgAAAAIAAAABAAAAAwAAAA==", "CAAAAAMAAAAGAAAA") VTP_END;
	static const char packed[] = VTP("header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"") VTP_PIECE(B,
	    "AgAAAAAAAAAYAAAAAAAAAAAAAAAAAAAADwAAAAAAAAATAAAAAAAAAA==eJxjYEAGDfYwFgAHTwDAeJxjYACBBnsGOA1m2wMAGPgCfQ==",
	    "AgAAAAAAAAAMAAAAAAAAAAAAAAAAAAAAEQAAAAAAAAARAAAAAAAAAA==eJxjYGBgYARiJiAGAAAcAAR4nGNiYGBgBGJmIAYAADgABw==",
	    "AQAAAAAAAAAIAAAAAAAAAAAAAAAAAAAADgAAAAAAAAA=eJxjZmBgYANiAAA4AAo=") VTP_END;
	/* Points in two blocks, of 40 and 8 bytes. */
	static const char uneven[] = VTP("header_type=\"UInt64\" compressor=\"vtkZLibDataCompressor\"") VTP_PIECE(B,
	    "AgAAAAAAAAAoAAAAAAAAAAgAAAAAAAAAEgAAAAAAAAAQAAAAAAAAAA=="
	    "eJxjYEAGDfYMWPkN9gAbxQI+eJxjYGiwZ2BgsAcABIIA/w==",
	    "AgAAAAAAAAAMAAAAAAAAAAAAAAAAAAAAEQAAAAAAAAARAAAAAAAAAA==eJxjYGBgYARiJiAGAAAcAAR4nGNiYGBgBGJmIAYAADgABw==",
	    "AQAAAAAAAAAIAAAAAAAAAAAAAAAAAAAADgAAAAAAAAA=eJxjZmBgYANiAAA4AAo=") VTP_END;
	static const char ascii[] = VTP("") VTP_PIECE(A, P_ASCII, F_ASCII, "3 6") VTP_END;

	(void)state;
	reads(ascii, 4, "0 1 2/2 1 3");
	reads(plain, 4, "0 1 2/2 1 3");
	reads(packed, 4, "0 1 2/2 1 3");
	coordinate(packed, sizeof packed - 1, 11, 0.5);
	reads(uneven, 4, "0 1 2/2 1 3");
	coordinate(uneven, sizeof uneven - 1, 11, 0.5);
	cut(ascii, sizeof ascii - 2, 0);
	cut(packed, sizeof packed - 2, 0);
	reads(VTP("") VTP_PIECE(A, P_ASCII, F_ASCII, "3 6") VTP_PIECE(A, P_ASCII "<InformationKey name=\"a\">0</InformationKey>",
	    "0 1 3 2", "4 4") VTP_END, 8, "0 1 2/2 1 3/4 5 7 6");
	reads(VTP("") "<Piece NumberOfPoints=\"4\" NumberOfStrips=\"1\"><Points>" VTP_ARRAY("Float64", "Points", A, P_ASCII)
	    "</Points><Strips>" VTP_ARRAY("Int64", "connectivity", A, "0 1 2 3") VTP_ARRAY("Int64", "offsets", A, "4")
	    "</Strips></Piece>" VTP_END, 4, "0 1 2/2 1 3");
	refuses(VTP("") VTP_PIECE(A, P_ASCII, F_ASCII, "3 7") VTP_END, MESH_EFORMAT, "corners");
	refuses(VTP("") VTP_PIECE(A, P_ASCII, F_ASCII, "3 2") VTP_END, MESH_EFORMAT, "offset 1 is 2, less than the one before");
	refuses(VTP("") VTP_PIECE(A, P_ASCII, "0 1 2 2 1 4", "3 6") VTP_END, MESH_EINDEX, "face 1 refers to vertex 4, there are 4");
	refuses(VTP("") VTP_PIECE(B, "MAAAAAAAAAAA", "", ""), MESH_EFORMAT, "header announces 12 coordinates");
	refuses("<VTKFile type=\"UnstructuredGrid\">", MESH_EFORMAT, "VTK XML type UnstructuredGrid is not read, only PolyData");
	refuses(VTP("compressor=\"vtkLZ4DataCompressor\"") VTP_END, MESH_EFORMAT, "data packed by vtkLZ4DataCompressor is not read");
	refuses(VTP("") VTP_END, MESH_EFORMAT, "no Piece of PolyData");
}

#define TAIL(offset) "\"appended\" offset=\"" offset "\""

/* Raw bytes in a file are no XML: they may hold any. */
static void
vtp_appended(void **state)
{
	static const char head[] = VTP("header_type=\"UInt32\"") "<Piece NumberOfPoints=\"3\" NumberOfPolys=\"1\"><Points>"
	    VTP_ARRAY("Float32", "Points", TAIL("0"), "") "</Points><Polys>" VTP_ARRAY("Int32", "connectivity", TAIL("40"), "")
	    VTP_ARRAY("Int32", "offsets", TAIL("56"), "") "</Polys></Piece></PolyData><AppendedData encoding=\"raw\">\n_";
	static const char data[] = "\x24\0\0\0" FS_ZERO FS_ZERO FS_ZERO "</X>" FS_ZERO FS_ZERO FS_ZERO "<&><" FS_ZERO
	    "\x0c\0\0\0" "\0\0\0\0\1\0\0\0\2\0\0\0" "\4\0\0\0" "\3\0\0\0";
	static const char tail[] = "\n</AppendedData></VTKFile>\n";
	char file[sizeof head + sizeof data + sizeof tail];
	const size_t nh = sizeof head - 1, nd = sizeof data - 1, n = nh + nd + sizeof tail - 1;

	(void)state;
	memcpy(file, head, nh);
	memcpy(file + nh, data, nd);
	memcpy(file + nh + nd, tail, sizeof tail);
	reads_bytes(file, n, 3, "0 1 2");
	cut(file, n - 1, nh - 30);
	file[nh] = 0x25;                                /* one byte more than nine floats */
	refuses_bytes(file, n, MESH_EFORMAT, "coordinates: has 37 bytes, need 36");
}

/* Many pieces with the same appended bytes would fill the memory. */
static void
vtp_shared_bytes(void **state)
{
	static char file[40000];
	size_t n = (size_t)sprintf(file, "%s", VTP("header_type=\"UInt32\""));
	size_t head;
	int i;

	(void)state;
	for (i = 0; i < 100; i++)
		n += (size_t)sprintf(file + n, "%s", "<Piece NumberOfPoints=\"300\"><Points>"
		    VTP_ARRAY("Float32", "Points", TAIL("0"), "") "</Points></Piece>");
	n += (size_t)sprintf(file + n, "</PolyData><AppendedData encoding=\"raw\">_");
	head = n;
	n += 4 + 300*12;
	file[head] = 300*12 & 255, file[head + 1] = 300*12 >> 8;
	n += (size_t)sprintf(file + n, "</AppendedData></VTKFile>");
	refuses_bytes(file, n, MESH_EFORMAT, "coordinates: arrays share their bytes");
}

static void
facts_line_by_line(void **state)
{
	const char *p = "space tkras\nc_ras 1 2 3\n";
	char key[FACT_KEY], value[FACT_VALUE];

	(void)state;
	assert_non_null(p = fact_next(p, key, value));
	assert_string_equal(key, "space");
	assert_string_equal(value, "tkras");
	assert_non_null(p = fact_next(p, key, value));
	assert_string_equal(key, "c_ras");
	assert_string_equal(value, "1 2 3");
	assert_null(fact_next(p, key, value));
	assert_null(fact_next(NULL, key, value));
}

/* Comments of OBJ and PLY hold facts of known keys, up to a size. */
static void
facts_in_comments(void **state)
{
	static const char obj[] = "# lhgrid fact space  tkras \n#lhgrid fact unit m\n# lhgrid fact nv 7\n# lhgrid fact fs.x\nv 0 0 0\n";
	static const char ply[] = "ply\nformat ascii 1.0\ncomment lhgrid fact c_ras 1 2\t3\ncomment lhgrid fact fs.A 3\n"
	    "element vertex 1\nproperty float x\nproperty float y\nproperty float z\nend_header\n0 0 0\n";
	static char many[20000];
	size_t n = 0;
	Soup s;
	int i;

	(void)state;
	has_facts(obj, sizeof obj - 1, "space tkras\n");
	has_facts(ply, sizeof ply - 1, "c_ras 1 2 3\n");
	for (i = 0; i < 500; i++)
		n += (size_t)sprintf(many + n, "# lhgrid fact fs.key %08d\n", i);
	n += (size_t)sprintf(many + n, "v 0 0 0\n");
	assert_int_equal(parse(&s, many, n), 0);
	assert_true(strlen(s.facts) > FACTS_MOST - 100 && strlen(s.facts) < FACTS_MOST);
	soup_free(&s);
}

int
main(void)
{
	const struct CMUnitTest tests[] = {
		cmocka_unit_test(xyz_rules), cmocka_unit_test(mni_rules), cmocka_unit_test(hoppe_rules),
		cmocka_unit_test(freesurfer_binary), cmocka_unit_test(freesurfer_ascii),
		cmocka_unit_test(vtk_ascii), cmocka_unit_test(vtk_binary),
		cmocka_unit_test(gifti_rules), cmocka_unit_test(gifti_space), cmocka_unit_test(gifti_refused),
		cmocka_unit_test(vtp_rules), cmocka_unit_test(vtp_appended), cmocka_unit_test(vtp_shared_bytes),
		cmocka_unit_test(facts_line_by_line), cmocka_unit_test(facts_in_comments)
	};

	return cmocka_run_group_tests(tests, NULL, NULL);
}
