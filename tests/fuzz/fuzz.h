/* fuzz.h - shared by the fuzz targets.  Each target is one file with the entry point of libFuzzer.
 * For make check the same file is linked with replay.c, which runs it on the kept inputs. */
#ifndef FUZZ_H
#define FUZZ_H

#include <stddef.h>
#include <stdint.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t n);

/* Aborts with the message `what` unless ok. */
void fuzz_need(int ok, const char *what);

/* The bytes that format/ and lib/ have allocated now, and their maximum since fuzz_mark.  The linker
 * redirects malloc, calloc, realloc and free to memory.c.  While a realloc enlarges a block, the old
 * and the new block count together, as if the block had to move. */
size_t fuzz_live(void);
size_t fuzz_peak(void);
void   fuzz_mark(void);

/* Reads the bytes as a mesh, and aborts if a check fails.  An accepted mesh must be finite, its indices in
 * range, and it must come back bit by bit after writing; n chooses the format.  One n in four is read with
 * MESHFILE_FIELDS, and its channels must come back, too; one in four as mesh2disk reads, also with MESHFILE_LOOSE: then the
 * arrays are checked only.  A refused mesh must have a
 * message of one line and nothing to free.  Reading must not use more than `most` bytes of memory. */
void fuzz_mesh(const uint8_t *data, size_t n, size_t most);

/* fuzz_mesh, and the same once more with (u,v), for formats that have them. */
void fuzz_mesh_uv(const uint8_t *data, size_t n, size_t most);

/* fuzz_mesh, for a target whose inputs begin with a magic string: it replaces the first bytes, if they are
 * others. */
void fuzz_mesh_from(const char *magic, size_t nmagic, const uint8_t *data, size_t n);

/* The same for XML.  Whole files are read as they are: they begin with <?xml, and three arrays of packed data in
 * them may unpack to 1100 bytes for each byte of the file, and 4 KiB.  Other inputs get `root`, the
 * beginning of the root element, in place of their first bytes. */
void fuzz_xml(const char *root, const uint8_t *data, size_t n);

/* Files beside a mesh, for MeshParse: at most FUZZ_BESIDE bytes until the next call. */
enum { FUZZ_BESIDE = 2000 };
const struct MeshBeside *fuzz_beside(void);

/* The memory that reading n bytes may use: 16 for each byte, and 1024 (meshfile.h). */
size_t fuzz_meshbound(size_t n);

#endif
