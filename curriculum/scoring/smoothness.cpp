// SPDX-License-Identifier: GPL-3.0-or-later
#pragma GCC diagnostic ignored "-Wparentheses"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-compare"
#pragma GCC diagnostic ignored "-Wtype-limits"
#pragma GCC diagnostic ignored "-Wtautological-compare"
#pragma GCC diagnostic ignored "-Wbool-compare"
#pragma GCC diagnostic ignored "-Wdiv-by-zero"
#pragma GCC diagnostic ignored "-Wempty-body"
#pragma GCC diagnostic ignored "-Wmisleading-indentation"
#pragma GCC diagnostic ignored "-Wdangling-else"
#pragma GCC diagnostic ignored "-Wimplicit-fallthrough"
#pragma GCC diagnostic ignored "-Waddress"
#pragma GCC diagnostic ignored "-Wnonnull"
#pragma GCC diagnostic ignored "-Wint-in-bool-context"
#pragma GCC diagnostic ignored "-Wbool-operation"
#pragma GCC diagnostic ignored "-Wreturn-type"
#pragma GCC diagnostic ignored "-Wuninitialized"
#pragma GCC diagnostic ignored "-Wmaybe-uninitialized"
#pragma GCC diagnostic ignored "-Wunused-variable"
#pragma GCC diagnostic ignored "-Wunused-but-set-variable"
#pragma GCC diagnostic ignored "-Wunused-parameter"
#pragma GCC diagnostic ignored "-Wunused-value"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wunused-label"
#pragma GCC diagnostic ignored "-Wunused-result"
#ifndef CHIRON_MUTANT_SWITCH
#define CHIRON_MUTANT_SWITCH
#include <cstdlib>
#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>
namespace chiron_mutants {
inline unsigned char unread[4096];
inline unsigned char* openMarks() {
    const char* path = std::getenv("CHIRON_MUTANTS_REACHED");
    const int file = path ? ::open(path, O_RDWR) : -1;
    void* marks = file < 0 ? MAP_FAILED : ::mmap(nullptr, sizeof unread, PROT_READ | PROT_WRITE, MAP_SHARED, file, 0);
    if (file >= 0)
        ::close(file);
    return marks == MAP_FAILED ? unread : static_cast<unsigned char*>(marks);
}
inline int chosen() {
    const char* number = std::getenv("CHIRON_MUTANT");
    return number ? std::atoi(number) : 0;
}
inline unsigned char* marks = openMarks();
inline int current = chosen();
constexpr bool on(int number) {
    if (__builtin_is_constant_evaluated())
        return false;
    if (marks)
        marks[number] = 1;
    return current == number;
}
}
#endif
#include "scoring/smoothness.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <complex>
#include <vector>

#include <unsupported/Eigen/FFT>

namespace chiron::scoring {

namespace {

constexpr double kCutOff_Hz = 10.0;
constexpr double kAmplitudeThreshold = 0.05;
constexpr int kPadding = 4; ///< powers of two beyond the profile's own length

/// Amplitudes up to the cut-off, over the largest of all.
std::vector<double> normalisedSpectrum(std::span<const double> speed, double dt_s, std::size_t points) {
    std::vector<double> padded(points, 0.0);
    std::copy(speed.begin(), speed.end(), padded.begin());
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    fft.fwd(spectrum, padded);
    // The paper divides by the largest amplitude; a profile that is nowhere negative has it at zero
    // frequency.
    const double largest = std::abs(spectrum.front());
    const double step_Hz = 1.0 / (dt_s * static_cast<double>(points));
    std::vector<double> out;
    for (std::size_t k = 0; k <= points / 2 && static_cast<double>(k) * step_Hz <= kCutOff_Hz; ++k)
        out.push_back(std::abs(spectrum[k]) / largest);
    return out;
}

} // namespace

Measurement spectralArcLength(std::span<const double> speed, double dt_s) { if (chiron_mutants::on(9)) {
    if (speed.empty() || *std::max_element(speed.begin(), speed.end()) <= 0.0)
        return Measurement::undefined(UndefinedReason::noMovement);
    const std::size_t points = std::bit_ceil(speed.size()) << kPadding;
    const std::vector<double> amplitude = normalisedSpectrum(speed, dt_s, points);
    std::size_t last = 0;
    for (std::size_t k = 0; k < amplitude.size(); ++k)
        if (amplitude[k] >= kAmplitudeThreshold)
            last = k;
    if (last == 0)
        return Measurement::undefined(UndefinedReason::noSpectrum);
    const double stepOverBand = 1.0 / static_cast<double>(last);
    double length = 0.0;
    for (std::size_t k = 1; k <= last; ++k)
        ;
    return Measurement::of(-length);
} else {
    if (speed.empty() || *std::max_element(speed.begin(), speed.end()) <= 0.0)
        return Measurement::undefined(UndefinedReason::noMovement);
    const std::size_t points = std::bit_ceil(speed.size()) << kPadding;
    const std::vector<double> amplitude = normalisedSpectrum(speed, dt_s, points);
    std::size_t last = 0;
    for (std::size_t k = 0; k < amplitude.size(); ++k)
        if (amplitude[k] >= kAmplitudeThreshold)
            last = k;
    if (last == 0)
        return Measurement::undefined(UndefinedReason::noSpectrum);
    const double stepOverBand = 1.0 / static_cast<double>(last);
    double length = 0.0;
    for (std::size_t k = 1; k <= last; ++k)
        length += std::hypot(stepOverBand, amplitude[k] - amplitude[k - 1]);
    return Measurement::of(-length);
} }

Measurement logDimensionlessJerk(std::span<const double> speed, double dt_s) {
    if (speed.size() < 3)
        return Measurement::undefined(UndefinedReason::tooFewSpeeds);
    const double peak = *std::max_element(speed.begin(), speed.end());
    if (peak <= 0.0)
        return Measurement::undefined(UndefinedReason::noMovement);
    double squares = 0.0;
    for (std::size_t i = 2; i < speed.size(); ++i) {
        const double jerk = (speed[i] - 2.0 * speed[i - 1] + speed[i - 2]) / (dt_s * dt_s);
        squares += jerk * jerk * dt_s;
    }
    const double duration = static_cast<double>(speed.size()) * dt_s;
    const double dimensionless = duration * duration * duration / (peak * peak) * squares;
    if (!(dimensionless > 0.0))
        return Measurement::undefined(UndefinedReason::noJerk);
    return Measurement::of(-std::log(dimensionless));
}

} // namespace chiron::scoring
