/* mend.h - makes a disk, or a closed surface, from the polygons of a file, and reports the changes. */
#ifndef MEND_H
#define MEND_H

#include "../mesh/mesh.h"

enum { MEND_FLAT, MEND_C1, MEND_C2 };           /* how holes are filled: fair.h */
enum { MEND_CLOSED, MEND_OPEN_AT, MEND_OPEN_AUTO };

typedef struct MendOptions {
	double weld;            /* distance at which boundary vertices become one; 0: equal positions;
	                         * MEND_WELD_AUTO, MEND_WELD_NONE */
	int    components;      /* keep the largest so many, by area; 0: all */
	int    keep_holes;      /* 1: fill none */
	int    fill_all;        /* 1: fill the longest loop of each component, too */
	double max_hole;        /* longest loop to fill, as a share of the length of all loops of its
	                         * component */
	int    fill;            /* MEND_FLAT, MEND_C1 or MEND_C2 */
	int    cut_handles;     /* 0: handles are refused */
	int    open;            /* how closed surfaces are treated: MEND_ value */
	double at[3];           /* MEND_OPEN_AT: the cut begins at the vertex nearest to this point */
	int    check;           /* 1: go on after what would be refused, to report all */
} MendOptions;

#define MEND_WELD_AUTO -1.0     /* a millionth of the diagonal of the bounding box */
#define MEND_WELD_NONE -2.0

typedef struct MendPiece {
	int    nv, nf, loops, genus;
	double area;
	int    kept;
} MendPiece;

typedef struct MendLoop {
	int    at, n;           /* a vertex of the soup on it, and its number of vertices */
	double length;
} MendLoop;

/* The faults found and the changes made.  Vertices and faces are numbered as in the soup.  A field x_at
 * is -1 if x is 0. */
typedef struct MendReport {
	double lo[3], hi[3];    /* of the vertices that faces use */
	int    unused;          /* vertices of no face, dropped */
	int    missing, missing_at;     /* faces dropped with a corner that is no vertex; the first */
	int    infinite, infinite_at;   /* faces dropped at vertices that are not finite; the first such */
	int    broken, broken_at;       /* faces without three different corners, dropped; the first */
	int    twice, twice_at;         /* triangles on the places of another, dropped */
	int    coincident;      /* boundary vertices at the place of another */
	double nearest;         /* least distance above 0 of boundary vertices that share no face, up to
	                         * a thousandth of the diagonal; -1: none */
	int    close;           /* boundary vertices within a millionth of the diagonal of another, but
	                         * not at its place */
	double within;          /* a millionth of the diagonal */
	double weld;            /* the distance used */
	int    welded;          /* vertices that became one with another */
	int    many, many_at[2];        /* edges of three or more faces; the first */
	int    parted;          /* vertices added where fans were parted */
	int    flaps;           /* faces dropped, as a surface cannot hold them */
	int    npiece;
	MendPiece *piece;       /* [npiece] all components, by area, largest first */
	double area;            /* of all components */
	int    turned;          /* faces turned */
	int    one_sided;       /* 1: a component kept is one-sided */
	int    collapsed, flipped, dropped, flat_left, flat_at; /* faces without area: flat.h */
	int    short_at[2];     /* the ends of the first edge that was so short; else -1 */
	int    seams;           /* edges split at vertices that lie on them */
	int    nloop;
	MendLoop *loop;         /* [nloop] of the components kept, longest first */
	int    holes, faces, vertices;  /* filled, and made by filling */
	double longest;         /* of the holes filled */
	int    order;           /* MEND_ value that was used to fill */
	int    holes_left, left_at;     /* not triangulated */
	int    holes_kept;      /* longer than max_hole, or keep_holes */
	int    genus;           /* handles of the components kept */
	int    handles;         /* cut */
	double handle_length;   /* of all cuts together */
	int    closed;          /* components without boundary, at the end */
	int    opened;          /* closed components that were cut open */
	double cut;             /* length of these cuts */
	int    disks;           /* components of the result that are disks */
	int    left;            /* components of the result */
} MendReport;

/* The default of every option. */
#define MEND_DEFAULTS ((MendOptions){ .components = 1, .max_hole = 1, .fill = MEND_C2 })

/* Makes out from s: triangles, channel MESH_SOURCE (the number of each vertex in s, or its own MESH_SOURCE
 * if s has one; -1: made here), the channels of s (values.h where a vertex was made), and out->filled.  Vertices
 * that are kept have their positions bit by bit, and the order that they have in s.  Vertices made by
 * parting fans, by cuts and by filling holes follow.
 *
 * A disk without two boundary vertices at one place keeps its vertices and faces.
 *
 * s is only read; its coordinates need not be finite, and its corners need not be numbers of vertices.
 * Returns 0; or MESH_ENOMEM, MESH_EORIENT or MESH_EDISK, with the reason in out->err and nothing in out
 * to free.  The report is valid up to the step that failed; mend_report_free frees it. */
int mend(Soup *out, const Soup *s, const MendOptions *o, MendReport *r);

void mend_report_free(MendReport *r);

#endif
