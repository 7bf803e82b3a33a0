// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "simulation/objects/object_contact.h"

#include <algorithm>

namespace chiron::simulation {

/// Limits how fast the felt contact may change where its geometry jumps or turns faster than the tool moves:
/// where a mesh's sheet is left for another one, a surface folds or moves under the tool, or another floor
/// suddenly becomes the deeper one.
///
/// Let s = d n be the vector from the tool out to the surface, and w the distance that the tool has moved
/// since the previous tick:
///   ‖s(t) − s(t−1)‖ ≤ g w + c
/// An elastic force k s therefore changes by at most k (g w + c) per tick, whatever the geometry does. A tool
/// that is found deep behind a sheet through which it did not enter is pushed only by the depth that it gains
/// from there:
///   d' = d − o,  o = d − ‖s(t−1)‖ − (g w + c) ≥ 0 when the sheet is found; never more than d later
/// It therefore feels no sudden force, can leave freely, and meets the sheet itself once it has been outside.
/// A tool that is seen for the first time, or has jumped, is taken as it is, because force is armed anew when
/// an object appears (models.md §5). Use one instance for each pair of tool and body. Fixed size.
/// Thread: haptic.
class FeltPlace {
public:
    /// In one tick; a larger step is not a motion (models.md §5).
    static constexpr double kTeleport_m = 0.020;
    /// c: 0.03 N at 600 N/m; a lag of 2 mm is made up within a twentieth of a second (assumption).
    static constexpr double kCatchUp_m = 5e-5;

    /// Returns the contact as it is felt. `p` is the tool's position (m) in the frame of `place`. `found`:
    /// the tool did not touch this sheet in the previous tick. `perWay` = g ≥ 1: how much faster than the
    /// tool s may change (1 on a plane).
    ContactPlace step(ContactPlace place, const core::Vec3& p, bool found, double perWay = 1.0) noexcept {
        const double moved = (p - m_p).norm();
        const bool known = m_known && !(moved > kTeleport_m);
        m_p = p;
        m_known = true;
        m_geometric_m = place.depth_m;
        if (!known) {
            m_left_m = 0.0;
        } else {
            const double most = perWay * moved + kCatchUp_m;
            if (found || !m_wasIn)
                m_left_m = place.depth_m - m_out.norm() - most;
            m_left_m = std::clamp(m_left_m, 0.0, std::max(0.0, place.depth_m));
            place.depth_m -= m_left_m;
            keepUp(place, most);
        }
        m_wasIn = m_geometric_m > 0.0;
        m_out =
            place.depth_m > 0.0 ? core::Vec3(place.depth_m * place.normal) : core::Vec3(core::Vec3::Zero());
        m_felt_m = place.depth_m;
        return place;
    }

    double geometric_m() const noexcept { return m_geometric_m; } ///< signed depth according to the geometry
    double felt_m() const noexcept { return m_felt_m; }           ///< depth as it is felt
    /// How much less than the geometric depth is felt (negative: more is felt, where the surface receded
    /// faster than s may change). Needed to report the tool's position to others as it is felt.
    double less_m() const noexcept { return m_felt_m > 0.0 ? m_geometric_m - m_felt_m : 0.0; }
    void reset() noexcept { *this = FeltPlace(); }

private:
    void keepUp(ContactPlace& place, double most_m) const noexcept {
        const core::Vec3 wanted =
            place.depth_m > 0.0 ? core::Vec3(place.depth_m * place.normal) : core::Vec3(core::Vec3::Zero());
        const core::Vec3 change = wanted - m_out;
        const double length2 = change.squaredNorm();
        if (!(length2 > most_m * most_m))
            return;
        const core::Vec3 out = m_out + change * (most_m / std::sqrt(length2));
        const double depth_m = out.norm();
        if (!(depth_m > 0.0))
            return;
        place.depth_m = depth_m;
        place.normal = out / depth_m;
        place.depthGradient = -place.normal;
    }

    core::Vec3 m_p = core::Vec3::Zero();
    core::Vec3 m_out = core::Vec3::Zero(); ///< s as it was felt in the previous tick
    double m_geometric_m = -1.0;
    double m_felt_m = -1.0;
    double m_left_m = 0.0; ///< o
    bool m_known = false;
    bool m_wasIn = false;
};

} // namespace chiron::simulation
