/// Functions compiled for several instruction sets, chosen when the program starts.
///
/// Put WRC_VECTOR_CLONES before a function with loops worth vectorising. The program then runs on
/// any x86-64 and uses AVX2 or AVX-512 where the machine has them; results differ by rounding only
/// (fused multiply-add). What such a function calls must be marked WRC_VECTOR_BODY, so that it is
/// compiled together with each of the copies. Empty where the compiler cannot do it, and under
/// sanitizers, whose run-time library is not ready yet when the choice is made.
#pragma once

#if defined(__x86_64__) && defined(__ELF__) && defined(__GNUC__) && !defined(__clang__) &&         \
    !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define WRC_VECTOR_CLONES                                                                          \
  __attribute__((target_clones("arch=x86-64-v4", "arch=x86-64-v3", "default")))
#else
#define WRC_VECTOR_CLONES
#endif

#if defined(__GNUC__)
#define WRC_VECTOR_BODY [[gnu::always_inline]] inline
#else
#define WRC_VECTOR_BODY inline
#endif
