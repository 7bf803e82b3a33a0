// SPDX-License-Identifier: GPL-3.0-or-later
// Used for set-up. A failure allocates a text, so this is kept apart from the code that the tick calls.
#include "mechanisms/five_bar_kinematics.h"

#include "core/units.h"

#include <cmath>
#include <string>

namespace chiron::mechanisms {

core::Result<std::array<double, 2>> FiveBarKinematics::inverse(const core::Vec3& p_DT) const {
    const FiveBarGeometry& g = m_geometry;
    const auto refuse = [&](const char* why) {
        return core::fail(core::ErrorCode::badInput, "five-bar linkage: tip at y " +
                                                         std::to_string(p_DT.y()) + " m, z " +
                                                         std::to_string(p_DT.z()) + " m: " + why);
    };
    std::array<double, 2> theta{};
    for (std::size_t i = 0; i < 2; ++i) {
        const core::Vec2 base(g.baseForward_m + (i == 0 ? -g.halfBase_m : g.halfBase_m), g.baseUp_m);
        const core::Vec2 reach = toPlane(p_DT) - base;
        const double distance = reach.norm();
        const double cosine = (g.proximal_m * g.proximal_m + distance * distance - g.distal_m * g.distal_m) /
                              (2.0 * g.proximal_m * distance);
        if (!(std::abs(cosine) < 1.0))
            return refuse("out of reach");
        // Elbows point outwards: leg 1 towards the trainee, leg 2 away from them.
        theta[i] = std::atan2(reach.y(), reach.x()) + (i == 0 ? 1.0 : -1.0) * std::acos(cosine);
    }
    theta[0] += theta[0] < 0.0 ? 2.0 * core::kPi : 0.0;
    theta[1] += theta[1] < -core::kPi ? 2.0 * core::kPi : 0.0;
    const FiveBarLoop made = loop(theta[0], theta[1]);
    if (!made.closed || !((made.tip - toPlane(p_DT)).norm() < 1e-9) ||
        !(made.elbow[0].x() < made.elbow[1].x()))
        return refuse("only with its legs crossed or hanging, which is another assembly mode");
    return theta;
}

} // namespace chiron::mechanisms
