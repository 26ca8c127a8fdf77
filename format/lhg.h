/* lhg.h - read and write streams of .lhg grids (specification: LHG.md).
 *
 * A grid is nu x nv nodes of the chart [0,1] x [0,T].  Node (i,j), 0 <= i < nu,
 * 0 <= j < nv, lies at (u,v) = (i*h, j*k), h = 1/(nu-1), k = T/(nv-1); on the sock at
 * ((i+1/2)*h, (j+1/2)*k), h = 1/nu, k = T/(nv-1/2).  A channel holds one double for
 * every node of its support; node (i,j) of a channel with support LHG_GRID is element
 * j*nu + i.
 *
 * Nothing here prints or exits.  A function that can fail returns one of the
 * negative codes below and, where it has a stream, leaves one line of
 * explanation in its err: what is wrong, and where.
 */
#ifndef LHG_H
#define LHG_H

#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#ifdef __cplusplus
extern "C" {
#endif

enum {
	LHG_EIO    = -1,        /* read or write failed; errno says why */
	LHG_ENOMEM = -2,
	LHG_EMAGIC = -3,        /* input empty, of another version, or line ends changed */
	LHG_EHEAD  = -4,        /* header malformed, or its CRC is wrong */
	LHG_ESHORT = -5,        /* input ends inside a grid, or before the last frame */
	LHG_EDATA  = -6,        /* wrong CRC or padding of a channel, wrong end mark, bytes after it */
	LHG_EVALUE = -7,        /* a sample is NaN or infinite */
	LHG_ELIMIT = -8,        /* a size, count, name or text outside the limits of LHG.md */
	LHG_EFOREIGN = -10,     /* input is not .lhg at all */
	LHG_EORDER = -9         /* a frame missing, doubled, out of order or of another stream */
};

enum {
	LHG_MINN = 2, LHG_MAXN = 32768,         /* nodes in one direction */
	LHG_MAXCHAN = 64,
	LHG_NAMELEN = 32,                       /* of names and units, with the final NUL */
	LHG_KEYLEN = 64,                        /* of metadata keys, with the final NUL */
	LHG_MAXFRAMES = 1000000,
	LHG_MAXLINE = 4000,                     /* bytes of one header line, without its LF */
	LHG_MAXHEAD = 65536                     /* bytes of one header */
};

/* What the sides of the chart are: LHG.md 2.1. */
enum {
	LHG_RECTANGLE,          /* all four sides are edges */
	LHG_SOCK,               /* periodic in u, folded at v = 0; the only edge is v = T */
	LHG_PILLOW              /* periodic in u, folded at v = 0 and v = T; no edge */
};

/* Which nodes a channel covers, in row order (j slowest, i fastest). */
enum {
	LHG_GRID,               /* all */
	LHG_BORDER,             /* less than `step` steps from an edge; not on the pillow */
	LHG_LATTICE             /* i and j multiples of `step`; on the rectangle alone */
};

typedef struct LhgChannel {
	char    name[LHG_NAMELEN];
	char    unit[LHG_NAMELEN];      /* "length", "1/length", "1" */
	int     support, step;          /* step is 0 for LHG_GRID */
	size_t  n;                      /* samples, = lhg_count(...) */
	double *f;                      /* owned */
} LhgChannel;

typedef struct Lhg {
	int        nu, nv;              /* nodes, LHG_MINN .. LHG_MAXN each */
	double     T;                   /* height of the chart, > 0 */
	int        chart;               /* LHG_RECTANGLE, LHG_SOCK or LHG_PILLOW */
	int        frame, frames;       /* this is grid `frame` of `frames`, counted from 1 */
	int        nchan;
	LhgChannel chan[LHG_MAXCHAN];
	char      *meta;                /* a line "key value\n" for each datum, or NULL */
	char      *hist;                /* a line "text\n" for each step, oldest first, or NULL */
} Lhg;

/* A stream that is read or written.  lhg_open sets it up.  Callers may read the fields, but not
 * change them. */
typedef struct LhgStream {
	FILE     *f;
	int       frame, frames;        /* of the last grid read or written; 0 0 before the first */
	uint32_t  crc;                  /* of the last grid read or written; see LHG.md, frame */
	long      grids;                /* read or written so far */
	int       ahead;                /* version in line 1 of the next header, if that is read or
	                                 * written already, else 0 */
	char      err[256];
} LhgStream;

/* Start an empty grid on the rectangle: no channels, frame 1 of 1. */
void lhg_init(Lhg *g, int nu, int nv, double T);

/* Release everything g owns and leave it empty; may be called twice. */
void lhg_free(Lhg *g);

/* The name of a chart in LHG.md; and the chart of that name, or -1. */
const char *lhg_chartname(int chart);
int         lhg_chart(const char *name);

/* The number of nodes of a support on the chart of g, or 0 if step does not suit it (0 for
 * LHG_GRID, 1 .. max(nu,nv)-1 for the others), the chart has no such support, or a size is out
 * of range. */
size_t lhg_count(const Lhg *g, int support, int step);

/* The channel of that name, or NULL. */
LhgChannel *lhg_find(const Lhg *g, const char *name);

/* Append a channel of zeros.  Returns its samples; or NULL if there is no memory, there are
 * LHG_MAXCHAN channels already, LHG.md does not allow the name, unit or step, or the name is
 * taken. */
double *lhg_add(Lhg *g, const char *name, const char *unit, int support, int step);

/* Remove the channel of that name, if there is one. */
void lhg_drop(Lhg *g, const char *name);

/* The number j*nu + i of the first node of c in row order; and of its node that follows its node p,
 * nu*nv after the last. */
size_t lhg_first(const Lhg *g, const LhgChannel *c);
size_t lhg_next(const Lhg *g, const LhgChannel *c, size_t p);

/* lhg_gather sets the samples of c from f[nu*nv], a field on all nodes.  lhg_scatter copies the
 * samples into such a field; nodes outside the support are not changed. */
void lhg_gather(const Lhg *g, LhgChannel *c, const double *f);
void lhg_scatter(const Lhg *g, const LhgChannel *c, double *f);

/* Set the datum of that key, or replace it in its place, or remove it if value is NULL.  Returns 0;
 * LHG_ENOMEM; or LHG_ELIMIT if LHG.md 2.3 does not allow the key (letters, digits and . _ + -) or
 * the value (UTF-8, not empty, no control character, no space at either end).  On failure nothing
 * is changed. */
int lhg_setmeta(Lhg *g, const char *key, const char *value);

/* Copy the value of key to value[n], cut if it is too long.  Returns value, or NULL if there is no
 * such key. */
const char *lhg_getmeta(const Lhg *g, const char *key, char *value, size_t n);

/* Append one step to the history.  Every byte that is a control character or not
 * UTF-8 becomes '?', spaces at both ends are removed, a line longer than LHG.md allows is cut and
 * ends in "...", an empty one becomes "?".  Returns 0 or LHG_ENOMEM. */
int lhg_note(Lhg *g, const char *step);

/* The length in bytes of the first character of the n > 0 bytes at p, if LHG.md allows it in
 * metadata and history; 0 if it is a control character or not UTF-8. */
size_t lhg_utf8(const char *p, size_t n);

/* Start a stream that reads from or writes to f.  The caller closes f. */
void lhg_open(LhgStream *s, FILE *f);

/* Line 1 of a header, with its LF: the version of LHG.md that a reader must know, 1 or 2.  lhg_magic
 * returns the version, or 0 if the LHG_MAGICLEN bytes at line are no such line. */
enum { LHG_MAGICLEN = 6 };
int  lhg_magic(const char *line);

/* Start a stream that reads from f, whose first bytes, line 1 of this version, have been read
 * already: for callers that must first see whether f is a stream of grids at all. */
void lhg_open_behind_magic(LhgStream *s, FILE *f, int version);

/* Read the next grid and its end mark.  After the last frame of a set also look at what follows: the
 * end of the input, or LHG_MAGIC of another grid.  On a pipe this waits until one of them arrives.
 * g needs no lhg_init.
 *
 * Returns 1 with a grid in g (lhg_free it), or 0 at the end of a complete stream.  On failure returns
 * a negative code; g then holds nothing, and the stream is to be given up.  An empty input gives
 * LHG_EMAGIC.  If the input ends after frame k < n of n, frame k is read, and the next call returns
 * LHG_ESHORT.  Memory grows with the bytes that arrive. */
int lhg_read(LhgStream *s, Lhg *g);

/* Write g as the next grid and flush.  Everything is checked before the first
 * byte goes out; g->frame must follow the grid written before.  Returns 0 or a
 * negative code; after LHG_EIO the stream is to be given up. */
int lhg_write(LhgStream *s, const Lhg *g);

/* The version of LHG.md that a reader of g must know. */
int lhg_version(const Lhg *g);

/* Between two sets: write line 1 of the header of the next grid now; lhg_write will leave it out.
 * If the writer fails, or is killed, before that grid is complete, readers then see that the stream
 * is not complete.  version: that of the next grid; lhg_write returns
 * LHG_EORDER for a grid of another.  Returns 0 or LHG_EIO. */
int lhg_begin_next(LhgStream *s, int version);

#ifdef __cplusplus
}
#endif

#endif
