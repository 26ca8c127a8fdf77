/* cpu.h - functions compiled for particular instruction sets.
 *
 * Write TARGET("avx2") before a static function, and call it only if HAS("avx2"). */
#ifndef CPU_H
#define CPU_H

#ifdef __x86_64__
#define TARGET(t) __attribute__((target(t)))
#define HAS(t) __builtin_cpu_supports(t)
#else
#define TARGET(t)
#define HAS(t) 0
#endif

#define INLINE static inline __attribute__((always_inline))

#endif
