/* json.h - JSON text as a list of its values, in the order of the text.  Private to lib/. */
#ifndef JSON_H
#define JSON_H

#include <stdint.h>

#include "meshpriv.h"

/* A value: where its text begins, its length, and the number of the value after it and all that is inside
 * it.  The values inside an array follow it; those inside an object too, each after its key. */
typedef struct JsonValue {
	uint32_t at, n, next;
} JsonValue;

/* Value 0 is the whole text. */
typedef struct Json {
	Reader    *r;
	const char *text, *p, *end;     /* p: while it is read */
	JsonValue *value;               /* malloc'd: free() it */
	uint32_t   n;
} Json;

/* Reads the text from p to end, less than 4 GiB.  Needs 12 bytes for each value.  Returns 0, or MESH_ENOMEM or
 * MESH_EFORMAT with nothing to free. */
int json_read(Json *j, Reader *r, const char *p, const char *end);

/* Values are numbered; -1 stands for a missing one, and gives what is missing again.
 *
 * json_get    the value of that key in an object, -1 if it has none or is no object
 * json_first  the first value in an array, or key in an object; -1 if it is empty or neither
 * json_next   the next value after v in the array `in`, -1 after the last */
long long json_get(const Json *j, long long object, const char *key);
long long json_first(const Json *j, long long in);
long long json_next(const Json *j, long long in, long long v);

/* The value as a number, or as a whole number; `none` if it is missing or no such number. */
double json_number(const Json *j, long long v, double none);
long long json_int(const Json *j, long long v, long long none);

/* The text of a string between its quotes, or of another value; empty if it is missing. */
Token json_text(const Json *j, long long v);

/* The n hexadecimal digits at p as a number, -1 if they are none. */
long json_hex(const char *p, int n);

/* Copies the string with its escapes replaced, in UTF-8, and returns its length; -1 if it does not fit into size bytes
 * or has an escape that is none. */
long json_unescaped(const Json *j, long long v, char *to, size_t size);

#endif
