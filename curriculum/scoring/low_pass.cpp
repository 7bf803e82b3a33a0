// SPDX-License-Identifier: GPL-3.0-or-later
#include "scoring/low_pass.h"

#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace chiron::scoring {

namespace {

struct Biquad {
    double b0, b1, b2, a1, a2;
};

Biquad butterworth(double rate_Hz, double cutOff_Hz) {
    const double k = std::tan(core::kPi * cutOff_Hz / rate_Hz);
    const double scale = 1.0 / (1.0 + std::sqrt(2.0) * k + k * k);
    const double b0 = k * k * scale;
    return {b0, 2.0 * b0, b0, 2.0 * (k * k - 1.0) * scale, (1.0 - std::sqrt(2.0) * k + k * k) * scale};
}

/// Filters one pass in place, in transposed direct form II, starting from the steady state of the first
/// value.
template <class Iterator> void pass(const Biquad& c, Iterator first, Iterator last) {
    core::Vec3 s1 = (1.0 - c.b0) * *first;
    core::Vec3 s2 = (c.b2 - c.a2) * *first;
    for (; first != last; ++first) {
        const core::Vec3 x = *first;
        const core::Vec3 y = c.b0 * x + s1;
        s1 = c.b1 * x - c.a1 * y + s2;
        s2 = c.b2 * x - c.a2 * y;
        *first = y;
    }
}

} // namespace

std::vector<core::Vec3> lowPassZeroPhase(const std::vector<core::Vec3>& positions, double rate_Hz,
                                         double cutOff_Hz) {
    assert(rate_Hz > 2.0 * cutOff_Hz);
    const std::size_t n = positions.size();
    if (n < 2)
        return positions;
    const std::size_t pad = std::min(n - 1, static_cast<std::size_t>(std::ceil(3.0 * rate_Hz / cutOff_Hz)));
    // Coordinates are relative to the first position, so that a path far from the origin loses no digits in
    // the recursion.
    const core::Vec3 origin = positions.front();
    std::vector<core::Vec3> x;
    x.reserve(n + 2 * pad);
    for (std::size_t i = pad; i >= 1; --i)
        x.push_back(origin - positions[i]);
    for (const core::Vec3& p : positions)
        x.push_back(p - origin);
    for (std::size_t i = 1; i <= pad; ++i)
        x.push_back(2.0 * (positions[n - 1] - origin) - (positions[n - 1 - i] - origin));
    const Biquad filter = butterworth(rate_Hz, cutOff_Hz);
    pass(filter, x.begin(), x.end());
    pass(filter, x.rbegin(), x.rend());
    std::vector<core::Vec3> out(x.begin() + static_cast<std::ptrdiff_t>(pad),
                                x.begin() + static_cast<std::ptrdiff_t>(pad + n));
    for (core::Vec3& p : out)
        p += origin;
    return out;
}

} // namespace chiron::scoring
