// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Before a function of whole-number loops: compiled for AVX2 too, chosen when the program starts; the
/// results are the same. Sanitized builds go without, since their run-time is not ready when the choice is
/// made.
#if defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define CHIRON_AVX2_TOO __attribute__((target_clones("avx2", "default")))
#else
#define CHIRON_AVX2_TOO
#endif
