// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "psychophysics/fits/sigmoid.h"

#include <algorithm>
#include <cmath>
#include <numbers>

// The standard forms as inline functions, for loops over levels (definitions: sigmoid.h).
namespace chiron::psychophysics::shapes {

inline constexpr double kFarthest = 700.0; ///< beyond it exp overflows or underflows a double

struct Logistic {
    static SigmoidValue at(double z) noexcept {
        const double e = std::exp(-std::min(std::abs(z), kFarthest));
        const double larger = 1.0 / (1.0 + e);
        const double smaller = e * larger;
        const bool up = z >= 0.0;
        const double slope = smaller * larger;
        const double rise = up ? larger : smaller;
        const double rest = up ? smaller : larger;
        return {rise, rest, slope, slope * (rest - rise)};
    }
};

struct Gauss {
    static SigmoidValue at(double z) noexcept {
        const double bounded = std::clamp(z, -kFarthest, kFarthest);
        const double smaller = 0.5 * std::erfc(std::abs(bounded) / std::numbers::sqrt2);
        const double slope =
            std::exp(-0.5 * bounded * bounded) * (std::numbers::inv_sqrtpi / std::numbers::sqrt2);
        const bool up = bounded >= 0.0;
        return {up ? 1.0 - smaller : smaller, up ? smaller : 1.0 - smaller, slope, -bounded * slope};
    }
};

struct Gumbel {
    static SigmoidValue at(double z) noexcept {
        const double hazard = std::exp(std::clamp(z, -kFarthest, kFarthest));
        const double rest = std::exp(-hazard);
        const double rise = hazard < 0.5 ? -std::expm1(-hazard) : 1.0 - rest;
        const double slope = hazard * rest;
        return {rise, rest, slope, rest > 0.0 ? slope * (1.0 - hazard) : 0.0};
    }
};

struct ReversedGumbel {
    static SigmoidValue at(double z) noexcept {
        const SigmoidValue mirrored = Gumbel::at(-z);
        return {mirrored.rest, mirrored.rise, mirrored.slope, -mirrored.bend};
    }
};

struct Hyperbolic {
    static SigmoidValue at(double z) noexcept {
        const double e = std::exp(-std::min(std::abs(z) * (0.5 * std::numbers::pi), kFarthest));
        const double smaller = 2.0 * std::numbers::inv_pi * std::atan(e);
        const double square = e * e;
        const double slope = e / (1.0 + square);
        const double steepness = 0.5 * std::numbers::pi * (1.0 - square) / (1.0 + square);
        const bool up = z >= 0.0;
        return {up ? 1.0 - smaller : smaller, up ? smaller : 1.0 - smaller, slope,
                up ? -slope * steepness : slope * steepness};
    }
};

struct Cauchy {
    static SigmoidValue at(double z) noexcept {
        const double bounded = std::clamp(z, -1e150, 1e150);
        const double far = std::abs(bounded);
        const double smaller = far > 1.0 ? std::atan(1.0 / far) * std::numbers::inv_pi
                                         : 0.5 - std::atan(far) * std::numbers::inv_pi;
        const double slope = std::numbers::inv_pi / (1.0 + bounded * bounded);
        const bool up = bounded >= 0.0;
        return {up ? 1.0 - smaller : smaller, up ? smaller : 1.0 - smaller, slope,
                far > 1e75 ? 0.0 : -2.0 * bounded * slope / (1.0 + bounded * bounded)};
    }
};

/// Calls `work` with the standard form as its template argument, so that the branch is outside the loops over
/// levels.
template <class Work> decltype(auto) withShape(Sigmoid sigmoid, Work&& work) {
    switch (sigmoid) {
    case Sigmoid::logistic:
        return work.template operator()<Logistic>();
    case Sigmoid::gauss:
    case Sigmoid::logn:
        return work.template operator()<Gauss>();
    case Sigmoid::weibull:
    case Sigmoid::gumbel:
        return work.template operator()<Gumbel>();
    case Sigmoid::rgumbel:
        return work.template operator()<ReversedGumbel>();
    case Sigmoid::hyperbolic:
        return work.template operator()<Hyperbolic>();
    case Sigmoid::tdist:
        break;
    }
    return work.template operator()<Cauchy>();
}

} // namespace chiron::psychophysics::shapes
