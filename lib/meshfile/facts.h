/* facts.h - what a mesh file says of its coordinates: their space, their unit, where they come from.
 *
 * Coordinates are never moved on account of a fact.  Soup.facts has a line "key value\n" for each:
 *
 * space   the space of the coordinates: tkras or scanner (FreeSurfer); the DataSpace of GIFTI
 * c_ras   the centre of the volume in scanner coordinates, "x y z": scanner = tkras + c_ras
 * unit    of length: mm, m
 * source  the format that the coordinates came from
 *
 * and fs.KEY for each line "KEY = value" of the footer of a FreeSurfer surface, except cras.
 *
 * OBJ and PLY hold them in comments, "lhgrid fact space tkras"; OFF and STL have no place for them.
 */
#ifndef FACTS_H
#define FACTS_H

enum { FACT_KEY = 32, FACT_VALUE = 200, FACTS_MOST = 4000 };     /* bytes: of a key, a value, all lines */

/* Splits the first line of facts.  Returns the rest, or NULL if there is no line. */
const char *fact_next(const char *facts, char key[FACT_KEY], char value[FACT_VALUE]);

/* Whether it is one of the keys above. */
int fact_is(const char *key);

#endif
