// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/delay_estimate.h"

#include "core/units.h"

#include <Eigen/QR>

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <string>
#include <utility>

namespace chiron::haptics {

namespace {

using Complex = std::complex<double>;
constexpr std::size_t kSines = DelayRecord::kFrequencies_Hz.size();
constexpr int kRows = static_cast<int>(kSines);
constexpr std::size_t kWindow = DelayRecord::kWindow_ticks;
constexpr std::size_t kFewestBursts = 3;
constexpr double kLongest_s = 0.025; ///< a device with a longer delay cannot render a usable wall
constexpr double kStep_s = 2.5e-4;
constexpr double kWorstError_s = 0.0005; ///< half a tick, the T/2 of the formula
/// Share of the response. A gimbal with friction leaves 0.001, a response of another type more than half.
constexpr double kUnexplained = 0.05;
constexpr double kLeastForce_N = 0.01; ///< per sine: a smaller force never reached the device

using Spectrum = std::array<Complex, kSines>;

double omega(std::size_t sine) {
    return 2.0 * core::kPi * DelayRecord::kFrequencies_Hz[sine];
}

/// Amplitudes at the sines for one second of samples under a Hann window, after the mean is subtracted.
Spectrum spectrumOf(const double* values) {
    double mean = 0.0;
    for (std::size_t n = 0; n < kWindow; ++n)
        mean += values[n] / kWindow;
    Spectrum out{};
    for (std::size_t n = 0; n < kWindow; ++n) {
        const double t_s = core::kTickSeconds * static_cast<double>(n);
        const double hann = 1.0 - std::cos(2.0 * core::kPi * static_cast<double>(n) / kWindow);
        for (std::size_t i = 0; i < kSines; ++i)
            out[i] += 2.0 / kWindow * hann * (values[n] - mean) * std::polar(1.0, -omega(i) * t_s);
    }
    return out;
}

struct Burst {
    Spectrum force{}, place{};
};

/// F/X at each sine, and its weight.
struct Response {
    Spectrum inverse{}; ///< N/m
    std::array<double, kSines> weight{};
};

Response responseOf(const std::vector<Burst>& bursts) {
    Response out;
    for (std::size_t i = 0; i < kSines; ++i) {
        Complex cross = 0.0;
        double force2 = 0.0, rest = 0.0;
        for (const Burst& burst : bursts) {
            cross += burst.place[i] * std::conj(burst.force[i]);
            force2 += std::norm(burst.force[i]);
        }
        const Complex h = cross / force2;
        for (const Burst& burst : bursts)
            rest += std::norm(burst.place[i] - h * burst.force[i]);
        // The last term is a floor: no response counts as more accurate than 1e-4.
        const double variance = rest / static_cast<double>(bursts.size() - 1) / force2 + 1e-8 * std::norm(h);
        out.inverse[i] = 1.0 / h;
        out.weight[i] = std::norm(h) * std::norm(h) / variance;
    }
    return out;
}

struct Fit {
    double rest = std::numeric_limits<double>::infinity();
    double delay_s = std::numeric_limits<double>::quiet_NaN();
    double mass_kg = 0.0;
    double unexplained = 1.0; ///< share of the response's weighted sum of squares that the model leaves
};

/// Weighted least squares of y on N columns of kSines rows: returns the coefficients and the residual sum of
/// squares.
template <int N>
std::pair<Eigen::Matrix<double, N, 1>, double> solve(const Eigen::Matrix<double, kRows, N>& columns,
                                                     const Eigen::Vector<double, kRows>& y,
                                                     const Eigen::Vector<double, kRows>& rootWeight) {
    const Eigen::Matrix<double, kRows, N> weighted = rootWeight.asDiagonal() * columns;
    const Eigen::Vector<double, kRows> wanted = rootWeight.asDiagonal() * y;
    const Eigen::Matrix<double, N, 1> found = weighted.colPivHouseholderQr().solve(wanted);
    return {found, (weighted * found - wanted).squaredNorm()};
}

/// Fits the model for one delay. The real part is k − m ω², the imaginary part b ω + e/ω; each is fitted on
/// its own.
Fit fitAt(const Response& response, double delay_s) {
    Eigen::Matrix<double, kRows, 2> real, imaginary;
    Eigen::Vector<double, kRows> y, z, weight;
    for (std::size_t i = 0; i < kSines; ++i) {
        // u is of order 1, so that the columns are well scaled.
        const double w = omega(i), u = w / omega(kSines - 1);
        const Complex d = response.inverse[i] * std::polar(1.0, -w * (delay_s + 0.5 * core::kTickSeconds));
        const auto row = static_cast<Eigen::Index>(i);
        real.row(row) << 1.0, -u * u;
        imaginary.row(row) << u, 1.0 / u;
        y[row] = d.real();
        z[row] = d.imag();
        weight[row] = std::sqrt(response.weight[i]);
    }
    const auto [inPhase, left] = solve<2>(real, y, weight);
    const double mass_kg = inPhase[1] / (omega(kSines - 1) * omega(kSines - 1));
    const double rest = left + solve<2>(imaginary, z, weight).second;
    return {rest, delay_s, mass_kg, rest / weight.cwiseAbs2().dot(y.cwiseAbs2() + z.cwiseAbs2())};
}

/// Finds the best delay of a grid and refines it with the parabola through its neighbours. `rest` is infinite
/// if there is no best delay inside the grid.
Fit bestFit(const Response& response) {
    // A response before the command is noise, but noise around a delay of zero falls on both sides of it.
    const int first = -4;
    const int last = static_cast<int>(std::lround(kLongest_s / kStep_s));
    std::vector<double> rest;
    Fit best;
    int at = first;
    for (int i = first; i <= last; ++i) {
        const Fit fit = fitAt(response, i * kStep_s);
        rest.push_back(fit.rest);
        if (fit.mass_kg > 0.0 && fit.rest < best.rest) {
            best = fit;
            at = i;
        }
    }
    if (at == first || at == last)
        return {};
    const auto middle = static_cast<std::size_t>(at - first);
    const double before = rest[middle - 1], after = rest[middle + 1];
    const double bend = before - 2.0 * best.rest + after;
    return fitAt(response, (at + (bend > 0.0 ? 0.5 * (before - after) / bend : 0.0)) * kStep_s);
}

/// Standard error of the delay by the jackknife: each burst is left out in turn.
double jackknife_s(const std::vector<Burst>& bursts) {
    std::vector<double> delays;
    for (std::size_t left = 0; left < bursts.size(); ++left) {
        std::vector<Burst> others = bursts;
        others.erase(others.begin() + static_cast<std::ptrdiff_t>(left));
        delays.push_back(bestFit(responseOf(others)).delay_s);
    }
    const auto n = static_cast<double>(delays.size());
    double mean = 0.0, sum = 0.0;
    for (const double each : delays)
        mean += each / n;
    for (const double each : delays)
        sum += (each - mean) * (each - mean);
    return std::sqrt((n - 1.0) / n * sum);
}

tl::unexpected<core::Error> none(const std::string& why) {
    return core::fail(core::ErrorCode::doesNotHold, "delay: " + why);
}

core::Result<std::vector<Burst>> burstsOf(const DelayRecord& record) {
    const std::size_t whole = std::min(record.places, record.forces) / kWindow;
    std::vector<Burst> bursts;
    for (std::size_t i = 0; i < whole; ++i) {
        if (record.broken[i] != 0)
            continue;
        const Burst burst{spectrumOf(record.force_N.data() + i * kWindow),
                          spectrumOf(record.place_m.data() + i * kWindow)};
        for (std::size_t sine = 0; sine < kSines; ++sine) {
            if (!std::isfinite(std::norm(burst.force[sine])) || !std::isfinite(std::norm(burst.place[sine])))
                return core::fail(core::ErrorCode::badInput,
                                  "delay: burst " + std::to_string(i + 1) + ": finite numbers expected");
            if (std::abs(burst.force[sine]) < kLeastForce_N)
                return none(
                    "the device was commanded too little force: it is not armed, or its limits took it");
            if (std::norm(burst.place[sine]) == 0.0)
                return none("the tool did not move");
        }
        bursts.push_back(burst);
    }
    if (bursts.size() < kFewestBursts)
        return core::fail(core::ErrorCode::badInput, "delay: " + std::to_string(bursts.size()) +
                                                         " whole bursts in time, at least " +
                                                         std::to_string(kFewestBursts) + " expected");
    return bursts;
}

} // namespace

core::Result<DelayEstimate> estimateDelay(const DelayRecord& record) {
    const auto bursts = burstsOf(record);
    CHIRON_TRY(bursts);
    const Fit fit = bestFit(responseOf(*bursts));
    DelayEstimate out;
    out.delay_s = fit.delay_s;
    out.standardError_s = jackknife_s(*bursts);
    out.bursts = static_cast<int>(bursts->size());
    if (std::isfinite(out.standardError_s) && out.standardError_s > kWorstError_s)
        return none("too much else moves the tool: known to ±" + std::to_string(1e3 * out.standardError_s) +
                    " ms only, ±0.5 expected; hold it still");
    if (!std::isfinite(out.delay_s) || !std::isfinite(out.standardError_s) || fit.unexplained > kUnexplained)
        return none("the answer is not that of a mass within 25 ms: the tool must be free, and held loosely");
    out.mass_kg = fit.mass_kg;
    out.delay_s = std::max(0.0, out.delay_s);
    return out;
}

} // namespace chiron::haptics
