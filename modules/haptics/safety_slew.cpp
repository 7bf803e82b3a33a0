// SPDX-License-Identifier: GPL-3.0-or-later
#include "haptics/safety_slew.h"

#include <algorithm>

namespace chiron::haptics {

core::Vec3 limitSlew(const core::Vec3& last, const core::Vec3& target, double step, bool& limited) noexcept {
    const double length2 = last.squaredNorm();
    const double share = length2 > 0.0 ? std::clamp(target.dot(last) / length2, 0.0, 1.0) : 0.0;
    const core::Vec3 free = share * last;
    const core::Vec3 change = target - free;
    const double distance = change.norm();
    if (distance <= step) {
        return target;
    }
    limited = true;
    return free + (step / distance) * change;
}

} // namespace chiron::haptics
