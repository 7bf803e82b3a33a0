// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety_caps.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace chiron::haptics {

namespace {

/// Keeps a scaled wrench from exceeding its cap by the last bit of the multiplication.
constexpr double kInside = 1.0 - 1e-12;

double ratio(double cap, double value) noexcept {
    return value > 0.0 ? cap / value : std::numeric_limits<double>::infinity();
}

} // namespace

double capRatio(const SafetyToolLimits& limits, const core::DeviceSample& sample,
                const core::Wrench& wrench_W, double load_N) noexcept {
    double result = std::numeric_limits<double>::infinity();
    if (limits.forceCap_N > 0.0) {
        result = std::min(result, ratio(limits.forceCap_N, std::max(wrench_W.force.norm(), load_N)));
    }
    if (limits.torqueCap_Nm > 0.0) {
        result = std::min(result, ratio(limits.torqueCap_Nm, wrench_W.torque.norm()));
    }
    if (result == std::numeric_limits<double>::infinity()) {
        return result; // nothing to render
    }
    const auto efforts = limits.kinematics->efforts(sample, limits.map.wrenchToD(wrench_W));
    for (int axis = 0; axis < limits.axes; ++axis) {
        const auto i = static_cast<std::size_t>(axis);
        if (limits.axisCap[i] <= 0.0) {
            continue;
        }
        const double effort = std::abs(efforts[i]);
        if (!std::isfinite(effort)) {
            return 0.0;
        }
        result = std::min(result, ratio(limits.axisCap[i], effort));
    }
    return std::isnan(result) ? 0.0 : result;
}

bool applyCaps(const SafetyToolLimits& limits, const core::DeviceSample& sample, core::Wrench& wrench_W,
               double load_N, double knee) noexcept {
    const double room = capRatio(limits, sample, wrench_W, load_N);
    if (room * (1.0 - knee) >= 1.0) {
        return false;
    }
    const double scale = (knee > 0.0 && room > 0.0 ? room * bentToCap(1.0 / room, knee) : room) * kInside;
    wrench_W.force *= scale;
    wrench_W.torque *= scale;
    return true;
}

} // namespace chiron::haptics
