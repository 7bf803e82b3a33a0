// SPDX-License-Identifier: GPL-3.0-or-later
#include "psychophysics/fits/binomial_sampler.h"

#include <algorithm>
#include <cmath>

namespace chiron::psychophysics {

BinomialSampler::BinomialSampler(double n, double p) {
    p = std::clamp(p, 0.0, 1.0);
    const double reach = 10.0 * std::sqrt(n * p * (1.0 - p)) + 10.0;
    m_first = std::max(0.0, std::floor(n * p - reach));
    const double last = std::min(n, std::ceil(n * p + reach));
    const auto mode = static_cast<std::size_t>(std::min(std::floor((n + 1.0) * p), n) - m_first);
    std::vector<double> mass(static_cast<std::size_t>(last - m_first) + 1, 0.0);
    mass[mode] = 1.0; // relative to the mode, by the ratios of neighbours
    for (std::size_t i = mode + 1; i < mass.size(); ++i) {
        const double k = m_first + static_cast<double>(i);
        mass[i] = p < 1.0 ? mass[i - 1] * (n - k + 1.0) / k * p / (1.0 - p) : 0.0;
    }
    for (std::size_t i = mode; i-- > 0;) {
        const double k = m_first + static_cast<double>(i) + 1.0;
        mass[i] = p > 0.0 ? mass[i + 1] * k / (n - k + 1.0) * (1.0 - p) / p : 0.0;
    }
    m_cumulative.resize(mass.size());
    double sum = 0.0;
    for (std::size_t i = 0; i < mass.size(); ++i) {
        sum += mass[i];
        m_cumulative[i] = sum;
    }
    for (double& value : m_cumulative) {
        value /= sum;
    }
    m_cumulative.back() = 1.0;
}

double BinomialSampler::draw(core::Random& random) const noexcept {
    const double u = random.uniform();
    const auto at = std::upper_bound(m_cumulative.begin(), m_cumulative.end(), u);
    return m_first + static_cast<double>(
                         std::min<std::ptrdiff_t>(at - m_cumulative.begin(), std::ssize(m_cumulative) - 1));
}

} // namespace chiron::psychophysics
