// SPDX-License-Identifier: GPL-3.0-or-later
#include "devices/drivers/keyboard_mouse/pointer_setup.h"

#include <cmath>

namespace chiron::devices {

core::Result<void> checkPointer(const std::string& driver, const PseudoHaptics& pseudoHaptics,
                                double following_s) {
    const auto refuse = [&](const char* name, double value, const char* expected) {
        return core::fail(core::ErrorCode::badInput,
                          driver + ": " + name + " is " + std::to_string(value) + ", expected " + expected);
    };
    if (!(pseudoHaptics.slowestRatio > 0.0 && pseudoHaptics.slowestRatio <= 1.0))
        return refuse("slowestRatio", pseudoHaptics.slowestRatio, "0 < r <= 1");
    if (!(pseudoHaptics.slowestAt_N > 0.0 && pseudoHaptics.slowestAt_N <= 100.0))
        return refuse("slowestAt_N", pseudoHaptics.slowestAt_N, "0 < F <= 100 N");
    if (!(following_s >= 0.0 && following_s <= 0.2))
        return refuse("following_s", following_s, "0 to 0.2 s");
    return {};
}

double followingShare(double following_s) {
    return following_s > 0.0 ? 1.0 - std::exp(-core::kTickSeconds / following_s) : 1.0;
}

} // namespace chiron::devices
