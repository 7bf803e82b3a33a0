// SPDX-License-Identifier: GPL-3.0-or-later
// Functions that can fail and state the reason: not for the tick.
#include "mechanisms/fingertip_kinematics.h"

#include <Eigen/LU>

#include <cmath>
#include <string>

namespace chiron::mechanisms {

namespace {
constexpr double kSlack = 1e-9; ///< a limit itself counts as inside, despite rounding in a round trip

auto refuse(const std::string& what) {
    return core::fail(core::ErrorCode::badInput, "fingertip platform: " + what);
}

core::Result<void> checked(const FingertipGeometry& g, const FingertipPose& pose, const FingertipLoop& loop) {
    if (!(std::abs(pose.pitch_rad) <= g.maximumPitch_rad + kSlack))
        return refuse("a pitch of " + std::to_string(core::degFromRad(pose.pitch_rad)) + "°; at most " +
                      std::to_string(core::degFromRad(g.maximumPitch_rad)));
    if (!(std::abs(pose.roll_rad) <= g.maximumRoll_rad + kSlack))
        return refuse("a roll of " + std::to_string(core::degFromRad(pose.roll_rad)) + "°; at most " +
                      std::to_string(core::degFromRad(g.maximumRoll_rad)));
    if (!(pose.z_m >= g.minimumZ_m - kSlack && pose.z_m <= g.maximumZ_m + kSlack))
        return refuse("a height of " + std::to_string(1e3 * pose.z_m) + " mm is outside its travel");
    if (!loop.reached)
        return refuse("a leg does not reach");
    const double r = g.platformRadius_m;
    if (!(std::abs(loop.jacobian.determinant()) > FingertipKinematics::kLeastDeterminant * r * r))
        return refuse("the pose is singular");
    return {};
}
} // namespace

core::Result<core::Vec3> FingertipKinematics::inverse(const FingertipPose& pose) const {
    const FingertipLoop at = loop(pose);
    CHIRON_TRY(checked(m_geometry, pose, at));
    return at.drives;
}

core::Result<FingertipPose> FingertipKinematics::forward(const core::Vec3& drives) const {
    FingertipPose pose;
    pose.z_m = drives.mean() - loop({}).drives.mean();
    if (!drives.allFinite() || !forward(drives, pose))
        return refuse("no pose of the platform has these drives");
    CHIRON_TRY(checked(m_geometry, pose, loop(pose)));
    return pose;
}

} // namespace chiron::mechanisms
