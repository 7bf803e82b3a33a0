// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"
#include "core/units.h"

namespace chiron::scene3d {

/// Angle of the laparoscope above the plane.
inline constexpr double kCameraElevation_rad = 44.0 * core::kPi / 180.0;

/// The fixed view of a laparoscope held over the near edge of the field: it looks from −y and from above, at
/// the elevation angle.
struct CameraFit {
    core::Vec3 p_WEye = core::Vec3::Zero();    ///< m
    core::Vec3 p_WTarget = core::Vec3::Zero(); ///< m
    double fieldOfView_deg = 30.0;             ///< vertical
};

/// Returns the nearest position on that line of sight from which the whole workspace is visible: the disc of
/// `radius_m` on the plane and the space above it up to `room_m`. `aspect` = width/height of the picture, >
/// 0. `rightMargin` is the share of the width that the force bar takes; the caller moves the centre of the
/// picture to the left by half of it. Pure.
CameraFit fitCamera(double radius_m, double planeHeight_m, double room_m, double aspect, double rightMargin,
                    double elevation_rad = kCameraElevation_rad);

} // namespace chiron::scene3d
