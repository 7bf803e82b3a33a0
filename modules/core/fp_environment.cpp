// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"

#include <cfenv>
#include <xmmintrin.h>

namespace chiron::core {

namespace {
constexpr unsigned kFlushToZero = 0x8000;        // MXCSR.FTZ
constexpr unsigned kDenormalsAreZero = 0x0040;   // MXCSR.DAZ
constexpr unsigned kRoundingMask = 0x6000;       // MXCSR.RC, 0 = nearest
} // namespace

void setModelFloatingPointEnvironment() noexcept {
    std::fesetround(FE_TONEAREST);
    _mm_setcsr((_mm_getcsr() & ~kRoundingMask) | kFlushToZero | kDenormalsAreZero);
}

std::string cpuClass() {
    std::string name = "x86-64";
    __builtin_cpu_init();
    if (__builtin_cpu_supports("fma"))
        name += "+fma";
    if (__builtin_cpu_supports("avx2"))
        name += "+avx2";
    if (__builtin_cpu_supports("avx512f"))
        name += "+avx512f";
    return name;
}

std::string buildId() { return std::string(CHIRON_VERSION) + " gcc " + __VERSION__ + " models " CHIRON_MODELS_ID; }

} // namespace chiron::core
