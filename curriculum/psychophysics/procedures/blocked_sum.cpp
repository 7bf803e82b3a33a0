// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/procedures/blocked_sum.h"

#include <cstring>

namespace chiron::psychophysics {

namespace {

// GCC vector types: the compiler splits them into what the processor has, with the same arithmetic lane by
// lane. The eight running sums are two halves, because vectors wider than the processor's own go through
// memory.
constexpr std::size_t kHalf = kLanes / 2;
using Half = double __attribute__((vector_size(kHalf * sizeof(double))));
using FloatHalf = float __attribute__((vector_size(kHalf * sizeof(float))));
using FloatLanes = float __attribute__((vector_size(kLanes * sizeof(float))));

inline __attribute__((always_inline)) void load(const double* from, Half& to) {
    std::memcpy(&to, from, sizeof to);
}

inline __attribute__((always_inline)) void load(const float* from, Half& to) {
    FloatHalf narrow;
    std::memcpy(&narrow, from, sizeof narrow);
    to = __builtin_convertvector(narrow, Half);
}

inline __attribute__((always_inline)) double total(const Half& low, const Half& high) {
    const Half s = low + high;
    return (s[0] + s[2]) + (s[1] + s[3]);
}

/// Two sets of running sums hide the latency of the additions; they are combined at the end.
template <class B>
inline __attribute__((always_inline)) double sumOfBlocks(const double* a, B value,
                                                         const std::uint32_t* blocks, std::size_t count) {
    Half sums[4]{};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = static_cast<std::size_t>(blocks[i]) * kBlock;
        for (std::size_t j = 0; j < kBlock; j += 2 * kLanes)
            for (std::size_t k = 0; k < 4; ++k) {
                Half p;
                Half q;
                load(a + first + j + k * kHalf, p);
                value(first + j + k * kHalf, q);
                sums[k] += p * q;
            }
    }
    return total(sums[0] + sums[2], sums[1] + sums[3]);
}

/// Sums the four eighths of a block in single precision, then the blocks in double precision.
inline __attribute__((always_inline)) double
roughSumOfBlocks(const float* a, const float* b, const std::uint32_t* blocks, std::size_t count) {
    Half low{};
    Half high{};
    for (std::size_t i = 0; i < count; ++i) {
        const std::size_t first = static_cast<std::size_t>(blocks[i]) * kBlock;
        FloatLanes part{};
        for (std::size_t j = 0; j < kBlock; j += kLanes) {
            FloatLanes p;
            FloatLanes q;
            std::memcpy(&p, a + first + j, sizeof p);
            std::memcpy(&q, b + first + j, sizeof q);
            part += p * q;
        }
        low += __builtin_convertvector(__builtin_shufflevector(part, part, 0, 1, 2, 3), Half);
        high += __builtin_convertvector(__builtin_shufflevector(part, part, 4, 5, 6, 7), Half);
    }
    return total(low, high);
}

#define CHIRON_KERNELS(target, name)                                                                         \
    target double name##Double(const double* a, const double* b, const std::uint32_t* blocks,                \
                               std::size_t count) {                                                          \
        return sumOfBlocks(                                                                                  \
            a, [b](std::size_t i, Half & q) __attribute__((always_inline)) { load(b + i, q); }, blocks,      \
            count);                                                                                          \
    }                                                                                                        \
    target double name##Rough(const float* a, const float* b, const std::uint32_t* blocks,                   \
                              std::size_t count) {                                                           \
        return roughSumOfBlocks(a, b, blocks, count);                                                        \
    }                                                                                                        \
    target double name##Split(const double* a, const float* high, const float* low,                          \
                              const std::uint32_t* blocks, std::size_t count) {                              \
        const auto both = [ high, low ](std::size_t i, Half & q) __attribute__((always_inline)) {            \
            Half rest;                                                                                       \
            load(high + i, q);                                                                               \
            load(low + i, rest);                                                                             \
            q += rest;                                                                                       \
        };                                                                                                   \
        return sumOfBlocks(a, both, blocks, count);                                                          \
    }

#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
CHIRON_KERNELS(__attribute__((target("avx2"))), wide)
#endif
CHIRON_KERNELS(, plain)
#undef CHIRON_KERNELS

struct Kernels {
    double (*ofDouble)(const double*, const double*, const std::uint32_t*, std::size_t) = plainDouble;
    double (*rough)(const float*, const float*, const std::uint32_t*, std::size_t) = plainRough;
    double (*ofSplit)(const double*, const float*, const float*, const std::uint32_t*,
                      std::size_t) = plainSplit;
};

const Kernels& kernels() noexcept {
    static const Kernels chosen = [] {
        Kernels k;
#if defined(__x86_64__) && !defined(__SANITIZE_THREAD__)
        if (__builtin_cpu_supports("avx2"))
            k = {wideDouble, wideRough, wideSplit};
#endif
        return k;
    }();
    return chosen;
}

} // namespace

double blockedSum(const double* a, std::size_t count) noexcept {
    Half low{};
    Half high{};
    for (std::size_t i = 0; i < count; i += kLanes) {
        Half p;
        load(a + i, p);
        low += p;
        load(a + i + kHalf, p);
        high += p;
    }
    return total(low, high);
}

double blockedDot(const double* a, const double* b, std::size_t count) noexcept {
    Half sums[2]{};
    for (std::size_t i = 0; i < count; i += kLanes)
        for (std::size_t k = 0; k < 2; ++k) {
            Half p;
            Half q;
            load(a + i + k * kHalf, p);
            load(b + i + k * kHalf, q);
            sums[k] += p * q;
        }
    return total(sums[0], sums[1]);
}

double blockedDot(const double* a, const double* b, const ActiveBlocks& blocks) noexcept {
    return kernels().ofDouble(a, b, blocks.data(), blocks.size());
}

double roughDot(const float* a, const float* b, const ActiveBlocks& blocks) noexcept {
    return kernels().rough(a, b, blocks.data(), blocks.size());
}

double blockedDot(const double* a, const float* high, const float* low, const ActiveBlocks& blocks) noexcept {
    return kernels().ofSplit(a, high, low, blocks.data(), blocks.size());
}

} // namespace chiron::psychophysics
