// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry.h"

#include <cmath>

namespace chiron::simulation {

/// The frame of a contact (P3; models.md §3): z = S_n, x = the fibres' direction projected on the contact
/// plane, y = z × x.
struct ContactFrame {
    core::Vec3 x{1.0, 0.0, 0.0};
    core::Vec3 y{0.0, 1.0, 0.0};
    core::Vec3 z{0.0, 0.0, 1.0};

    /// `normal` is a unit vector; `fibre` may have any length. A fibre within 0.06° of the normal has no
    /// direction in the plane; the axis of W that lies flattest in the plane then replaces it.
    static ContactFrame on(const core::Vec3& normal, const core::Vec3& fibre) noexcept {
        core::Vec3 x = fibre - normal * normal.dot(fibre);
        double length2 = x.squaredNorm();
        if (!(length2 > 1e-6 * fibre.squaredNorm())) {
            Eigen::Index flattest = 0;
            normal.cwiseAbs().minCoeff(&flattest);
            x = core::Vec3::Unit(flattest) - normal * normal[flattest];
            length2 = x.squaredNorm();
        }
        x *= 1.0 / std::sqrt(length2);
        return {x, normal.cross(x), normal};
    }
    core::Vec3 to(const core::Vec3& v_W) const noexcept { return {x.dot(v_W), y.dot(v_W), z.dot(v_W)}; }
    core::Vec3 from(const core::Vec3& v) const noexcept { return v.x() * x + v.y() * y + v.z() * z; }
};

/// P3's eq. 1 in the contact frame, F = K d + B v with diagonal K and B. `d_m` points from the tool to its
/// contact point (z = depth), and `v_m_per_s` is the rate at which d grows. The normal part never pulls.
/// Pure.
/// Unit: N.
inline core::Vec3 voigtForce(const core::Vec3& stiffness_N_per_m, const core::Vec3& d_m,
                             const core::Vec3& damping_Ns_per_m, const core::Vec3& v_m_per_s) noexcept {
    core::Vec3 f = stiffness_N_per_m.cwiseProduct(d_m) + damping_Ns_per_m.cwiseProduct(v_m_per_s);
    f.z() = f.z() > 0.0 ? f.z() : 0.0;
    return f;
}

} // namespace chiron::simulation
