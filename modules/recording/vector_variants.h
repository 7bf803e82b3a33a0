// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Placed before a function with loops over whole numbers, this also compiles it for AVX2; the variant is
/// chosen when the program starts, and the results are the same. Sanitized builds leave it out, because their
/// run-time is not ready when the choice is made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CHIRON_AVX2_TOO __attribute__((target_clones("avx2", "default")))
#else
#define CHIRON_AVX2_TOO
#endif
