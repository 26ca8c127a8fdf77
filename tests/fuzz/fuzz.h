/* fuzz.h - what the fuzz targets share.  Each target is one file with the entry that
 * libFuzzer wants; the same file, linked with replay.c, reads kept inputs in make check. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

/* Stop, saying what, unless ok. */
void fuzz_need(int ok, const char *what);

/* Bytes that format/ and lib/ hold now, and the most they held since fuzz_mark.  The
 * linker sends their malloc, calloc, realloc and free through memory.c; a realloc that grows
 * counts old and new together, as when it has to move. */
size_t fuzz_live(void);
size_t fuzz_peak(void);
void   fuzz_mark(void);

/* Read the bytes as a mesh, with and without (u,v).  What is accepted is finite and in
 * range, and comes back bit by bit from the kind of file it is written to, which n chooses; a
 * refusal has one line and nothing to free; most bounds the memory of reading. */
void fuzz_mesh(const uint8_t *data, size_t n, size_t most);

/* 16 bytes for each of n, and a constant: meshfile.h. */
size_t fuzz_meshbound(size_t n);

#endif
