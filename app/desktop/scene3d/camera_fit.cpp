// SPDX-License-Identifier: GPL-3.0-or-later
#include "desktop/scene3d/camera_fit.h"

#include <algorithm>
#include <cmath>

namespace chiron::scene3d {

namespace {

constexpr double kEdge = 0.97; // share of half the picture

/// Tangents of the half-angles of the picture.
struct Opening {
    double side;
    double up;
};

bool sees(const CameraFit& camera, const Opening& opening, const core::Vec3& p_W) {
    const core::Vec3 ahead = (camera.p_WTarget - camera.p_WEye).normalized();
    const core::Vec3 right = ahead.cross(core::Vec3::UnitZ()).normalized();
    const core::Vec3 up = right.cross(ahead);
    const core::Vec3 seen = p_W - camera.p_WEye;
    const double depth = seen.dot(ahead);
    if (depth <= 0.02)
        return false;
    const double x = seen.dot(right) / depth;
    const double y = seen.dot(up) / depth;
    return std::abs(x) <= opening.side && std::abs(y) <= opening.up;
}

bool seesAll(const CameraFit& camera, const Opening& opening, double radius_m, double planeHeight_m,
             double room_m) {
    for (int i = 0; i < 36; ++i) {
        const double angle = 2.0 * core::kPi * i / 36;
        const core::Vec3 edge(radius_m * std::cos(angle), radius_m * std::sin(angle), planeHeight_m);
        const core::Vec3 above(0.6 * edge.x(), 0.6 * edge.y(), planeHeight_m + room_m);
        if (!sees(camera, opening, edge) || !sees(camera, opening, above))
            return false;
    }
    return true;
}

} // namespace

CameraFit fitCamera(double radius_m, double planeHeight_m, double room_m, double aspect, double rightMargin,
                    double elevation_rad) {
    CameraFit camera;
    camera.p_WTarget = core::Vec3(0.0, -0.04 * radius_m, planeHeight_m + 0.16 * room_m);
    const core::Vec3 back(0.0, -std::cos(elevation_rad), std::sin(elevation_rad));
    const double up = std::tan(0.5 * camera.fieldOfView_deg * core::kPi / 180.0);
    const double side = up * std::max(0.2, aspect);
    const Opening opening{kEdge * side * (1.0 - rightMargin), kEdge * up};
    double near = radius_m;
    double far = 40.0 * radius_m;
    for (int i = 0; i < 40; ++i) {
        const double middle = 0.5 * (near + far);
        camera.p_WEye = camera.p_WTarget + middle * back;
        (seesAll(camera, opening, radius_m, planeHeight_m, room_m) ? far : near) = middle;
    }
    camera.p_WEye = camera.p_WTarget + far * back;
    return camera;
}

} // namespace chiron::scene3d
