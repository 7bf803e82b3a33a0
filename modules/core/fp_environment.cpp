// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/fp_environment.h"

#include <cfenv>
#include <string_view>
#include <xmmintrin.h>

namespace chiron::core {

namespace {
constexpr unsigned kFlushToZero = 0x8000;      // MXCSR.FTZ
constexpr unsigned kDenormalsAreZero = 0x0040; // MXCSR.DAZ
constexpr unsigned kRoundingMask = 0x6000;     // MXCSR.RC, 0 = nearest
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

std::string forcesOfBuild(const std::string& buildId) {
    const auto compiler = buildId.find(" gcc ");
    return compiler == std::string::npos ? buildId : buildId.substr(compiler + 1);
}

std::string modelsOfBuild(const std::string& buildId) {
    constexpr std::string_view kWord = " models ";
    const auto at = buildId.rfind(kWord);
    return at == std::string::npos ? std::string() : buildId.substr(at + kWord.size());
}

std::string buildId() {
    return std::string(CHIRON_VERSION) + " gcc " + __VERSION__ + " models " CHIRON_MODELS_ID;
}

} // namespace chiron::core
