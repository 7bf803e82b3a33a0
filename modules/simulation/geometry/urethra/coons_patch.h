// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/geometry/urethra/cubic_bezier.h"

namespace chiron::simulation {

/// A point of a patch with its derivatives.
struct PatchPoint {
    core::Vec3 p_A = core::Vec3::Zero();
    core::Vec3 du_A = core::Vec3::Zero(); ///< ∂p/∂u, along the canal
    core::Vec3 dv_A = core::Vec3::Zero(); ///< ∂p/∂v, around it
};

/// Bilinearly blended Coons patch (models.md §1.1) between four Bézier segments that share their corners:
/// p = (1−v) low(u) + v high(u) + (1−u) first(v) + u last(v) − bilinear blend of the corners. Pure.
struct CoonsPatch {
    CubicBezier low;   ///< along, at v = 0
    CubicBezier high;  ///< along, at v = 1
    CubicBezier first; ///< around, at u = 0
    CubicBezier last;  ///< around, at u = 1

    PatchPoint at(double u, double v) const noexcept {
        const core::Vec3& p00 = first.control[0];
        const core::Vec3& p01 = first.control[3];
        const core::Vec3& p10 = last.control[0];
        const core::Vec3& p11 = last.control[3];
        PatchPoint point;
        point.p_A = (1.0 - v) * low.at(u) + v * high.at(u) + (1.0 - u) * first.at(v) + u * last.at(v) -
                    (1.0 - u) * ((1.0 - v) * p00 + v * p01) - u * ((1.0 - v) * p10 + v * p11);
        point.du_A = (1.0 - v) * low.slope(u) + v * high.slope(u) + last.at(v) - first.at(v) -
                     (1.0 - v) * (p10 - p00) - v * (p11 - p01);
        point.dv_A = high.at(u) - low.at(u) + (1.0 - u) * first.slope(v) + u * last.slope(v) -
                     (1.0 - u) * (p01 - p00) - u * (p11 - p10);
        return point;
    }
};

} // namespace chiron::simulation
