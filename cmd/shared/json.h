/* json.h - text as JSON strings. */
#ifndef CMD_JSON_H
#define CMD_JSON_H

#include <stdio.h>

/* s as a JSON string with its quotes; bytes that are not UTF-8 become U+FFFD. */
void json_string(FILE *f, const char *s);

#endif
