/* fuzz.h - shared by the fuzz targets.  Each target is one file with the entry point of libFuzzer; the
 * same file, linked with replay.c, reads the kept inputs in make check. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

/* Aborts with the message `what` unless ok. */
void fuzz_need(int ok, const char *what);

/* Bytes that format/ and lib/ have allocated now, and their maximum since fuzz_mark.  The linker
 * redirects their malloc, calloc, realloc and free to memory.c; a growing realloc counts the old
 * and the new block together, as if it had to move. */
size_t fuzz_live(void);
size_t fuzz_peak(void);
void   fuzz_mark(void);

/* Read the bytes as a mesh, with and without (u,v).  An accepted mesh must be finite and in range, and
 * come back bit by bit from the format it is written in, which n chooses; a refusal must have one
 * line and nothing to free; most bounds the memory of reading. */
void fuzz_mesh(const uint8_t *data, size_t n, size_t most);

/* Bound of memory for n bytes: 16 each, and a constant (meshfile.h). */
size_t fuzz_meshbound(size_t n);

#endif
