// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/exercises/urethra_insertion/scene/overview_fit.h"

#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace chiron::scene3d {

namespace {

constexpr double kShown_m = 0.030; // length of the shaft shown before the entrance
constexpr double kEdge = 0.95;     // usable fraction of half the picture

/// The points that must be visible.
/// Frame: W.
std::vector<core::Vec3> corners(const UrethraDrawing& drawing) {
    const simulation::UrethraInsertionParameters& p = drawing.parameters();
    std::vector<core::Vec3> points{p.pose.pointToW({0.0, 0.0, -kShown_m})};
    const double wide = 2.0 * p.endoscope.radius_m;
    for (int i = 0; i <= 10; ++i) {
        const simulation::CentrelinePoint at = drawing.centreline().atZ(p.anatomy.zEnd_m * i / 10.0);
        points.push_back(p.pose.pointToW(at.p_A + wide * at.n_A));
        points.push_back(p.pose.pointToW(at.p_A - wide * at.n_A));
    }
    for (int i = 0; i < 26; ++i) {
        const double polar = core::kPi * (i / 5) / 5.0;
        points.push_back(p.pose.pointToW(drawing.bladderWall_A(polar, 2.0 * core::kPi * (i % 5) / 5.0)));
        points.push_back(p.pose.pointToW(drawing.bladderWall_A(polar, 0.5 * core::kPi * (i % 4))));
    }
    return points;
}

/// The midpoint between the extreme points along this axis, on the axis through W's origin.
core::Vec3 middleAlong(const std::vector<core::Vec3>& points, const core::Vec3& axis) {
    double low = 1e9, high = -1e9;
    for (const core::Vec3& q : points) {
        low = std::min(low, q.dot(axis));
        high = std::max(high, q.dot(axis));
    }
    return 0.5 * (low + high) * axis;
}

} // namespace

OverviewFit fitOverview(const UrethraDrawing& drawing, double aspect) {
    const simulation::UrethraInsertionParameters& p = drawing.parameters();
    const std::vector<core::Vec3> points = corners(drawing);
    OverviewFit fit;
    // From the side of −x_A (the patient's side at +x_W in the usual pose), slightly from the trainee's side
    // and from above.
    const core::Vec3 back = p.pose.vectorToW(core::Vec3(-1.0, 0.26, -0.22).normalized());
    fit.up_W = p.pose.vectorToW(core::Vec3::UnitY());
    const core::Vec3 right = fit.up_W.cross(back).normalized();
    const core::Vec3 up = back.cross(right);
    const double tangent = kEdge * std::tan(0.5 * fit.fieldOfView_deg * core::kPi / 180.0);
    core::Vec3 middle = middleAlong(points, right) + middleAlong(points, up);
    double distance = 0.05;
    // The second pass uses the picture's middle after the shift by perspective.
    for (int pass = 0; pass < 2; ++pass) {
        double left = 1e9, rightmost = -1e9, bottom = 1e9, top = -1e9;
        distance = 0.05;
        for (const core::Vec3& q : points) {
            const core::Vec3 from = q - middle;
            const double toward = from.dot(back);
            distance = std::max({distance, toward + std::abs(from.dot(up)) / tangent,
                                 toward + std::abs(from.dot(right)) / (tangent * std::max(0.1, aspect))});
        }
        for (const core::Vec3& q : points) {
            const core::Vec3 from = q - middle;
            const double depth = distance - from.dot(back);
            left = std::min(left, from.dot(right) / depth);
            rightmost = std::max(rightmost, from.dot(right) / depth);
            bottom = std::min(bottom, from.dot(up) / depth);
            top = std::max(top, from.dot(up) / depth);
        }
        if (pass == 0)
            middle += 0.5 * distance * ((left + rightmost) * right + (bottom + top) * up);
    }
    fit.p_WTarget = middle;
    fit.p_WEye = middle + distance * back;
    return fit;
}

} // namespace chiron::scene3d
