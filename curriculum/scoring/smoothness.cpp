// SPDX-License-Identifier: GPL-3.0-or-later
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

/// Returns the amplitudes up to the cut-off, divided by the largest of all.
std::vector<double> normalisedSpectrum(std::span<const double> speed, double dt_s, std::size_t points) {
    std::vector<double> padded(points, 0.0);
    std::copy(speed.begin(), speed.end(), padded.begin());
    std::vector<std::complex<double>> spectrum;
    Eigen::FFT<double> fft;
    fft.fwd(spectrum, padded);
    // The paper divides by the largest amplitude. For a profile that is nowhere negative, that is the one at
    // zero frequency.
    const double largest = std::abs(spectrum.front());
    const double step_Hz = 1.0 / (dt_s * static_cast<double>(points));
    std::vector<double> out;
    for (std::size_t k = 0; k <= points / 2 && static_cast<double>(k) * step_Hz <= kCutOff_Hz; ++k)
        out.push_back(std::abs(spectrum[k]) / largest);
    return out;
}

} // namespace

Measurement spectralArcLength(std::span<const double> speed, double dt_s) {
    if (speed.empty() || *std::max_element(speed.begin(), speed.end()) <= 0.0)
        return Measurement::undefined(reasons::kNoMovement);
    const std::size_t points = std::bit_ceil(speed.size()) << kPadding;
    const std::vector<double> amplitude = normalisedSpectrum(speed, dt_s, points);
    std::size_t last = 0;
    for (std::size_t k = 0; k < amplitude.size(); ++k)
        if (amplitude[k] >= kAmplitudeThreshold)
            last = k;
    if (last == 0)
        return Measurement::undefined(reasons::kNoSpectrum);
    const double stepOverBand = 1.0 / static_cast<double>(last);
    double length = 0.0;
    for (std::size_t k = 1; k <= last; ++k)
        length += std::hypot(stepOverBand, amplitude[k] - amplitude[k - 1]);
    return Measurement::of(-length);
}

Measurement logDimensionlessJerk(std::span<const double> speed, double dt_s) {
    if (speed.size() < 3)
        return Measurement::undefined(reasons::kTooFewSpeeds);
    const double peak = *std::max_element(speed.begin(), speed.end());
    if (peak <= 0.0)
        return Measurement::undefined(reasons::kNoMovement);
    double squares = 0.0;
    for (std::size_t i = 2; i < speed.size(); ++i) {
        const double jerk = (speed[i] - 2.0 * speed[i - 1] + speed[i - 2]) / (dt_s * dt_s);
        squares += jerk * jerk * dt_s;
    }
    const double duration = static_cast<double>(speed.size()) * dt_s;
    const double dimensionless = duration * duration * duration / (peak * peak) * squares;
    if (!(dimensionless > 0.0))
        return Measurement::undefined(reasons::kNoJerk);
    return Measurement::of(-std::log(dimensionless));
}

} // namespace chiron::scoring
