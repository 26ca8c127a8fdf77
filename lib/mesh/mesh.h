/* mesh.h - surfaces as arrays: the polygon soup of a file, a triangle mesh, and a disk, which is
 * what can be mapped onto a rectangle.
 *
 * Vertices and faces are counted from 0 here and in messages.
 */
#ifndef MESH_H
#define MESH_H

#include <stddef.h>

enum {
	MESH_ENOMEM  = -1,
	MESH_EFORMAT = -2,      /* unknown file format, or damaged file; err says where */
	MESH_EINDEX  = -3,      /* a face refers to a vertex that does not exist */
	MESH_EVALUE  = -4,      /* a coordinate is NaN or infinite */
	MESH_EFACE   = -5,      /* a face cannot be split into triangles with area */
	MESH_EMANIFOLD = -6,    /* an edge of three faces, or a vertex of several fans */
	MESH_EORIENT = -7,      /* one-sided: no consistent orientation */
	MESH_EDISK   = -8       /* not a disk: closed, several loops or components, or handles */
};

enum { MESH_ERRLEN = 256 };

enum { CHANNEL_NAME = 64 };
#define MESH_UV "uv"            /* the channel of places in the rectangle [0,1] x [0,T], two numbers;
                                 * (-1,-1) where a vertex has none */
#define MESH_OFFSET "offset"    /* the channel of offsets from a gridded surface at these places, four
				 * numbers: see lib/grid/detail.h */
#define MESH_SOURCE "source"    /* the channel of numbers that vertices had in another file; -1: none */

/* The type of the numbers of a channel in the file that they come from. */
typedef enum ChannelType {
	CHANNEL_ANY,            /* not known: written as doubles, colours as bytes */
	CHANNEL_INT8, CHANNEL_UINT8, CHANNEL_INT16, CHANNEL_UINT16, CHANNEL_INT32, CHANNEL_UINT32,
	CHANNEL_FLOAT, CHANNEL_DOUBLE
} ChannelType;

/* Numbers at every vertex, beside its position. */
typedef struct Channel {
	char    name[CHANNEL_NAME];
	ChannelType type;
	int     n;              /* numbers at each vertex: 1 for a scalar, 3 for a colour */
	double *f;              /* [nv][n] */
} Channel;

typedef struct Channels {
	int      n;
	Channel *channel;       /* [n] */
} Channels;

/* Polygons as a file has them; lengths are in the unit of the file.  Face f has the corners
 * idx[first[f]] .. idx[first[f+1]-1]. */
typedef struct Soup {
	int     nv, nf;
	double *xyz;            /* [nv][3] */
	int    *first;          /* [nf+1] */
	int    *idx;
	char    err[MESH_ERRLEN];
	Channels channels;
	double  T;              /* height of the chart of MESH_UV; 0: not known */
	const struct ChartKind *chart;  /* its kind; NULL: not known */
	unsigned char *filled;  /* [nf] 1: the face fills a hole; NULL: not known */
	const char *remarks;    /* lines for comments of the file that is written, or NULL; not freed
	                         * with the soup */
	char   *left_out;       /* the numbers of the file that have no place here, as a list for a message, such as "list
	                         * weights at vertices, flags at faces"; NULL: none, or not asked for */
	char   *facts;          /* what the file says of its coordinates: a line "key value\n" for each
	                         * fact, printable ASCII (lib/meshfile/facts.h); NULL: nothing */
} Soup;

typedef struct Mesh {
	int     nv, nf;
	double *xyz;            /* [nv][3] */
	int    *tri;            /* [nf][3], counterclockwise seen from where the normal points */
} Mesh;

/* A connected, oriented manifold mesh with one boundary loop and no handle; every vertex belongs to
 * a face. */
typedef struct Disk {
	Mesh m;
	int  nb;
	int *loop;              /* [nb] the boundary, counterclockwise (faces on its left),
	                         * beginning at its lowest vertex number */
	int *twin;              /* [3*m.nf] the side of the neighbour, -1 on the boundary; side 3*t+k goes
	                         * from corner k of triangle t to the next */
	int *file;              /* [m.nv] the number of each vertex in its soup: the lowest one if
	                         * several were welded, -1 if the vertex was added later */
	int  nfile;
	int *became;            /* [nfile] the vertex of m for each vertex of the soup, -1: none */
	Channels channels;      /* of the soup, at the vertices of m */
	char note[MESH_ERRLEN]; /* the repairs, "" if none */
	char err[MESH_ERRLEN];
} Disk;

void soup_free(Soup *s);
void mesh_free(Mesh *m);
void disk_free(Disk *d);

/* The sum of the areas of all triangles. */
double mesh_area(const Mesh *m);

/* Twice the signed area in (u,v) of the triangle with corners c: negative if it is turned over. */
static inline double
mesh_image(const int c[3], const double *u, const double *v)
{
	return (u[c[1]] - u[c[0]])*(v[c[2]] - v[c[0]]) - (u[c[2]] - u[c[0]])*(v[c[1]] - v[c[0]]);
}

#endif
