/* quality.h - reports the quality of a map: metadata, details, notes. */
#ifndef CMD_QUALITY_H
#define CMD_QUALITY_H

#include "../../format/lhg.h"
#include "../../lib/map/conformal.h"

/* Adds the metadata of the map of d.  corner: NULL on a closed surface.  apart: distance of its boundary from that of --like, or
 * -1. */
void quality_meta(Lhg *out, const Disk *d, const int *corner, double apart, const Conformal *c);

/* Adds the facts (lib/meshfile/facts.h), what the mesh file says of its coordinates, as metadata. */
void quality_facts(Lhg *out, const char *facts);

/* Prints details of the map, and notes if it misses the tolerance or if triangles are turned over
 * in the (u,v) of the file uv.  mesh: the name of d in messages; uv: NULL if none is written. */
void quality_notes(const char *mesh, const char *uv, const Disk *d, const ConformalOptions *o,
	const Conformal *c);

#endif
