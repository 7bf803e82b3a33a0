// SPDX-License-Identifier: GPL-3.0-or-later
// Used for set-up. A failure allocates a text, so this is kept apart from the code that the tick calls.
#include "mechanisms/gimbal_kinematics.h"

#include <cmath>
#include <string>

namespace chiron::mechanisms {

core::Result<GimbalCoordinates> GimbalKinematics::inverse(const core::Vec3& p_DT, double roll_rad) const {
    const core::Vec3 t_V = directionToVendor(p_DT - core::Vec3(0.0, 0.0, m_pivotHeight_m));
    const double depth = t_V.norm();
    if (!(depth > 1e-3) || !(t_V.z() > 0.0))
        return core::fail(core::ErrorCode::badInput, "gimbal: tip at height " + std::to_string(p_DT.z()) +
                                                         " m, expected below the pivot at " +
                                                         std::to_string(m_pivotHeight_m) +
                                                         " m and at least 1 mm from it");
    return GimbalCoordinates{std::atan2(t_V.x(), t_V.z()), std::atan2(t_V.y(), std::hypot(t_V.x(), t_V.z())),
                             roll_rad, depth};
}

} // namespace chiron::mechanisms
