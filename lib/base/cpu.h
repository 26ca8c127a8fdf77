/* cpu.h - functions compiled for more than one kind of processor.
 *
 * Write TARGET("avx2") before a static function, and test HAS("avx2") before the call. */
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
