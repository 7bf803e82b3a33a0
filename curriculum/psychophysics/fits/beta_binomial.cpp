// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/beta_binomial.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {
namespace {

double stirlingRest(double z) noexcept {
    const double r = 1.0 / (z * z);
    return (1.0 / 12.0 - r * (1.0 / 360.0 - r * (1.0 / 1260.0 - r / 1680.0))) / z;
}

/// Returns Σ ln(a + j c) for j = 0 … count − 1: term by term if there are few terms or a/c is small, and by
/// Stirling's series for the rest.
double logRising(double a, double c, double count) noexcept {
    double sum = 0.0;
    constexpr double kFew = 24.0, kSeriesFrom = 16.0;
    if (c > 0.0 || count <= kFew) {
        while (count > 0.0 && (count <= kFew || a < kSeriesFrom * c)) {
            double product = 1.0;
            // The product of eight terms stays within the range of a double.
            for (int term = 0; term < 8 && count > 0.0; ++term, count -= 1.0, a += c) {
                product *= a;
            }
            sum += std::log(product);
        }
    }
    if (count <= 0.0) {
        return sum;
    }
    if (c == 0.0) {
        return sum + count * std::log(a);
    }
    const double z = a / c;
    return sum + count * std::log(a + count * c) + (z - 0.5) * std::log1p(count / z) - count +
           stirlingRest(z + count) - stirlingRest(z);
}

} // namespace

double betaBinomialLog(double right, double of, double psi, double rest, double eta) noexcept {
    constexpr double kLeast = 1e-30;
    const double c = eta * eta / (1.0 - eta * eta); // 1/ν
    return logRising(std::max(psi, kLeast), c, right) + logRising(std::max(rest, kLeast), c, of - right) -
           logRising(1.0, c, of);
}

BetaBinomialTable::BetaBinomialTable(double right, double of, const std::vector<double>& etas, double lowest,
                                     double highest)
    : m_columns(etas.size()) {
    const double far = 16.0 + std::log(1.0 + of); // beyond it, ψ or 1 − ψ is effectively 0 for all the
                                                  // level's trials
    const double low = lowest > 0.0 ? std::max(std::log(lowest / (1.0 - lowest)), -far) : -far;
    const double high = highest < 1.0 ? std::min(std::log(highest / (1.0 - highest)), far) : far;
    const double step = 0.25 * std::min(1.0, std::pow(20.0 / of, 0.25));
    const auto intervals = static_cast<std::size_t>(std::ceil(std::max(high - low, 4.0 * step) / step));
    m_first = low;
    m_perStep = 1.0 / step;
    m_last = static_cast<double>(intervals);
    m_lastNode = intervals - 1;
    m_values.resize((intervals + 3) * m_columns);
    for (std::size_t row = 0; row < intervals + 3; ++row) {
        const double logit = low + (static_cast<double>(row) - 1.0) * step;
        const double psi = 1.0 / (1.0 + std::exp(-logit)), rest = 1.0 / (1.0 + std::exp(logit));
        for (std::size_t e = 0; e < m_columns; ++e) {
            m_values[row * m_columns + e] = betaBinomialLog(right, of, psi, rest, etas[e]);
        }
    }
}

} // namespace chiron::psychophysics
