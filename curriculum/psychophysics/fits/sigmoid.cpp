// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/sigmoid.h"

#include "core/normal_distribution.h"
#include "psychophysics/fits/sigmoid_shapes.h"

#include <array>
#include <cmath>
#include <limits>
#include <numbers>

namespace chiron::psychophysics {
namespace {

constexpr std::array<std::string_view, kSigmoids> kSigmoidTokens{"logistic", "gauss", "weibull",    "gumbel",
                                                                 "rgumbel",  "logn",  "hyperbolic", "tdist"};
constexpr std::array<std::string_view, kStimulusScales> kScaleTokens{"linear", "ln", "log10", "db"};

template <class Word, std::size_t N>
std::optional<Word> fromToken(const std::array<std::string_view, N>& words, std::string_view word) noexcept {
    for (std::size_t i = 0; i < N; ++i) {
        if (words[i] == word) {
            return static_cast<Word>(i);
        }
    }
    return std::nullopt;
}

double hyperbolicInverse(double p) noexcept {
    return 2.0 * std::numbers::inv_pi * std::log(std::tan(0.5 * std::numbers::pi * p));
}

} // namespace

std::string_view token(Sigmoid sigmoid) noexcept {
    return kSigmoidTokens[static_cast<std::size_t>(sigmoid)];
}
std::optional<Sigmoid> sigmoidFromToken(std::string_view word) noexcept {
    return word == "norm" ? Sigmoid::gauss : fromToken<Sigmoid>(kSigmoidTokens, word);
}
std::string_view token(StimulusScale scale) noexcept {
    return kScaleTokens[static_cast<std::size_t>(scale)];
}
std::optional<StimulusScale> stimulusScaleFromToken(std::string_view word) noexcept {
    return fromToken<StimulusScale>(kScaleTokens, word);
}

StimulusScale ownScale(Sigmoid sigmoid) noexcept {
    return sigmoid == Sigmoid::weibull || sigmoid == Sigmoid::logn ? StimulusScale::ln
                                                                   : StimulusScale::linear;
}

double toScale(double x, StimulusScale scale) noexcept {
    if (scale == StimulusScale::linear) {
        return x;
    }
    if (!(x > 0.0)) {
        return x == 0.0 ? -std::numeric_limits<double>::infinity() : std::numeric_limits<double>::quiet_NaN();
    }
    return scale == StimulusScale::ln      ? std::log(x)
           : scale == StimulusScale::log10 ? std::log10(x)
                                           : 20.0 * std::log10(x);
}

double fromScale(double value, StimulusScale scale) noexcept {
    switch (scale) {
    case StimulusScale::linear:
        return value;
    case StimulusScale::ln:
        return std::exp(value);
    case StimulusScale::log10:
        return std::pow(10.0, value);
    case StimulusScale::db:
        break;
    }
    return std::pow(10.0, value / 20.0);
}

SigmoidValue sigmoidAt(Sigmoid sigmoid, double z) noexcept {
    return shapes::withShape(sigmoid, [z]<class Shape>() noexcept { return Shape::at(z); });
}

double sigmoidInverse(Sigmoid sigmoid, double p) noexcept {
    switch (sigmoid) {
    case Sigmoid::logistic:
        return std::log(p) - std::log1p(-p);
    case Sigmoid::gauss:
    case Sigmoid::logn:
        return core::normalQuantile(p);
    case Sigmoid::weibull:
    case Sigmoid::gumbel:
        return std::log(-std::log1p(-p));
    case Sigmoid::rgumbel:
        return -std::log(-std::log(p));
    case Sigmoid::hyperbolic:
        return hyperbolicInverse(p);
    case Sigmoid::tdist:
        break;
    }
    return std::tan(std::numbers::pi * (p - 0.5));
}

SigmoidUnits unitsOf(Sigmoid sigmoid) noexcept {
    static const auto table = [] {
        std::array<SigmoidUnits, kSigmoids> units;
        for (int i = 0; i < kSigmoids; ++i) {
            const auto shape = static_cast<Sigmoid>(i);
            units[static_cast<std::size_t>(i)] = {sigmoidInverse(shape, 0.5),
                                                  sigmoidInverse(shape, 0.95) - sigmoidInverse(shape, 0.05)};
        }
        return units;
    }();
    return table[static_cast<std::size_t>(sigmoid)];
}

} // namespace chiron::psychophysics
